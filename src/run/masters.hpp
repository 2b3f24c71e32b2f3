// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "campaign/campaign.hpp"

namespace ideotype {

//! How many ranks evolve cases, each with workers of its own: as many as are
//! wanted, else one, and from 512 ranks on one for some 256, since all its
//! workers wait while a master breeds (tests/scale). Not more than there are
//! cases.
int masters(std::optional<int> wanted, int ranks, int cases);

//! The part of a rank, if ranks and cases are divided into as many parts as
//! there are masters. Each has ranks in proportion to its cases, neighbours, of
//! which the first is the master.
int part_of(int rank, int ranks, int cases, int parts);

//! The cases of a part.
std::vector<Case> dealt(const std::vector<Case>& cases, int part, int parts);

}  // namespace ideotype
