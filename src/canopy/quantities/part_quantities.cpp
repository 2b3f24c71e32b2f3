// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "declaration.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/units.hpp"
#include "randomised.hpp"

namespace ideotype {

namespace {

using Values = std::vector<Estimate>;
using Numbers = std::vector<double>;

bool has_components(const Scope& scope) {
    return scope.components > 1;
}

bool has_bands(const Scope& scope) {
    return scope.bands.size() > 1;
}

bool has_parts(const Scope& scope) {
    return has_components(scope) || has_bands(scope);
}

using Names = std::vector<std::string>;

//! Sums absorbed light over some bands [MJ m-2 day-1].
//! @param absorbed light absorbed in a band, by randomisation [J m-2 day-1]
//! @param known light absorbed in a band, estimated from all randomisations
template <class Absorbed, class Known>
Randomised over_bands(const CanopyReport& report, const Names& names,
                      const Absorbed& absorbed, const Known& known) {
    Numbers sums(report.randomisations());
    double least = 0;
    for (const BandReport& band : report.bands) {
        if (std::ranges::find(names, band.name) == names.end()) continue;
        for (std::size_t r = 0; r < sums.size(); ++r)
            sums[r] += absorbed(band, r);
        // A sum could have a smaller error than its parts only by chance.
        if (names.size() == 1) least = known(band).standard_error;
    }
    return scaled(known_to(least, std::move(sums)), 1 / joule_per_megajoule);
}

std::vector<Randomised> absorbed_by_component(const CanopyReport& report,
                                              const Names& names) {
    std::vector<Randomised> parts;
    for (std::size_t c = 0; c < report.components.size(); ++c)
        parts.push_back(over_bands(
            report, names,
            [&](const BandReport& band, std::size_t r) {
                return over_leaves(report, band.groups_by_randomisation[r], c);
            },
            [&](const BandReport& band) { return band.part(c).leaves; }));
    return parts;
}

//! Extracts the light that all leaves absorb in several bands together.
TakeNumber absorbed(Names names) {
    return [names = std::move(names)](const CanopyReport& report) {
        return over_bands(
            report, names,
            [](const BandReport& band, std::size_t r) {
                return band.budget_by_randomisation[r].leaves;
            },
            [](const BandReport& band) { return band.light.day.leaves; });
    };
}

//! Declares the light that leaves absorb in several bands together, for all
//! canopies that include the last of these bands.
Declaration absorbed_in(const std::string& name, const Names& bands,
                        const std::string& light) {
    return {{"absorbed_" + name, daily,
             light + " that leaves absorb per ground area"},
            MeanOver::nothing,
            absorbed(bands),
            [last = bands.back()](const Scope& scope) {
                return scope.has_band(last);
            }};
}

//! Extracts a number for each component and band, components first.
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

Declaration fraction_by_band(const char* name, const char* description,
                             Estimate BudgetEstimate::*part) {
    return {{name, "1", description, {"band"}},
            MeanOver::incident_light,
            [part](const CanopyReport& report) {
                return mapped(report.bands, [&](const BandReport& band) {
                    const BudgetEstimate& day = band.light.day;
                    return fraction_of(day.*part, day.incident);
                });
            },
            has_bands};
}

std::vector<Randomised> assimilation_by_component(const CanopyReport& report,
                                                  Loss loss) {
    const AssimilationReport& all = *report.assimilation;
    std::vector<Randomised> parts;
    for (const ComponentAssimilation& each :
         by_component(all, report.groups, report.components.size())) {
        parts.push_back(lowered(
            loss == Loss::none ? each.gross : each.uptake,
            mapped(flux_before(all, loss).tallies,
                   [&](const FluxTally& tally) {
                       return over_plants(report, tally.groups, parts.size());
                   }),
            each.loss, each.loss_by_randomisation, loss));
    }
    return parts;
}

//! Returns the relative advantage of the first component's mean plant over the
//! second's. It is computed from net assimilation or, if leaves do not
//! assimilate, from absorbed light. Dividing by the absolute value of the
//! second makes an advantage positive even if a plant in deep shade loses
//! carbon. The values are jackknife pseudo-values; all are 0 if the value of
//! the second component is 0.
Randomised invasion(const CanopyReport& report) {
    const std::vector<Randomised> parts = measure_parts(
        report.assimilation ? "net_assimilation" : "absorbed_par", report);
    const Numbers &own = parts[0].by_randomisation,
                  &other = parts[1].by_randomisation;
    const double plants = report.components[0].ground_per_plant /
                          report.components[1].ground_per_plant;
    const double sum = std::accumulate(own.begin(), own.end(), 0.);
    const double of_other = std::accumulate(other.begin(), other.end(), 0.);
    if (of_other == 0) return certain(report, 0);
    const auto n = static_cast<double>(own.size());
    const double whole = sum / of_other;
    Numbers values;
    for (std::size_t r = 0; r < own.size(); ++r) {
        const double without = (sum - own[r]) / (of_other - other[r]);
        values.push_back(std::copysign(1, of_other) *
                         (plants * (n * whole - (n - 1) * without) - 1));
    }
    return known_to(0, std::move(values));
}

bool are_two(const Scope& scope) {
    return scope.components == 2;
}

Declaration assimilation(const char* name, const char* description, Loss loss) {
    return {{name, rate, description, {"component"}},
            MeanOver::nothing,
            [loss](const CanopyReport& report) {
                return assimilation_by_component(report, loss);
            },
            [](const Scope& scope) {
                return has_components(scope) && scope.assimilates;
            }};
}

}  // namespace

std::vector<std::string> additive_objectives() {
    return {"absorbed_par",       "absorbed_nir",     "absorbed_shortwave",
            "gross_assimilation", "net_assimilation", "carbon_balance"};
}

std::vector<Randomised> measure_parts(const std::string& name,
                                      const CanopyReport& report) {
    for (const Waveband& band : wavebands)
        if (name == "absorbed_" + band.name)
            return absorbed_by_component(report, {band.name});
    if (name == "absorbed_shortwave")
        return absorbed_by_component(report, {"par", "nir"});
    return measure_profile(name + "_by_component", report);
}

Randomised weighted_sum(const std::vector<Randomised>& parts,
                        const std::vector<double>& weights) {
    IDEOTYPE_EXPECT(!parts.empty() && parts.size() == weights.size());
    Numbers sums(parts.front().by_randomisation.size());
    double least = 0;
    for (std::size_t c = 0; c < parts.size(); ++c) {
        for (std::size_t r = 0; r < sums.size(); ++r)
            sums[r] += weights[c] * parts[c].by_randomisation[r];
        if (std::ranges::count(weights, 0.) + 1 == std::ssize(weights))
            least = std::max(
                least, std::abs(weights[c]) * parts[c].estimate.standard_error);
    }
    return known_to(least, std::move(sums));
}

std::vector<Declaration> part_quantities() {
    using Report = CanopyReport;
    return {
        absorbed_in("nir", {"nir"}, "near infrared"),
        absorbed_in("shortwave", {"par", "nir"}, "PAR and near infrared"),
        {by({"component", "band"},
            {"absorbed_light", daily,
             "light that leaves absorb per ground area"}),
         MeanOver::nothing,
         by_component_and_band([](const BandReport& band, std::size_t c) {
             return scaled(band.part(c).leaves, 1 / joule_per_megajoule);
         }),
         has_parts},
        {by({"component", "band", "hour"},
            {"absorbed_light_by_hour", "W m-2",
             "light that leaves absorb at each instant"}),
         MeanOver::time,
         [](const Report& r) {
             Values values;
             for (std::size_t c = 0; c < r.components.size(); ++c)
                 for (const BandReport& band : r.bands)
                     for (std::size_t h = 0; h < band.light.steps.size(); ++h)
                         values.push_back(band.leaves_at(c, h));
             return values;
         },
         has_parts},
        {by({"component", "band"},
            {"intercepted_fraction", "1",
             "light that leaves and other organs absorb over incident light"}),
         MeanOver::incident_light,
         by_component_and_band([](const BandReport& band, std::size_t c) {
             const BudgetEstimate& day = band.light.day;
             return fraction_of(
                 band.parts.empty() ? day.plants : band.parts[c].all,
                 day.incident);
         }),
         has_parts},
        fraction_by_band("soil_fraction_by_band",
                         "light that the soil absorbs over incident light",
                         &BudgetEstimate::soil),
        fraction_by_band(
            "reflected_fraction_by_band",
            "light that is sent back to the sky over incident light",
            &BudgetEstimate::reflected),
        {exact(by({"component"}, {"lai_by_component", "m2 m-2",
                                  "one-sided leaf area per ground area"})),
         MeanOver::time,
         [](const Report& r) {
             return mapped(r.components, [](const ComponentReport& each) {
                 return Estimate{each.lai, 0};
             });
         },
         has_components},
        assimilation("gross_assimilation_by_component",
                     "CO2 that leaves take up per ground area", Loss::none),
        assimilation("net_assimilation_by_component",
                     "gross assimilation less the respiration of leaves while "
                     "there is light",
                     Loss::in_light),
        assimilation("carbon_balance_by_component",
                     "gross assimilation less the respiration of leaves by day "
                     "and night and the carbon that builds them",
                     Loss::all),
        {{"invasion", "1",
          "excess of the mean plant of the first component over that of the "
          "second, relative to the latter: of net assimilation, or of absorbed "
          "light where leaves do not assimilate"},
         MeanOver::incident_light,
         TakeNumber(invasion),
         are_two},
    };
}

}  // namespace ideotype
