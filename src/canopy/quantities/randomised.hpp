// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "ideotype/canopy/quantities.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/mapped.hpp"

//! Arithmetic of numbers that a report has with their standard errors and by
//! randomisation.
namespace ideotype {

Randomised scaled(Randomised x, double factor);

//! Returns the mean of values with an error not below the least one.
Randomised known_to(double least, std::vector<double> values);

//! Combines the numbers of all places with the numbers of each randomisation
//! [randomisation, place].
std::vector<Randomised> randomised(
    const std::vector<Estimate>& estimates,
    const std::vector<std::vector<double>>& by_randomisation,
    double factor = 1);

//! Returns a value that is the same in all randomisations.
Randomised certain(const CanopyReport& report, double value);

//! The respiration and building by which a number is less than gross
//! assimilation.
enum class Loss {
    none,         //!< gross assimilation
    in_light,     //!< net assimilation
    respiration,  //!< carbon from which all organs grow
    all,          //!< carbon balance
};

//! Returns the flux from which a loss is taken by lowered(), which contains the
//! respiration of AssimilationReport::before_losses().
const FluxReport& flux_before(const AssimilationReport& report, Loss loss);

//! Returns assimilation lowered by losses. Fields with more leaves lose more,
//! so that errors are those of differences.
//! @param mean,flux flux_before() the loss, and its values by randomisation
//! @param losses losses by randomisation; none: all have the mean loss
Randomised lowered(const Estimate& mean, std::vector<double> flux,
                   const CarbonLoss& lost,
                   const std::vector<CarbonLoss>& losses, Loss loss);

//! Returns the assimilation of all leaves lowered by a loss.
Randomised assimilation_of_all(const AssimilationReport& report, Loss loss);

//! Returns a flux along groups or layers.
std::vector<Randomised> along(const std::vector<FluxTally>& tallies,
                              const std::vector<Estimate>& found,
                              std::vector<double> FluxTally::*part);

//! Returns a ratio R = Y / X of means with its error to first order (Cochran
//! 1977, Sampling Techniques, section 6.4): that of the mean of
//! R + (y_r - R x_r) / X over randomisations r.
//! @param left function for y_r - R x_r
template <class Left>
Randomised ratio_with_error(double ratio, double denominator,
                            std::size_t randomisations, const Left& left) {
    Randomised result{{ratio, 0}, {}};
    for (std::size_t r = 0; r < randomisations; ++r)
        result.by_randomisation.push_back(ratio + left(r) / denominator);
    result.estimate.standard_error =
        estimate(result.by_randomisation).standard_error;
    return result;
}

//! Returns a number per leaf area of fields, or 0 without leaves, with errors
//! to first order.
//! @param lai mean leaf area index of all fields
Randomised per_leaf_area(const CanopyReport& report, const Randomised& number,
                         double lai, double LeafArea::*of);

//! Returns a number per area of all leaves.
Randomised per_leaf_area(const CanopyReport& report, const Randomised& number);

//! Sums numbers of groups over those that are wanted by their SurfaceId.
double over_groups(const CanopyReport& report,
                   const std::vector<double>& groups, const auto& is_wanted) {
    IDEOTYPE_EXPECT(groups.size() == report.groups.size());
    double sum = 0;
    for (std::size_t g = 0; g < groups.size(); ++g)
        if (is_wanted(report.groups[g].id)) sum += groups[g];
    return sum;
}

//! Sums numbers of groups over the leaves of a component.
double over_leaves(const CanopyReport& report,
                   const std::vector<double>& groups, std::size_t component);

//! Sums numbers of groups over all organs of a component.
double over_plants(const CanopyReport& report,
                   const std::vector<double>& groups, std::size_t component);

//! Returns the numbers of the groups that are leaves.
template <class Number>
std::vector<Number> of_leaves(const CanopyReport& report,
                              const std::vector<Number>& groups) {
    std::vector<Number> leaves;
    for (std::size_t g = 0; g < groups.size(); ++g)
        if (report.groups[g].id.is_leaf()) leaves.push_back(groups[g]);
    return leaves;
}

}  // namespace ideotype
