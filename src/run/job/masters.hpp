// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"

namespace ideotype {

//! Returns how many ranks evolve cases, each with workers of its own: as many
//! as are wanted, else one for each 1,000 ranks, which is what a master can
//! serve (tests/scale). Not more than there are cases.
int masters(std::optional<int> wanted, int ranks, int cases);

//! Returns the part of a rank, if ranks and cases are divided into as many
//! parts as there are masters. Each has ranks in proportion to its cases,
//! neighbours, of which the first is the master.
int part_of(int rank, int ranks, int cases, int parts);

//! Returns the cases of a part.
std::vector<Case> dealt(const std::vector<Case>& cases, int part, int parts);

//! Returns how many workers a search keeps busy: each has four plants under
//! way, so that it finds another one while a generation ends (tests/scale).
int busy_workers(const SearchSettings& search, std::size_t cases);

//! Advises what to change where workers would wait, or where a search on
//! many workers, or each of so many streams, has too few generations to learn
//! from; none if all is well.
std::optional<std::string> advice_for(const Campaign& campaign,
                                      std::size_t cases, int workers);

}  // namespace ideotype
