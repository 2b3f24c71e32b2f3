// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "campaign/campaign.hpp"
#include "cli/formats/json.hpp"
#include "run/campaign_cost.hpp"
#include "stand/overview.hpp"

namespace ideotype {

Json json_of(const CampaignCost& cost, std::size_t cases);

//! Returns a line with the cost of one case on one core.
std::string cost_text(const CampaignCost& cost);

//! Returns a table with the time for one case and for all cases, by number of
//! workers.
std::string cost_table(const CampaignCost& cost, std::size_t cases);

inline Json json_of(const Extent& extent, double unit = 1) {
    return {extent.lower / unit, extent.upper / unit};
}

//! Formats a range as "1.90 .. 9.50", or as "3.44" if both ends would be
//! printed alike.
inline std::string text_of(const Extent& extent, std::string_view form,
                           double unit = 1) {
    const std::string lower =
        fmt::format(fmt::runtime(form), extent.lower / unit);
    const std::string upper =
        fmt::format(fmt::runtime(form), extent.upper / unit);
    return lower == upper ? lower : lower + " .. " + upper;
}

//! Returns a table row for each sky.
std::vector<Json> rows_of(const std::vector<SkyOverview>& skies,
                          bool are_climates);

//! Returns a table row for each stage.
Json rows_of(const std::vector<StageOverview>& stages);

//! Returns the line about objectives.
std::string objective_text(const Campaign& campaign);

//! Returns a line about photosynthesis and leaf temperature for each component.
std::string leaves_text(const Campaign& campaign);
Json leaves_of(const Campaign& campaign);

//! Returns the line about growth: the emergence date and stages, or none.
std::string growth_text(const Campaign& campaign, const Case& chosen);

//! Returns the line about the optimizer and the size of the search.
std::string search_text(const Campaign& campaign);
Json search_of(const Campaign& campaign);

}  // namespace ideotype
