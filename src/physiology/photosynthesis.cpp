// SPDX-License-Identifier: Apache-2.0
#include "ideotype/physiology/photosynthesis.hpp"

#include <fmt/format.h>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/points.hpp"

namespace ideotype {

namespace {

//! Returns the value at a leaf by interpolation from the lowest leaf to the
//! highest.
double at_rank(const std::vector<double>& points, std::size_t leaf,
               std::size_t leaves) {
    IDEOTYPE_EXPECT(!points.empty());
    return value_between(
        points, leaves < 2 ? 0
                           : static_cast<double>(leaf * (points.size() - 1)) /
                                 static_cast<double>(leaves - 1));
}

std::vector<double> capacities(const Photosynthesis& photosynthesis,
                               const std::vector<double>& leaf_area_index) {
    const CanopyNitrogen& canopy = photosynthesis.nitrogen;
    switch (photosynthesis.profile) {
        case CapacityProfile::exponential:
            return exponential_profile(leaf_area_index, canopy.kn);
        case CapacityProfile::nitrogen: {
            std::vector<double> all =
                nitrogen_of_leaves(leaf_area_index, canopy);
            for (double& x : all) x = nitrogen_response(x);
            return all;
        }
        case CapacityProfile::rank: {
            std::vector<double> all;
            for (std::size_t i = 0; i < leaf_area_index.size(); ++i)
                all.push_back(at_rank(photosynthesis.rank_capacity, i,
                                      leaf_area_index.size()));
            return all;
        }
        case CapacityProfile::none:
            break;
    }
    return std::vector(leaf_area_index.size(), 1.);
}

}  // namespace

std::vector<LeafRates> rates_of_leaves(
    const Photosynthesis& photosynthesis,
    const std::vector<double>& leaf_area_index) {
    const std::vector<LeafRates>& given = photosynthesis.rates;
    const std::size_t leaves = leaf_area_index.size();
    if (given.size() != 1 && given.size() != leaves)
        throw Error(
            fmt::format("photosynthesis has rates for {} leaves, but the plant "
                        "has {}; give one for each leaf",
                        given.size(), leaves));
    const std::vector<double> factors =
        capacities(photosynthesis, leaf_area_index);
    std::vector<LeafRates> result;
    for (std::size_t i = 0; i < leaves; ++i)
        result.push_back(scaled(given[given.size() == 1 ? 0 : i], factors[i]));
    return result;
}

}  // namespace ideotype
