// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "population.hpp"

namespace ideotype {

//! Compares values of an objective.
bool is_better(double a, double b, Sense sense);

//! The feasibility rule of Deb 2000 (doi:10.1016/S0045-7825(99)00389-8),
//! without weights to tune: a failed individual is worse than any other; of
//! those that violate constraints the one with the smaller violation is better;
//! one that violates none is better than they are; of those that violate none,
//! objective 0 decides.
//! @param sense of objective 0
bool is_better(const Individual& a, const Individual& b, Sense sense);

//! Non-dominated sorting (Deb et al. 2002, doi:10.1109/4235.996017): the front
//! of each individual, 0 for those that no other dominates. One dominates
//! another if it is no worse in any objective and better in one; if it fails
//! the constraints less; or if only the other's evaluation failed.
//! @param senses of the objectives
std::vector<std::size_t> fronts(const Population& population,
                                const std::vector<Sense>& senses);

//! Crowding distances in a front (ibid.): the mean over objectives of the way
//! between the neighbours of each, relative to that between the extremes.
//! Infinite for the extremes.
//! @param front slots of individuals that did not fail
std::vector<double> crowding(const Population& population,
                             const std::vector<std::size_t>& front,
                             std::size_t objectives);

//! The place of each individual, 0 for the best; equals share one. With one
//! objective as is_better() says, with several by front and then, the least
//! crowded first, within it.
std::vector<std::size_t> places(const Population& population,
                                const std::vector<Sense>& senses);

//! All slots by place; equals keep their order.
std::vector<std::uint32_t> ranking(const Population& population,
                                   const std::vector<Sense>& senses);

//! Slots of the best individuals that did not fail, as places() has them, best
//! first, each genome once; fewer than `count` if there are not so many. Equals
//! keep their order.
std::vector<std::uint32_t> best_distinct(const Population& population,
                                         std::size_t count,
                                         const std::vector<Sense>& senses);

//! The same as candidates whose parents they are.
//! @param first_row of the population
std::vector<Candidate> best_of(const Population& population, std::size_t count,
                               const std::vector<Sense>& senses,
                               std::int64_t first_row);

}  // namespace ideotype
