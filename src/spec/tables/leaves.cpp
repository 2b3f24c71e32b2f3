// SPDX-License-Identifier: Apache-2.0
#include "spec/tables.hpp"

namespace ideotype {

template <>
inline constexpr std::array enum_names<CapacityProfile>{
    EnumName{"none", CapacityProfile::none},
    EnumName{"exponential", CapacityProfile::exponential},
    EnumName{"nitrogen", CapacityProfile::nitrogen},
    EnumName{"rank", CapacityProfile::rank}};
template <>
inline constexpr std::array enum_names<Stomata::Model>{
    EnumName{"medlyn", Stomata::Model::medlyn},
    EnumName{"ball_berry", Stomata::Model::ball_berry}};

namespace {

// Each line declares one key.
// clang-format off
constexpr Key photosynthesis_keys[] = {
    key<&PhotosynthesisSpec::model>("model", any_value, usual(), "response of leaves to light: the non-rectangular hyperbola, the C4 model of Collatz et al. 1992, or the C3 model of Farquhar, von Caemmerer and Berry 1980"),
    key<&PhotosynthesisSpec::phi>("phi", by_leaf(0, 0.2), by("0.06"), "quantum yield of the hyperbola [mol mol-1]"),
    key<&PhotosynthesisSpec::theta>("theta", by_leaf(0, 1), by("0.7 of the hyperbola, 0.83 by Collatz, 0.97875 by Farquhar"), "curvature of the response to light; in the model of Farquhar that of electron transport, at 25 deg C"),
    key<&PhotosynthesisSpec::amax>("amax", by_leaf(0, 1e9, "umol m-2 s-1"), by("50"), "asymptote of the gross assimilation of the hyperbola in strong light, at 30 deg C"),
    key<&PhotosynthesisSpec::rate_2000>("rate_2000", by_leaf(0, 400, "umol m-2 s-1"), none("52"), "gross assimilation of the hyperbola at an absorbed PPFD of 2000 umol m-2 s-1 and 30 deg C, from which amax follows; it replaces amax"),
    key<&PhotosynthesisSpec::rd>("rd", by_leaf(0, 1000, "umol m-2 s-1"), by("0.04 amax, at 30 deg C; 0.8 by Collatz and 1.28 by Farquhar, at 25 deg C"), "dark respiration"),
    key<&PhotosynthesisSpec::vmax>("vmax", by_leaf(0, 1e6, "umol m-2 s-1"), by("39"), "capacity by Collatz, at 25 deg C"),
    key<&PhotosynthesisSpec::alpha>("alpha", by_leaf(0, 0.2), by("0.067"), "quantum yield by Collatz [mol mol-1]"),
    key<&PhotosynthesisSpec::beta>("beta", by_leaf(0, 1), by("0.93 by Collatz, 0.98 by Farquhar"), "curvature between light and CO2 by Collatz, between the limits by Farquhar, where 1 is the smallest limit itself"),
    key<&PhotosynthesisSpec::k>("k", by_leaf(0, 100, "mol m-2 s-1"), by("0.7"), "initial slope of the response to CO2 by Collatz, at 25 deg C"),
    key<&PhotosynthesisSpec::vcmax>("vcmax", by_leaf(0, 1e6, "umol m-2 s-1"), by("110"), "capacity of Rubisco by Farquhar, at 25 deg C"),
    key<&PhotosynthesisSpec::jmax>("jmax", by_leaf(0, 1e6, "umol m-2 s-1"), by("195"), "capacity of electron transport by Farquhar, at 25 deg C, from a fit with 4.5 ci + 10.5 Gamma*"),
    key<&PhotosynthesisSpec::tpu>("tpu", by_leaf(0, 1e6, "umol m-2 s-1"), by("13"), "capacity of the use of triose phosphate by Farquhar, at 25 deg C"),
    key<&PhotosynthesisSpec::g1>("g1", by_leaf(0, 100, "kPa^0.5"), by("5.79"), "slope of stomata by Farquhar, after Medlyn et al. 2011"),
    key<&PhotosynthesisSpec::profile>("profile", any_value, usual(), "decrease of the capacity of leaves with depth: none; exp(-kn L) of the leaf area index L above; the same profile of a fixed canopy nitrogen; or by rank_capacity"),
    key<&PhotosynthesisSpec::rank_capacity>("rank_capacity", number_or_list(0, 2), usual(), "relative capacity of the profile by rank, at equal distances from the lowest leaf to the highest, linear in between"),
    key<&PhotosynthesisSpec::kn>("kn", within(0, 5), usual(), "extinction coefficient of the profile, per leaf area index"),
    key<&PhotosynthesisSpec::nitrogen>("nitrogen", within(0.01, 100, "g m-2"), usual(), "nitrogen in leaves, per ground area"),
    key<&PhotosynthesisSpec::follows_weather>("weather", any_value, usual(), "true for leaves with temperature and humidity of the weather; otherwise, and on clear days, 30 deg C and 60 %"),
    key<&PhotosynthesisSpec::leaf_mass>("leaf_mass", within(0, 1000, "g m-2"), usual(), "dry mass of leaves per area, with a construction cost in the net carbon balance"),
    key<&PhotosynthesisSpec::building_days>("leaf_days", within(1, 1000, "day"), usual(), "number of days over which the construction cost of leaves is spread"),
};

constexpr Key water_keys[] = {
    key<&WaterSpec::rules, &LeafWater::has_leaf_temperature>("leaf_temperature", any_value, usual(), "true for leaf temperatures by the energy balance; otherwise leaves have that of the air, and assimilate as without this table"),
    key<&WaterSpec::rules, &LeafWater::has_canopy_air>("canopy_air", any_value, usual(), "true for a canopy that warms and moistens the air within; otherwise that is the air above"),
    key<&WaterSpec::model>("stomata", any_value, usual(), "model of stomata, after Medlyn et al. 2011 or Ball, Woodrow and Berry 1987"),
    key<&WaterSpec::slope>("slope", within(0.01, 50), by("by Medlyn 1.6 of C4 leaves and photosynthesis.g1 of C3 leaves [kPa^0.5], by Ball and Berry 4.53"), "slope of stomatal conductance with assimilation over CO2"),
    key<&WaterSpec::intercept>("intercept", within(0, 1, "mol m-2 s-1"), by("0.01 by Medlyn, 0.017 by Ball and Berry"), "stomatal conductance without assimilation"),
    key<&WaterSpec::rules, &LeafWater::stomatal_ratio>("stomatal_ratio", within(0, 1000), usual(), "stomatal conductance of the lower face relative to the upper face"),
    key<&WaterSpec::rules, &LeafWater::wind_attenuation>("wind_attenuation", within(0, 10), usual(), "attenuation of wind within the canopy: a in exp(-a (1 - z / h))"),
    key<&WaterSpec::limit>("limit", within(0, 100000, "mm"), usual(), "largest transpiration over all days; plants that exceed it, with two standard errors added, are not feasible; 0: any"),
};
// clang-format on

}  // namespace

constinit const Description photosynthesis_table =
    describe<PhotosynthesisSpec>("photosynthesis", photosynthesis_keys);
constinit const Description water_table =
    describe<WaterSpec>("water", water_keys);

}  // namespace ideotype
