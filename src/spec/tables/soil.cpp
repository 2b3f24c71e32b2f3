// SPDX-License-Identifier: Apache-2.0
#include "spec/tables.hpp"

namespace ideotype {

namespace {

// Each line declares one key.
// clang-format off
constexpr Key dry_soil_keys[] = {
    key<&SoilSpec::texture>("texture", any_value, usual(), "texture of the soil, from which the next four keys follow: the middles of the ranges in FAO-56, table 19"),
    key<&SoilSpec::field_capacity>("field_capacity", within(0.01, 0.9, "m3 m-3"), by("by texture"), "water content at field capacity"),
    key<&SoilSpec::wilting_point>("wilting_point", within(0, 0.9, "m3 m-3"), by("by texture"), "water content at the wilting point"),
    key<&SoilSpec::readily_evaporable>("readily_evaporable", within(0, 100, "mm"), by("by texture"), "water that evaporates from the upper layer without limitation"),
    key<&SoilSpec::total_evaporable>("total_evaporable", within(0, 100, "mm"), by("by texture"), "water that can evaporate from the upper layer"),
    key<&SoilSpec::depletion_fraction>("depletion_fraction", within(0, 1), usual(), "fraction of the available water that roots take up without stress: maize in FAO-56, table 22"),
    key<&SoilSpec::root_depth>("root_depth", within(0.1, 10, "m"), usual(), "greatest depth of roots; 1.0 to 1.7 of maize in FAO-56, table 22"),
    key<&SoilSpec::root_rate>("root_rate", within(1e-05, 0.1, "m / (deg C d)"), usual(), "rate at which roots grow deeper, from 0.15 m at emergence; CERES-Maize"),
    key<&SoilSpec::curve_number>("curve_number", within(0, 100), usual(), "curve number of runoff (SCS); 0: rain does not run off"),
};

constexpr Key irrigation_keys[] = {
    key<&IrrigationSpec::dates>("dates", words("1950-01-01 .. 2100-12-31"), none("[1982-05-02, 1982-05-06]"), "dates of irrigation"),
    key<&IrrigationSpec::amounts>("amounts", number_or_list(0, 1000), none("25"), "water on each date [mm]; one number: the same on all"),
    key<&IrrigationSpec::depletion>("depletion", within(0, 1), usual(), "fraction of the available water of the root zone that is missing in the morning, above which the crop is irrigated; 1: never"),
    key<&IrrigationSpec::amount>("amount", within(0, 1000, "mm"), usual(), "water of each irrigation by depletion; 0: up to field capacity"),
    key<&IrrigationSpec::limit>("limit", within(0, 100000, "mm"), usual(), "largest sum of irrigation by depletion in a season; 0: any"),
};

constexpr Key prices_keys[] = {
    key<&Prices::grain>("grain", within(0, 1e9, "t-1"), required("190"), "price of grain with 15.5 % of water, in any currency"),
    key<&Prices::seed>("seed", within(0, 1e6), usual("0.0035"), "price of the seed of each plant"),
    key<&Prices::water>("water", within(0, 1e6, "m-3"), usual("0.15"), "price of irrigation"),
    key<&Prices::electricity>("electricity", within(0, 1e6, "kWh-1"), usual("0.05"), "price of the electricity of panels"),
    key<&Prices::module_efficiency>("module_efficiency", within(0, 1), usual(), "electricity over the light on both sides of panels; an estimate for silicon modules"),
    key<&Prices::other>("other", within(0, 1e9, "ha-1"), usual("900"), "all other costs"),
};
// clang-format on

}  // namespace

constinit const Description soil_table =
    describe<SoilSpec>("soil", dry_soil_keys);
constinit const Description irrigation_table =
    describe<IrrigationSpec>("irrigation", irrigation_keys);
constinit const Description prices_table =
    describe<Prices>("prices", prices_keys);

}  // namespace ideotype
