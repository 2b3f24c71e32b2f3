// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"

namespace ideotype {

//! Returns the number of masters: ranks that evolve cases, each with workers of
//! its own. It is the wanted number, or one for each 1,000 ranks, which a
//! master can serve (tests/scale), but at most the number of cases.
int masters(std::optional<int> wanted, int ranks, int cases);

//! Returns the part to which a rank belongs, if ranks and cases are divided
//! into one part for each master. The ranks of a part are consecutive, in
//! proportion to its number of cases, and the first rank is the master.
int part_of(int rank, int ranks, int cases, int parts);

//! Consecutive cases.
struct Share {
    std::size_t first = 0, count = 0;
};

//! Returns the share of a part in all cases.
Share dealt(int cases, int part, int parts);

//! Returns the number of workers that a search keeps busy. Four plants under
//! way for each worker leave it one while a generation ends (tests/scale).
int busy_workers(const SearchSettings& search, std::size_t cases);

//! Returns advice for a campaign whose workers would wait, or whose searches
//! would have too few generations to learn from because they have many workers
//! or many streams. Returns nothing if all is well.
std::optional<std::string> advice_for(const Campaign& campaign,
                                      std::size_t cases, int workers);

}  // namespace ideotype
