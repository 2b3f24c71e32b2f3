// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "ideotype/canopy/quantities.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/mapped.hpp"

//! Arithmetic of values in a report that have standard errors and values by
//! randomisation.
namespace ideotype {

Randomised scaled(Randomised x, double factor);

//! Returns the mean of values with a standard error of at least `least`.
Randomised known_to(double least, std::vector<double> values);

//! Combines estimates with their values by randomisation [randomisation,
//! place].
std::vector<Randomised> randomised(
    const std::vector<Estimate>& estimates,
    const std::vector<std::vector<double>>& by_randomisation,
    double factor = 1);

//! Returns a value without error, equal in all randomisations.
Randomised certain(const CanopyReport& report, double value);

//! The respiration and construction that are subtracted from gross
//! assimilation.
enum class Loss {
    none,         //!< gross assimilation
    in_light,     //!< net assimilation
    respiration,  //!< carbon from which all organs grow
    all,          //!< carbon balance
};

//! Returns the flux from which lowered() subtracts a loss. Where the loss
//! includes respiration, this is AssimilationReport::before_losses().
const FluxReport& flux_before(const AssimilationReport& report, Loss loss);

//! Returns assimilation minus losses. Fields with more leaves have larger
//! losses, so errors are computed from the differences.
//! @param mean,flux flux_before() of the loss, and its values by randomisation
//! @param losses losses by randomisation; empty: all are equal to the mean loss
Randomised lowered(const Estimate& mean, std::vector<double> flux,
                   const CarbonLoss& lost,
                   const std::vector<CarbonLoss>& losses, Loss loss);

//! Returns the assimilation of all leaves minus a loss.
Randomised assimilation_of_all(const AssimilationReport& report, Loss loss);

//! Returns a flux along groups or layers.
std::vector<Randomised> along(const std::vector<FluxTally>& tallies,
                              const std::vector<Estimate>& found,
                              std::vector<double> FluxTally::*part);

//! Returns a ratio R = Y / X of means with its error to first order (Cochran
//! 1977, Sampling Techniques, section 6.4): the error of the mean of R + (y_r -
//! R x_r) / X over randomisations r.
//! @param left returns y_r - R x_r
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

//! Returns a value divided by the leaf area of fields, or 0 without leaves,
//! with errors to first order.
//! @param lai mean leaf area index of all fields
Randomised per_leaf_area(const CanopyReport& report, const Randomised& number,
                         double lai, double LeafArea::*of);

//! Returns a value divided by the area of all leaves.
Randomised per_leaf_area(const CanopyReport& report, const Randomised& number);

//! Sums values over the groups selected by their SurfaceId.
double over_groups(const CanopyReport& report,
                   const std::vector<double>& groups, const auto& is_wanted) {
    IDEOTYPE_EXPECT(groups.size() == report.groups.size());
    double sum = 0;
    for (std::size_t g = 0; g < groups.size(); ++g)
        if (is_wanted(report.groups[g].id)) sum += groups[g];
    return sum;
}

//! Sums values of groups over the leaves of a component.
double over_leaves(const CanopyReport& report,
                   const std::vector<double>& groups, std::size_t component);

//! Sums values of groups over all organs of a component.
double over_plants(const CanopyReport& report,
                   const std::vector<double>& groups, std::size_t component);

//! Returns the values of the groups that are leaves.
template <class Number>
std::vector<Number> of_leaves(const CanopyReport& report,
                              const std::vector<Number>& groups) {
    std::vector<Number> leaves;
    for (std::size_t g = 0; g < groups.size(); ++g)
        if (report.groups[g].id.is_leaf()) leaves.push_back(groups[g]);
    return leaves;
}

}  // namespace ideotype
