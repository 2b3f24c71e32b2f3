// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"

namespace ideotype {

//! Returns the number of masters: ranks that evolve cases, each with a separate
//! group of workers. It is the requested number or one per 1,000 ranks, which a
//! master can serve (tests/scale), but not more than the number of cases.
int masters(std::optional<int> wanted, int ranks, int cases);

//! Divides ranks and cases into one part per master, and returns the part to
//! which a rank belongs. The ranks of a part are consecutive, and proportional
//! in number to its cases; the first of them is the master.
int part_of(int rank, int ranks, int cases, int parts);

//! A range of consecutive cases.
struct Share {
    std::size_t first = 0, count = 0;
};

//! Returns the cases of a part.
Share dealt(int cases, int part, int parts);

//! Returns the number of workers that searches keep busy. If a generation has
//! four plants per worker, each worker still has one while the generation ends
//! (tests/scale).
int busy_workers(const SearchSettings& search, std::size_t cases);

//! Returns advice if workers of a campaign would be idle, or if many workers or
//! streams would leave searches too few generations to learn from. Returns
//! nothing if neither applies.
std::optional<std::string> advice_for(const Campaign& campaign,
                                      std::size_t cases, int workers);

}  // namespace ideotype
