// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"

namespace ideotype {

//! The disk space of the histories of a campaign [bytes].
struct DiskRoom {
    std::uint64_t largest = 0;  //!< largest file of a case
    std::uint64_t all = 0;
};

DiskRoom disk_room(const Campaign& campaign, const Cases& chosen);

//! @throws Error (invalid_campaign) naming the first file whose name or path is
//! too long for the file system of the folder `out`.
void require_names_fit(const Campaign& campaign, const Cases& chosen,
                       const std::string& out);

}  // namespace ideotype
