#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "ideotype/search/population.hpp"

namespace ideotype {

//! For each slot whose genome stands in an earlier slot too: that slot. Under
//! common random numbers both have the same outcome.
std::map<std::uint32_t, std::uint32_t> duplicates(
    const std::vector<Candidate>& candidates);

}  // namespace ideotype
