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
//! weights. A failed individual is worse than any other. A feasible individual
//! is better than an infeasible one. Between infeasible individuals, the
//! smaller violation is better; between feasible ones, the better objective 0.
//! @param sense whether objective 0 is maximised or minimised
bool is_better(const Individual& a, const Individual& b, Sense sense);

//! Returns the index of each individual's Pareto front, by non-dominated
//! sorting (Deb et al. 2002, doi:10.1109/4235.996017). The index is 0 for
//! individuals that no other dominates. An individual dominates another if it
//! is no worse in any objective and better in one, if it violates the
//! constraints less, or if only the other failed.
//! @param senses whether each objective is maximised or minimised
std::vector<std::size_t> fronts(const Population& population,
                                const std::vector<Sense>& senses);

//! Returns the crowding distances of individuals in a front (Deb et al. 2002).
//! This is the distance between an individual's two neighbours, relative to the
//! distance between the extremes, averaged over objectives. Extremes have an
//! infinite distance.
//! @param front slots of individuals that did not fail
std::vector<double> crowding(const Population& population,
                             const std::vector<std::size_t>& front,
                             std::size_t objectives);

//! Returns the rank of each individual, 0 for the best; equal individuals share
//! a rank. One objective is ranked by is_better(). Several are ranked by front,
//! and within a front by crowding distance, least crowded first.
std::vector<std::size_t> places(const Population& population,
                                const std::vector<Sense>& senses);

//! Returns all slots by rank; equal individuals keep their order.
std::vector<std::uint32_t> ranking(const Population& population,
                                   const std::vector<Sense>& senses);

//! Returns the slots of the best individuals by places(), best first and at
//! most `count`. Failed individuals and repeated genomes are left out. Equal
//! individuals keep their order.
std::vector<std::uint32_t> best_distinct(const Population& population,
                                         std::size_t count,
                                         const std::vector<Sense>& senses);

//! Selects the best individuals with best_distinct(), and returns candidates
//! that have these individuals as parents.
//! @param first_row number of the first row of the population
std::vector<Candidate> select_best(const Population& population,
                                   std::size_t count,
                                   const std::vector<Sense>& senses,
                                   std::int64_t first_row);

}  // namespace ideotype
