#pragma once

#include <cstdint>
#include <vector>

#include "ideotype/search/population.hpp"

namespace ideotype {

//! A higher fitness is better; a failed individual is worse than any other.
bool is_better(const Individual& a, const Individual& b);

//! Slots of the best individuals that did not fail, best first, each genome
//! once; fewer than `count` if there are not so many. Equals keep their order.
std::vector<std::uint32_t> best_distinct(const Population& population,
                                         std::size_t count);

}  // namespace ideotype
