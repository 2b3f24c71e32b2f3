// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"

namespace ideotype {

//! The disk space that the histories of a campaign need [bytes].
struct DiskRoom {
    std::uint64_t largest = 0;  //!< largest history of a case
    std::uint64_t all = 0;
};

DiskRoom disk_room(const Campaign& campaign, const Cases& chosen);

//! Checks that the file system of the folder `out` allows the names of all
//! histories.
//! @throws Error (invalid_campaign) that names the first file whose name or
//! path is too long.
void require_names_fit(const Campaign& campaign, const Cases& chosen,
                       const std::string& out);

}  // namespace ideotype
