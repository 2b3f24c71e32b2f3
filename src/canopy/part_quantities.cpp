// SPDX-License-Identifier: Apache-2.0
#include "declaration.hpp"
#include "ideotype/core/units.hpp"

namespace ideotype {

namespace {

using Values = std::vector<Estimate>;

bool has_components(const Scope& scope) {
    return scope.components > 1;
}

bool has_bands(const Scope& scope) {
    return scope.bands.size() > 1;
}

bool has_parts(const Scope& scope) {
    return has_components(scope) || has_bands(scope);
}

bool has_nir(const Scope& scope) {
    return scope.has_band("nir");
}

//! Returns the light that leaves absorb in some bands together [J m-2 day-1].
Randomised absorbed_in(const CanopyReport& report,
                       const std::vector<std::string>& names) {
    std::vector<double> sums(report.randomisations());
    double least = 0;  // standard error that paths can tell
    for (const BandReport& band : report.bands) {
        if (std::find(names.begin(), names.end(), band.name) == names.end())
            continue;
        for (std::size_t r = 0; r < sums.size(); ++r)
            sums[r] += band.budget_by_randomisation[r].leaves;
        // A sum may be better known than its parts only by chance.
        if (names.size() == 1) least = band.light.day.leaves.standard_error;
    }
    Estimate sum = estimate(sums);
    sum.standard_error = std::max(sum.standard_error, least);
    return {sum, std::move(sums)};
}

TakeNumber absorbed(std::vector<std::string> names) {
    return [names = std::move(names)](const CanopyReport& report) {
        return scaled(absorbed_in(report, names), 1 / joule_per_megajoule);
    };
}

//! Takes a number of each component and band, components first.
template <class Take>
TakeNumbers by_component_and_band(const Take& take) {
    return [take](const CanopyReport& report) {
        Values values;
        for (std::size_t c = 0; c < report.components.size(); ++c)
            for (const BandReport& band : report.bands)
                values.push_back(take(band, c));
        return values;
    };
}

//! Takes a part of the incident light of each band.
TakeNumbers fraction_by_band(Estimate BudgetEstimate::*part) {
    return [part](const CanopyReport& report) {
        Values values;
        for (const BandReport& band : report.bands) {
            const BudgetEstimate& day = band.light.day;
            values.push_back(fraction_of(day.*part, day.incident));
        }
        return values;
    };
}

//! Takes the gross assimilation of each component, lowered by a loss.
template <class Loss>
TakeNumbers assimilation(const Loss& loss) {
    return [loss](const CanopyReport& report) {
        Values values;
        for (const ComponentAssimilation& each : by_component(
                 *report.assimilation, report.groups, report.components.size()))
            values.push_back(
                {each.gross.mean - loss(each), each.gross.standard_error});
        return values;
    };
}

bool have_assimilation(const Scope& scope) {
    return has_components(scope) && scope.assimilates;
}

}  // namespace

std::vector<Declaration> part_quantities() {
    using Report = CanopyReport;
    using Part = ComponentAssimilation;
    constexpr Certainty exact = Certainty::exact;
    return {
        {{"absorbed_nir", daily,
          "near infrared that leaves absorb per ground area"},
         absorbed({"nir"}),
         false,
         has_nir},
        {{"absorbed_shortwave", daily,
          "PAR and near infrared that leaves absorb per ground area"},
         absorbed({"par", "nir"}),
         false,
         has_nir},
        {{"absorbed_light",
          daily,
          "light that leaves absorb per ground area",
          {"component", "band"}},
         by_component_and_band([](const BandReport& band, std::size_t c) {
             return scaled(band.part(c).leaves, 1 / joule_per_megajoule);
         }),
         false,
         has_parts},
        {{"intercepted_fraction",
          "1",
          "light that leaves and other organs absorb over incident light",
          {"component", "band"}},
         by_component_and_band([](const BandReport& band, std::size_t c) {
             const BudgetEstimate& day = band.light.day;
             return fraction_of(
                 band.parts.empty() ? day.plants : band.parts[c].all,
                 day.incident);
         }),
         false,
         has_parts},
        {{"soil_fraction_by_band",
          "1",
          "light that the soil absorbs over incident light",
          {"band"}},
         fraction_by_band(&BudgetEstimate::soil),
         false,
         has_bands},
        {{"reflected_fraction_by_band",
          "1",
          "light that is sent back to the sky over incident light",
          {"band"}},
         fraction_by_band(&BudgetEstimate::reflected),
         false,
         has_bands},
        {{"lai_by_component",
          "m2 m-2",
          "one-sided leaf area per ground area",
          {"component"},
          exact},
         [](const Report& r) {
             Values values;
             for (const ComponentReport& each : r.components)
                 values.push_back({each.lai, 0});
             return values;
         },
         false,
         has_components},
        {{"gross_assimilation_by_component",
          rate,
          "CO2 that leaves take up per ground area",
          {"component"}},
         assimilation([](const Part&) { return 0.; }),
         false,
         have_assimilation},
        {{"net_assimilation_by_component",
          rate,
          "gross assimilation less what leaves respire while there is light",
          {"component"}},
         assimilation([](const Part& x) { return x.respiration.in_light; }),
         false,
         have_assimilation},
        {{"carbon_balance_by_component",
          rate,
          "gross assimilation less what leaves respire day and night and the "
          "carbon that they are built of",
          {"component"}},
         assimilation([](const Part& x) {
             return x.respiration.in_light + x.respiration.at_night +
                    x.building;
         }),
         false,
         have_assimilation},
    };
}

}  // namespace ideotype
