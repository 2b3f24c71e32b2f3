// SPDX-License-Identifier: Apache-2.0
#pragma once

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
