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
//! rule of Deb 2000 (doi:10.1016/S0045-7825(99)00389-8), which needs no penalty
//! weights. A failed individual is worse than any other. Of infeasible
//! individuals, the one with the smaller violation is better. A feasible one is
//! better than an infeasible one. Between feasible ones, objective 0 decides.
//! @param sense sense of objective 0
bool is_better(const Individual& a, const Individual& b, Sense sense);

//! Returns the Pareto front of each individual, 0 for individuals that no other
//! dominates, by non-dominated sorting (Deb et al. 2002,
//! doi:10.1109/4235.996017). An individual dominates another if it is no worse
//! in any objective and better in one, if it violates the constraints less, or
//! if only the other failed.
//! @param senses senses of the objectives
std::vector<std::size_t> fronts(const Population& population,
                                const std::vector<Sense>& senses);

//! Returns the crowding distances in a front (Deb et al. 2002): the mean over
//! objectives of the distance between an individual's neighbours, relative to
//! that between the extremes. Extremes have an infinite distance.
//! @param front slots of individuals that did not fail
std::vector<double> crowding(const Population& population,
                             const std::vector<std::size_t>& front,
                             std::size_t objectives);

//! Returns the rank of each individual, 0 for the best; equals share a rank.
//! With one objective is_better() decides; with several, the front and then the
//! crowding distance within it, least crowded first.
std::vector<std::size_t> places(const Population& population,
                                const std::vector<Sense>& senses);

//! Returns all slots by rank; equals keep their order.
std::vector<std::uint32_t> ranking(const Population& population,
                                   const std::vector<Sense>& senses);

//! Returns the slots of the best individuals that did not fail, by places(),
//! best first, each genome once, at most `count`. Equals keep their order.
std::vector<std::uint32_t> best_distinct(const Population& population,
                                         std::size_t count,
                                         const std::vector<Sense>& senses);

//! Selects the best individuals, as best_distinct(), and returns them as
//! candidates with these individuals as parents.
//! @param first_row number of the first row of the population
std::vector<Candidate> select_best(const Population& population,
                                   std::size_t count,
                                   const std::vector<Sense>& senses,
                                   std::int64_t first_row);

}  // namespace ideotype
