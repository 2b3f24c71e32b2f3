// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/canopy/canopy.hpp"
#include "ideotype/core/quantity.hpp"

namespace ideotype {

//! The name of the quantity that is undefined for an isolated plot.
inline constexpr auto extinction = "extinction_coefficient";

//! Returns all quantities of a scene with plants as components. Their axes are
//! leaf, organ, layer, hour, light_source and leaf_side, and where there are
//! several, day, component, band, field_row and object.
//! @param details optional results of the evaluation
QuantitySet canopy_quantities(const Scene& scene, const Layers& layers,
                              const Details& details);

//! Returns the values of canopy_quantities() in a report, in the same order.
std::vector<Estimate> measure(const CanopyReport& report);

//! A quantity without axes.
struct Measured {
    Quantity quantity;
    Estimate estimate;
};

//! Returns all quantities without axes in a report.
std::vector<Measured> measure_numbers(const CanopyReport& report);

//! Returns the names of quantities without axes that a report may contain,
//! except those that describe only the method. Each name can be an objective.
std::vector<std::string> objective_names();

//! Return whether a quantity exists only in reports with assimilation, plant
//! form, measured lines, light in a given band, leaves that exchange heat and
//! water, soil that dries, grain, prices, growing plants, panels, or two
//! components.
bool is_of_assimilation(const std::string& quantity);
bool is_of_form(const std::string& quantity);
bool is_of_lines(const std::string& quantity);
bool is_of_band(const std::string& quantity, const std::string& band);
bool is_of_water(const std::string& quantity);
bool is_of_soil(const std::string& quantity);
bool is_of_grain(const std::string& quantity);
bool is_of_prices(const std::string& quantity);
bool is_of_growth(const std::string& quantity);
bool is_of_panels(const std::string& quantity);
bool is_of_two_components(const std::string& quantity);

//! The quantities that prices multiply in the margin of a season.
inline constexpr const char* priced_quantities[] = {
    "grain_yield_moist", "seeds", "irrigation", "electricity"};

//! Returns the unit of a quantity.
//! @throws std::out_of_range if no quantity has this name.
std::string unit_of(const std::string& quantity);

//! The weights with which a quantity is averaged over the stages of a season.
enum class MeanOver {
    nothing,           //!< amounts, summed over stages
    time,              //!< states of the stand
    incident_light,    //!< fractions of the incident light
    absorbed_light,    //!< amounts over the light that leaves absorb
    transpired_water,  //!< amounts over the water that leaves transpire
    leaf_area,         //!< amounts per leaf area
    leaf_area_time,    //!< states of leaves: leaf area and time
};

//! Returns the weights with which a quantity is averaged over the stages of a
//! season. @throws std::out_of_range if no quantity has this name.
MeanOver mean_over(const std::string& quantity);

//! A number and its value in each independent randomisation.
struct Randomised {
    Estimate estimate;
    std::vector<double> by_randomisation;
};

//! Returns the values of measure() with their values by randomisation, if
//! known.
std::vector<Randomised> measure_by_randomisation(const CanopyReport& report);

//! Returns a quantity without axes.
//! @throws Error if the report has no quantity of this name.
Randomised measure_objective(const std::string& name,
                             const CanopyReport& report);

//! Returns the names of objectives that are sums over components.
std::vector<std::string> additive_objectives();

//! Returns the contribution of each component to an objective that is a sum
//! over components, per area of all ground.
//! @throws Error if the report has no such contributions.
std::vector<Randomised> measure_parts(const std::string& name,
                                      const CanopyReport& report);

//! Returns the weighted sum of contributions.
Randomised weighted_sum(const std::vector<Randomised>& parts,
                        const std::vector<double>& weights);

//! Returns a quantity along leaf, layer, component or field_row, one value per
//! position on that axis.
//! @throws Error if the report has no quantity of this name.
std::vector<Randomised> measure_profile(const std::string& name,
                                        const CanopyReport& report);

}  // namespace ideotype
