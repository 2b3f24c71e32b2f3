// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "population.hpp"

namespace ideotype {

//! Returns whether one value of an objective is better than another.
bool is_better(double a, double b, Sense sense);

//! Returns whether one individual is better than another by the feasibility
//! rule of Deb 2000 (doi:10.1016/S0045-7825(99)00389-8), which has no weights
//! to tune: a failed individual is worse than any other; of those that violate
//! constraints the one with the smaller violation is better; one that violates
//! none is better than they are; of those that violate none, objective 0
//! decides.
//! @param sense of objective 0
bool is_better(const Individual& a, const Individual& b, Sense sense);

//! Returns the front of each individual, 0 for those that no other dominates,
//! by non-dominated sorting (Deb et al. 2002, doi:10.1109/4235.996017). One
//! dominates another if it is no worse in any objective and better in one; if
//! it fails the constraints less; or if only the other's evaluation failed.
//! @param senses of the objectives
std::vector<std::size_t> fronts(const Population& population,
                                const std::vector<Sense>& senses);

//! Returns the crowding distances in a front (ibid.): the mean over objectives
//! of the way between the neighbours of each, relative to that between the
//! extremes. The distance of the extremes is infinite.
//! @param front slots of individuals that did not fail
std::vector<double> crowding(const Population& population,
                             const std::vector<std::size_t>& front,
                             std::size_t objectives);

//! Returns the place of each individual, 0 for the best; equals share one. With
//! one objective is_better() decides; with several the front does and then, the
//! least crowded first, the crowding within it.
std::vector<std::size_t> places(const Population& population,
                                const std::vector<Sense>& senses);

//! Returns all slots by place; equals keep their order.
std::vector<std::uint32_t> ranking(const Population& population,
                                   const std::vector<Sense>& senses);

//! Returns the slots of the best individuals that did not fail, by places(),
//! best first, each genome once; fewer than `count` if there are not so many.
//! Equals keep their order.
std::vector<std::uint32_t> best_distinct(const Population& population,
                                         std::size_t count,
                                         const std::vector<Sense>& senses);

//! Returns the best individuals, as best_distinct() chooses them, as candidates
//! whose parents they are.
//! @param first_row of the population
std::vector<Candidate> best_of(const Population& population, std::size_t count,
                               const std::vector<Sense>& senses,
                               std::int64_t first_row);

}  // namespace ideotype
