// SPDX-License-Identifier: Apache-2.0
#include "declaration.hpp"
#include "ideotype/core/units.hpp"

namespace ideotype {

namespace {

using Values = std::vector<Estimate>;

constexpr double grams_of_co2 = 44.0095;
//! Tonnes of carbohydrate per hectare for each mol of carbon per square metre.
constexpr double tonnes = 30e-6 * 1e4;

//! Returns gross assimilation lowered by a loss, times a scale.
Randomised carbon(const CanopyReport& report, Loss loss = no_loss,
                  double scale = 1) {
    return scaled(assimilation_of_all(*report.assimilation, loss), scale);
}

Randomised net(const CanopyReport& report, double scale = 1) {
    return carbon(report, loss_in_light, scale);
}

Randomised balance(const CanopyReport& report, double scale = 1) {
    return carbon(report, loss_of_carbon, scale);
}

std::vector<Randomised> gross_of_groups(const CanopyReport& report) {
    return along(report.assimilation->gross.tallies,
                 report.assimilation->gross.groups, &FluxTally::groups);
}

//! Returns the assimilation of each leaf less its respiration in the light.
std::vector<Randomised> net_by_leaf(const CanopyReport& report) {
    const AssimilationReport& all = *report.assimilation;
    std::vector<Randomised> groups = gross_of_groups(report);
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const auto losses = mapped(all.losses_by_randomisation,
                                   [&](const auto& each) { return each[g]; });
        groups[g] =
            lowered(groups[g].estimate, std::move(groups[g].by_randomisation),
                    all.losses[g], losses, loss_in_light);
    }
    return of_leaves(report, groups);
}

//! Returns gross assimilation over absorbed light, with errors to first order.
Randomised light_use(const CanopyReport& report) {
    const AssimilationReport& all = *report.assimilation;
    const double light =
        report.par().light.day.leaves.mean / joule_per_megajoule;
    if (!(light > 0)) return certain(report, 0);
    const double ratio = grams_of_carbon * all.gross.sum.mean / light;
    return ratio_with_error(
        ratio, light, all.gross.tallies.size(), [&](std::size_t r) {
            return grams_of_carbon * all.gross.tallies[r].sum() -
                   ratio * report.par().budget_by_randomisation[r].leaves /
                       joule_per_megajoule;
        });
}

Randomised after_silking(const CanopyReport& report) {
    const std::vector<double>& values = report.assimilation->late_net;
    return {estimate(values), values};
}

std::optional<Randomised> sunlit_lai(const CanopyReport& report) {
    if (!report.hit_by_sun) return std::nullopt;
    return scaled(Randomised{report.hit_by_sun->mean,
                             report.hit_by_sun->mean_by_randomisation},
                  report.assimilating_lai);
}

}  // namespace

Randomised assimilation_of_all(const AssimilationReport& report, Loss loss) {
    return lowered(report.gross.sum,
                   mapped(report.gross.tallies, &FluxTally::sum),
                   sum_of(report.losses),
                   mapped(report.losses_by_randomisation, sum_of), loss);
}

std::vector<Declaration> assimilation_quantities() {
    using Report = CanopyReport;
    return {
        {{"gross_assimilation", rate,
          "CO2 that leaves take up per ground area"},
         MeanOver::nothing,
         [](const Report& r) { return carbon(r); }},
        {{"net_assimilation", rate,
          "gross assimilation less the respiration of leaves while there is "
          "light"},
         MeanOver::nothing,
         [](const Report& r) { return net(r); }},
        {{"net_assimilation_per_leaf_area", rate,
          "net assimilation per one-sided leaf area"},
         MeanOver::leaf_area,
         [](const Report& r) { return per_leaf_area(r, net(r)); }},
        {{"carbon_balance", rate,
          "gross assimilation less the respiration of leaves by day and night "
          "and the carbon that builds them"},
         MeanOver::nothing,
         [](const Report& r) { return balance(r); }},
        {{"gross_co2", "g m-2 day-1", "gross assimilation"},
         MeanOver::nothing,
         [](const Report& r) { return carbon(r, no_loss, grams_of_co2); }},
        {{"net_co2", "g m-2 day-1", "net assimilation"},
         MeanOver::nothing,
         [](const Report& r) { return net(r, grams_of_co2); }},
        {{"dry_matter", "t ha-1", "carbon balance of all days as carbohydrate"},
         MeanOver::nothing,
         [](const Report& r) { return balance(r, tonnes * r.days); }},
        {exact({"respiration", rate, "respiration of leaves by day and night"}),
         MeanOver::nothing,
         [](const Report& r) {
             const CarbonLoss sum = sum_of(r.assimilation->losses);
             return certain(r, sum.in_light + sum.at_night);
         }},
        {{"carbon_after_silking", rate,
          "gross assimilation after silking less what leaves respire then, day "
          "and night, over the days of the season"},
         MeanOver::nothing,
         after_silking,
         [](const Scope& scope) { return scope.grows; }},
        {{"sunlit_lai", "m2 m-2",
          "leaf area index that the sun shines on, mean over the time with "
          "light"},
         MeanOver::time,
         sunlit_lai},
        {by({"hour"},
            {"sunlit_lai_by_hour", "m2 m-2",
             "leaf area index that the sun shines on at each instant"}),
         MeanOver::time,
         [](const Report& r) {
             Values hours = r.hit_by_sun->hours;
             for (Estimate& x : hours) x = scaled(x, r.assimilating_lai);
             return hours;
         }},
        {{"light_use_efficiency", "g MJ-1",
          "carbon of gross assimilation over absorbed PAR"},
         MeanOver::absorbed_light,
         light_use},
        {by({"leaf"},
            {"assimilation_by_leaf", rate, "gross assimilation of each leaf"}),
         MeanOver::nothing,
         [](const Report& r) { return of_leaves(r, gross_of_groups(r)); }},
        {by({"leaf"}, {"net_assimilation_by_leaf", rate,
                       "net assimilation of each leaf"}),
         MeanOver::nothing, net_by_leaf},
        {by({"layer"}, {"assimilation_by_layer", rate,
                        "gross assimilation of leaves in each layer"}),
         MeanOver::nothing,
         [](const Report& r) {
             return along(r.assimilation->gross.tallies,
                          r.assimilation->gross.layers, &FluxTally::layers);
         }},
        {by({"hour"}, {"assimilation_by_hour", "umol m-2 s-1",
                       "gross assimilation at each instant"}),
         MeanOver::time,
         [](const Report& r) { return r.assimilation->gross.hours; }},
        {by({"day"},
            {"assimilation_by_day", rate, "gross assimilation on each day"}),
         MeanOver::nothing,
         [](const Report& r) { return r.assimilation->gross.dates; }},
    };
}

}  // namespace ideotype
