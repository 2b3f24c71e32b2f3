// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"

namespace ideotype {

//! Returns the number of masters, the ranks that evolve cases with a separate
//! group of workers each. It is the wanted number or one per 1,000 ranks, which
//! a master can serve (tests/scale), and at most the number of cases.
int masters(std::optional<int> wanted, int ranks, int cases);

//! Returns the part to which a rank belongs, if ranks and cases are divided
//! into one part per master. The ranks of a part are consecutive, in proportion
//! to its number of cases; the first one is the master.
int part_of(int rank, int ranks, int cases, int parts);

//! A range of consecutive cases.
struct Share {
    std::size_t first = 0, count = 0;
};

//! Returns the cases of a part.
Share dealt(int cases, int part, int parts);

//! Returns the number of workers that searches keep busy. With four plants per
//! worker in a generation, each still has one while the generation ends
//! (tests/scale).
int busy_workers(const SearchSettings& search, std::size_t cases);

//! Returns advice for a campaign in which workers would be idle, or in which
//! searches would have too few generations to learn from because of many
//! workers or streams. Returns nothing if neither applies.
std::optional<std::string> advice_for(const Campaign& campaign,
                                      std::size_t cases, int workers);

}  // namespace ideotype
