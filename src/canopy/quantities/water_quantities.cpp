// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "declaration.hpp"
#include "randomised.hpp"

namespace ideotype {

namespace {

using Values = std::vector<Estimate>;

constexpr auto depth = "mm day-1";  //!< depth of water

bool exchanges_water(const Scope& scope) {
    return scope.has_water;
}

bool exchange_water(const Scope& scope) {
    return scope.has_water && scope.components > 1;
}

Randomised flux(const FluxReport& report, double factor = 1) {
    return scaled(
        Randomised{report.sum, mapped(report.tallies, &FluxTally::sum)},
        factor);
}

TakeNumber number(FluxReport WaterReport::*part) {
    return
        [=](const CanopyReport& report) { return flux((*report.water).*part); };
}

TakeNumber mean_of_leaves(FluxReport WaterReport::*part) {
    return [=](const CanopyReport& report) {
        return per_leaf_area(report, flux((*report.water).*part),
                             report.assimilating_lai, &LeafArea::assimilating);
    };
}

TakeNumbers numbers(std::vector<Estimate> FluxReport::*axis,
                    FluxReport WaterReport::*part) {
    return
        [=](const CanopyReport& report) { return (*report.water).*part.*axis; };
}

Randomised water_use(const CanopyReport& report) {
    return flux(report.water->transpiration, report.days);
}

//! Returns net assimilation divided by transpired water, with errors to first
//! order.
Randomised efficiency(const CanopyReport& report) {
    const AssimilationReport& carbon = *report.assimilation;
    const FluxReport& water = report.water->transpiration;
    if (!(water.sum.mean > 0)) return certain(report, 0);
    const Randomised net = assimilation_of_all(carbon, Loss::in_light);
    const double ratio = grams_of_carbon * net.estimate.mean / water.sum.mean;
    return ratio_with_error(
        ratio, water.sum.mean, carbon.gross.tallies.size(), [&](std::size_t r) {
            return grams_of_carbon * net.by_randomisation[r] -
                   ratio * water.tallies[r].sum();
        });
}

Values warming_by_layer(const CanopyReport& report) {
    Values layers = report.water->warming.layers;
    for (std::size_t l = 0; l < layers.size(); ++l) {
        const double area = report.water->leaf_area[l];
        layers[l] = scaled(layers[l], area > 0 ? 1 / area : 0);
    }
    return layers;
}

Values warming_by_hour(const CanopyReport& report) {
    Values hours = report.water->warming.hours;
    const double lai = report.assimilating_lai;
    for (Estimate& x : hours) x = scaled(x, lai > 0 ? 1 / lai : 0);
    return hours;
}

std::vector<Randomised> transpiration_by_leaf(const CanopyReport& report) {
    const FluxReport& water = report.water->transpiration;
    return of_leaves(report,
                     along(water.tallies, water.groups, &FluxTally::groups));
}

std::vector<Randomised> transpiration_by_component(const CanopyReport& report) {
    std::vector<Randomised> parts;
    for (std::size_t c = 0; c < report.components.size(); ++c)
        parts.push_back(known_to(0, mapped(report.water->transpiration.tallies,
                                           [&](const FluxTally& tally) {
                                               return over_leaves(
                                                   report, tally.groups, c);
                                           })));
    return parts;
}

}  // namespace

std::vector<Declaration> water_quantities() {
    const auto declare = [](Quantity quantity, MeanOver mean_over, auto take,
                            bool (*is_in)(const Scope&) = exchanges_water) {
        return Declaration{std::move(quantity), mean_over, std::move(take),
                           is_in};
    };
    return {
        declare({"transpiration", depth, "water that leaves transpire"},
                MeanOver::nothing, number(&WaterReport::transpiration)),
        declare({"water_use", "mm", "water that leaves transpire on all days"},
                MeanOver::nothing, TakeNumber(water_use)),
        declare({"water_use_efficiency", "g kg-1",
                 "carbon of net assimilation over transpired water"},
                MeanOver::transpired_water, TakeNumber(efficiency)),
        declare({"sensible_heat", "MJ m-2 day-1",
                 "heat that leaves give to the air"},
                MeanOver::nothing, number(&WaterReport::sensible)),
        declare({"leaf_warming", "K",
                 "temperature of leaves less that of the air above the canopy, "
                 "mean over leaf area and the time with light"},
                MeanOver::leaf_area_time,
                mean_of_leaves(&WaterReport::warming)),
        declare({"canopy_conductance", "mol m-2 s-1",
                 "conductance of the stomata of all leaves for vapour per "
                 "ground area, mean over the time with light"},
                MeanOver::time, number(&WaterReport::conductance)),
        declare({"hot_hours", "h day-1",
                 fmt::format("time for which leaves are warmer than {} deg C, "
                             "mean over leaf area",
                             hot_leaf)},
                MeanOver::leaf_area, mean_of_leaves(&WaterReport::hot)),
        declare(by({"leaf"}, {"transpiration_by_leaf", depth,
                              "water that each leaf transpires"}),
                MeanOver::nothing, TakeProfile(transpiration_by_leaf)),
        declare(by({"layer"}, {"transpiration_by_layer", depth,
                               "water that leaves of each layer transpire"}),
                MeanOver::nothing,
                numbers(&FluxReport::layers, &WaterReport::transpiration)),
        declare(by({"hour"}, {"transpiration_by_hour", "mmol m-2 s-1",
                              "water that leaves transpire at each instant"}),
                MeanOver::time,
                numbers(&FluxReport::hours, &WaterReport::transpiration)),
        declare(by({"day"}, {"transpiration_by_day", depth,
                             "water that leaves transpire on each day"}),
                MeanOver::nothing,
                numbers(&FluxReport::dates, &WaterReport::transpiration)),
        declare(by({"layer"},
                   {"leaf_warming_by_layer", "K",
                    "temperature of the leaves of each layer less that of the "
                    "air above the canopy, in the time with light"}),
                MeanOver::leaf_area_time, TakeNumbers(warming_by_layer)),
        declare(by({"hour"}, {"leaf_warming_by_hour", "K",
                              "temperature of leaves less that of the air "
                              "above the canopy at each instant"}),
                MeanOver::leaf_area_time, TakeNumbers(warming_by_hour)),
        declare(by({"component"},
                   {"transpiration_by_component", depth,
                    "water that leaves of each component transpire"}),
                MeanOver::nothing, TakeProfile(transpiration_by_component),
                exchange_water),
    };
}

}  // namespace ideotype
