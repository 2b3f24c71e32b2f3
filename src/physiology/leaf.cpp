// SPDX-License-Identifier: Apache-2.0
#include "ideotype/physiology/leaf.hpp"

#include "ideotype/core/contract.hpp"
#include "ideotype/core/wide_vectors.hpp"
#include "ideotype/physiology/temperature.hpp"
#include "leaf_kernels.hpp"

namespace ideotype {

namespace {

// Functions of one leaf are overloaded for each model. There is no generic
// overload, so a model without one does not compile.

double respiration_of(const HyperbolaLeaf& leaf, double temperature) {
    return leaf.respiration.value_or(0.04 * leaf.response.amax) *
           q10(temperature, 30);
}

double respiration_of(const CollatzLeaf& leaf, double temperature) {
    return dark_respiration(leaf, temperature);
}

double respiration_of(const FarquharLeaf& leaf, double temperature) {
    return dark_respiration(leaf, temperature);
}

//! Returns the asymptote of a hyperbola relative to that at 30 deg C.
double amax_at(double temperature) {
    return c4_temperature_response(temperature) / c4_temperature_response(30);
}

Hyperbola with_amax(const HyperbolaLeaf& leaf, double factor) {
    Hyperbola response = leaf.response;
    response.amax *= factor;
    return response;
}

HyperbolaLeaf scale_one(HyperbolaLeaf leaf, double factor) {
    leaf.response.amax *= factor;
    if (leaf.respiration) *leaf.respiration *= factor;
    return leaf;
}

CollatzLeaf scale_one(CollatzLeaf leaf, double factor) {
    leaf.vmax *= factor;
    leaf.respiration *= factor;
    return leaf;
}

FarquharLeaf scale_one(FarquharLeaf leaf, double factor) {
    for (double* const rate :
         {&leaf.vcmax, &leaf.jmax, &leaf.tpu, &leaf.respiration})
        *rate *= factor;
    return leaf;
}

}  // namespace

LeafRates scaled(const LeafRates& leaf, double factor) {
    IDEOTYPE_EXPECT(factor >= 0);
    return std::visit(
        [&](const auto& each) { return LeafRates(scale_one(each, factor)); },
        leaf);
}

LeafRates without_respiration(LeafRates leaf) {
    std::visit([](auto& each) { each.respiration = 0; }, leaf);
    return leaf;
}

double maintenance_respiration(double maintenance, double temperature) {
    constexpr double umol_per_mol = 1e6, day = 86400;
    return maintenance * carbon_per_carbohydrate * umol_per_mol / day *
           q10(temperature, 25);
}

Hyperbola hyperbola_at(const HyperbolaLeaf& leaf, double temperature) {
    return with_amax(leaf, amax_at(temperature));
}

double dark_respiration(const LeafRates& leaf, double temperature) {
    return std::visit(
        [&](const auto& each) { return respiration_of(each, temperature); },
        leaf);
}

double LeavesInAir::deficit() {
    if (!deficit_) deficit_ = vapour_deficit(air_.temperature, air_.humidity);
    return *deficit_;
}

Hyperbola LeavesInAir::response_of(const HyperbolaLeaf& leaf) {
    if (!of_hyperbola_) of_hyperbola_ = amax_at(air_.temperature);
    return with_amax(leaf, *of_hyperbola_);
}

Colimitation LeavesInAir::response_of(const CollatzLeaf& leaf) {
    if (!of_collatz_) of_collatz_.emplace(air_.temperature);
    return CollatzAt(leaf, *of_collatz_)(ci_of_deficit(deficit()));
}

Colimitation LeavesInAir::response_of(const FarquharLeaf& leaf) {
    if (!of_farquhar_) of_farquhar_.emplace(air_.temperature);
    return FarquharAt(leaf,
                      *of_farquhar_)(ci_of_optimal_stomata(deficit(), leaf.g1));
}

LeafResponse LeavesInAir::response(const LeafRates& leaf) {
    return std::visit(
        [&](const auto& each) { return LeafResponse(response_of(each)); },
        leaf);
}

LeafResponse response(const LeafRates& leaf, const Air& air) {
    return LeavesInAir(air).response(leaf);
}

void gross(const LeafResponse& response, std::span<const double> absorbed,
           double* assimilation) {
    std::visit(
        [&](const auto& each) {
            for (std::size_t i = 0; i < absorbed.size(); ++i)
                assimilation[i] = each.gross(absorbed[i]);
        },
        response);
}

namespace {

IDEOTYPE_FOR_WIDE_VECTORS void expand_response(const Hyperbola& response,
                                               std::size_t count,
                                               const double* light,
                                               double* value, double* slope,
                                               double* curvature) {
    expand_all(response, count, light, value, slope, curvature);
}

IDEOTYPE_FOR_WIDE_VECTORS void expand_response(const Colimitation& response,
                                               std::size_t count,
                                               const double* light,
                                               double* value, double* slope,
                                               double* curvature) {
    expand_all(response, count, light, value, slope, curvature);
}

}  // namespace

void expand(const LeafResponse& response, std::span<const double> absorbed,
            double* assimilation, double* slope, double* curvature) {
    std::visit(
        [&](const auto& each) {
            expand_response(each, absorbed.size(), absorbed.data(),
                            assimilation, slope, curvature);
        },
        response);
}

double leaf_building_cost(double grams_per_area, double carbohydrate_per_gram) {
    return grams_per_area * carbohydrate_per_gram / 30;
}

}  // namespace ideotype
