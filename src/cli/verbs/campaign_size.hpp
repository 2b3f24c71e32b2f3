// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "campaign/campaign.hpp"
#include "cli/formats/json.hpp"

namespace ideotype {

//! The cost of a campaign that no stop rule ends early.
struct CampaignCost {
    //! Measures evaluations of the baseline in a case.
    CampaignCost(const Campaign& campaign, const Case& chosen);

    //! Returns the time of one case [s], whose generations wait for the slowest
    //! worker.
    double of_case(int workers) const;
    //! Returns the time of cases that share a job [s], which fill each other's
    //! gaps.
    double of_cases(std::size_t cases, int workers) const;

    Json json(std::size_t cases) const;

    //! Returns the cost of one case on one core as a line without line break.
    std::string text() const;

    //! Returns a table of the times of one and all cases by number of workers.
    std::string table(std::size_t cases) const;

    //! The times of a usual and a final evaluation on one core here [s].
    double usual = 0, final = 0;
    int population, generations, finalists;
};

//! The least and the greatest of some values.
class Extent {
  public:
    void add(double value) {
        lower_ = std::min(lower_, value);
        upper_ = std::max(upper_, value);
    }

    Json json(double unit = 1) const { return {lower_ / unit, upper_ / unit}; }

    //! Returns "3.44", or "1.90 .. 9.50" if both ends differ in print.
    std::string text(std::string_view form, double unit = 1) const {
        const std::string lower =
            fmt::format(fmt::runtime(form), lower_ / unit);
        const std::string upper =
            fmt::format(fmt::runtime(form), upper_ / unit);
        return lower == upper ? lower : lower + " .. " + upper;
    }

  private:
    double lower_ = std::numeric_limits<double>::infinity();
    double upper_ = -std::numeric_limits<double>::infinity();
};

//! The ranges over the stands of all cases and their scenarios.
struct Stands {
    Extent period_x, period_y;   //!< periods of the cell [m]
    Extent lai;                  //!< LAI of the baseline with other components
    Extent steps, par, diffuse;  //!< number; PAR [J m-2 day-1], diffuse part
    //! A row for each site and day or climate: sun and light.
    std::vector<Json> sky;
};

//! Computes the ranges of a campaign.
//! @param leaf_area mean over all components per place of the field [m2]
Stands stands_of(const Campaign& campaign, double leaf_area);

//! Returns the leaf area of the baseline at each stage, if plants grow.
Json season_of(const Campaign& campaign, const Case& chosen);

//! Returns a line with the objectives.
std::string objective_text(const Campaign& campaign);

//! Returns a line on the photosynthesis and the temperature of leaves, for each
//! component.
std::string leaves_text(const Campaign& campaign);
Json leaves_of(const Campaign& campaign);

//! Returns a line on whether and from when plants grow.
std::string growth_text(const Campaign& campaign, const Case& chosen);

//! Returns a line on the optimizer and the size of the search.
std::string search_text(const Campaign& campaign);
Json search_of(const Campaign& campaign);

}  // namespace ideotype
