// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"

namespace ideotype {

//! Returns the number of masters: ranks that evolve cases, each with workers of
//! its own. It is the number that is wanted, or one for each 1,000 ranks, as
//! many as a master can serve (tests/scale). There are no more than cases.
int masters(std::optional<int> wanted, int ranks, int cases);

//! Returns the part to which a rank belongs, if ranks and cases are divided
//! into as many parts as there are masters. The ranks of a part follow each
//! other, their number is in proportion to the cases of the part, and the first
//! of them is the master.
int part_of(int rank, int ranks, int cases, int parts);

//! Returns the cases of a part.
std::vector<Case> dealt(const std::vector<Case>& cases, int part, int parts);

//! Returns how many workers a search keeps busy. Each worker has four plants
//! under way, so that it has one left while a generation ends (tests/scale).
int busy_workers(const SearchSettings& search, std::size_t cases);

//! Returns advice for a campaign whose workers would wait, or whose searches
//! would have too few generations to learn from because they have many workers
//! or many streams. Returns nothing if all is well.
std::optional<std::string> advice_for(const Campaign& campaign,
                                      std::size_t cases, int workers);

}  // namespace ideotype
