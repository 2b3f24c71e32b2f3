// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "population.hpp"

namespace ideotype {

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

}  // namespace ideotype
