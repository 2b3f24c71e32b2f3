// SPDX-License-Identifier: Apache-2.0
#include "declaration.hpp"
#include "ideotype/core/units.hpp"
#include "randomised.hpp"

namespace ideotype {

namespace {

using Values = std::vector<Estimate>;

constexpr double grams_of_co2 = 44.0095;
//! Tonnes of dry matter per hectare for 1 mol of carbon per square metre.
constexpr double tonnes = 10 * dry_matter_per_carbon;

//! Returns assimilation minus a loss, multiplied by a scale.
Randomised carbon(const CanopyReport& report, Loss loss = Loss::none,
                  double scale = 1) {
    return scaled(assimilation_of_all(*report.assimilation, loss), scale);
}

Randomised net(const CanopyReport& report, double scale = 1) {
    return carbon(report, Loss::in_light, scale);
}

Randomised balance(const CanopyReport& report) {
    return carbon(report, Loss::all);
}

std::vector<Randomised> gross_of_groups(const CanopyReport& report) {
    return along(report.assimilation->gross.tallies,
                 report.assimilation->gross.groups, &FluxTally::groups);
}

//! Returns the assimilation of each leaf minus its respiration in light.
std::vector<Randomised> net_by_leaf(const CanopyReport& report) {
    const AssimilationReport& all = *report.assimilation;
    const FluxReport& flux = flux_before(all, Loss::in_light);
    std::vector<Randomised> groups =
        along(flux.tallies, flux.groups, &FluxTally::groups);
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const auto losses = mapped(all.losses_by_randomisation,
                                   [&](const auto& each) { return each[g]; });
        groups[g] =
            lowered(groups[g].estimate, std::move(groups[g].by_randomisation),
                    all.losses[g], losses, Loss::in_light);
    }
    return of_leaves(report, groups);
}

//! Returns the assimilation of leaves divided by the light they absorb, with
//! errors to first order.
Randomised light_use(const CanopyReport& report) {
    const AssimilationReport& all = *report.assimilation;
    const auto of_leaves = [&](const FluxTally& tally) {
        return over_groups(report, tally.groups,
                           [](const SurfaceId& id) { return id.is_leaf(); });
    };
    const double gross = estimate(mapped(all.gross.tallies, of_leaves)).mean;
    const double light =
        report.par().light.day.leaves.mean / joule_per_megajoule;
    if (!(light > 0)) return certain(report, 0);
    const double ratio = grams_of_carbon * gross / light;
    return ratio_with_error(
        ratio, light, all.gross.tallies.size(), [&](std::size_t r) {
            return grams_of_carbon * of_leaves(all.gross.tallies[r]) -
                   ratio * report.par().budget_by_randomisation[r].leaves /
                       joule_per_megajoule;
        });
}

//! Returns the respiration of leaves by day and night. It varies between fields
//! with leaf area, and with leaf temperature if that is computed.
Randomised respired(const CanopyReport& report) {
    const AssimilationReport& all = *report.assimilation;
    const auto respiration = [](const std::vector<CarbonLoss>& losses) {
        return sum_of(losses).respired();
    };
    Randomised result = certain(report, respiration(all.losses));
    if (!all.uptake && all.losses_by_randomisation.empty()) return result;
    for (std::size_t r = 0; r < result.by_randomisation.size(); ++r) {
        result.by_randomisation[r] = respiration(all.losses_in(r));
        if (all.uptake)
            result.by_randomisation[r] +=
                all.gross.tallies[r].sum() - all.uptake->tallies[r].sum();
    }
    if (all.uptake)
        result.estimate.mean += all.gross.sum.mean - all.uptake->sum.mean;
    result.estimate.standard_error =
        estimate(result.by_randomisation).standard_error;
    return result;
}

//! Returns values of all leaves together and of each other organ, component by
//! component, from values of groups.
Values by_organ(const CanopyReport& report, const auto& sum_of_groups) {
    Values organs;
    for (std::uint32_t c = 0; c < report.components.size(); ++c) {
        std::vector<std::size_t> leaves;
        for (std::size_t g = 0; g < report.groups.size(); ++g)
            if (report.groups[g].id.component == c &&
                report.groups[g].id.is_leaf())
                leaves.push_back(g);
        organs.push_back(sum_of_groups(leaves));
        for (std::size_t g = 0; g < report.groups.size(); ++g)
            if (report.groups[g].id.component == c &&
                !report.groups[g].id.is_leaf())
                organs.push_back(sum_of_groups(std::vector{g}));
    }
    return organs;
}

Values gross_by_organ(const CanopyReport& report) {
    const std::vector<FluxTally>& tallies = report.assimilation->gross.tallies;
    return by_organ(report, [&](const std::vector<std::size_t>& groups) {
        return estimate(mapped(tallies, [&](const FluxTally& tally) {
            double sum = 0;
            for (const std::size_t g : groups) sum += tally.groups[g];
            return sum;
        }));
    });
}

Values loss_by_organ(const CanopyReport& report) {
    const AssimilationReport& all = *report.assimilation;
    return by_organ(report, [&](const std::vector<std::size_t>& groups) {
        const auto of = [&](const std::vector<CarbonLoss>& losses) {
            double sum = 0;
            for (const std::size_t g : groups) sum += losses[g].all();
            return sum;
        };
        Estimate loss{of(all.losses), 0};
        if (!all.losses_by_randomisation.empty())
            loss.standard_error =
                estimate(mapped(all.losses_by_randomisation, of))
                    .standard_error;
        return loss;
    });
}

Values dry_mass_by_organ(const CanopyReport& report) {
    const std::vector<double>& mass = report.assimilation->dry_mass;
    return by_organ(report, [&](const std::vector<std::size_t>& groups) {
        constexpr double tonnes_per_hectare = 10;  // from kg m-2
        double sum = 0;
        for (const std::size_t g : groups) sum += mass[g];
        return Estimate{tonnes_per_hectare * sum, 0};
    });
}

bool has_living_organs(const Scope& scope) {
    return scope.has_living_organs;
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
    const FluxReport& flux = flux_before(report, loss);
    return lowered(flux.sum, mapped(flux.tallies, &FluxTally::sum),
                   sum_of(report.losses),
                   mapped(report.losses_by_randomisation, sum_of), loss);
}

std::vector<Declaration> assimilation_quantities() {
    using Report = CanopyReport;
    return {
        {{"gross_assimilation", rate,
          "CO2 that leaves and green organs take up per ground area"},
         MeanOver::nothing,
         [](const Report& r) { return carbon(r); }},
        {{"net_assimilation", rate,
          "gross assimilation less respiration while there is light"},
         MeanOver::nothing,
         [](const Report& r) { return net(r); }},
        {{"net_assimilation_per_leaf_area", rate,
          "net assimilation per one-sided leaf area"},
         MeanOver::leaf_area,
         [](const Report& r) { return per_leaf_area(r, net(r)); }},
        {{"carbon_balance", rate,
          "gross assimilation less respiration by day and night and the carbon "
          "that builds leaves and other organs"},
         MeanOver::nothing,
         [](const Report& r) { return balance(r); }},
        {{"gross_co2", "g m-2 day-1", "gross assimilation"},
         MeanOver::nothing,
         [](const Report& r) { return carbon(r, Loss::none, grams_of_co2); }},
        {{"net_co2", "g m-2 day-1", "net assimilation"},
         MeanOver::nothing,
         [](const Report& r) { return net(r, grams_of_co2); }},
        {{"dry_matter", "t ha-1",
          "growth of all organs on all days: gross assimilation less all "
          "respiration, times 20.1 g of dry matter per mol"},
         MeanOver::nothing,
         [](const Report& r) {
             return carbon(r, Loss::respiration, tonnes * r.days);
         }},
        {{"respiration", rate,
          "respiration of leaves and other organs by day and night"},
         MeanOver::nothing,
         respired},
        {{"carbon_after_silking", rate,
          "gross assimilation less respiration after silking, day and night, "
          "over the days of the season"},
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
          "carbon of the gross assimilation of leaves over the PAR that they "
          "absorb"},
         MeanOver::absorbed_light,
         light_use},
        {by({"leaf"},
            {"assimilation_by_leaf", rate, "gross assimilation of each leaf"}),
         MeanOver::nothing,
         [](const Report& r) { return of_leaves(r, gross_of_groups(r)); }},
        {by({"leaf"}, {"net_assimilation_by_leaf", rate,
                       "net assimilation of each leaf"}),
         MeanOver::nothing, net_by_leaf},
        {by({"organ"},
            {"assimilation_by_organ", rate,
             "gross assimilation of leaves together and of each other organ"}),
         MeanOver::nothing, gross_by_organ, has_living_organs},
        {by({"organ"},
            {"carbon_loss_by_organ", rate,
             "carbon that leaves together and each other organ respire and are "
             "built of, at the temperature of the air"}),
         MeanOver::nothing, loss_by_organ, has_living_organs},
        {exact(by({"organ"},
                  {"dry_mass_by_organ", "t ha-1",
                   "dry mass of leaves together and of each other organ that "
                   "has a density; if plants grow, all that is ever built"})),
         MeanOver::nothing, dry_mass_by_organ, has_living_organs},
        {by({"layer"}, {"assimilation_by_layer", rate,
                        "gross assimilation of leaves and green organs in each "
                        "layer"}),
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
