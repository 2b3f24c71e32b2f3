// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "campaign/campaign.hpp"
#include "json.hpp"

namespace ideotype {

//! The least and the greatest of some values.
class Extent {
  public:
    void add(double value) {
        lower_ = std::min(lower_, value);
        upper_ = std::max(upper_, value);
    }

    Json json(double unit = 1) const { return {lower_ / unit, upper_ / unit}; }

    //! "3.44", or "1.90 .. 9.50" where they differ in what is printed.
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
    Extent period_x, period_y;   //!< [m]
    Extent lai;                  //!< of the baseline
    Extent steps, par, diffuse;  //!< number, [J m-2 day-1], part of it
};

//! Computes the ranges of a campaign.
//! @param leaf_area of the baseline [m2]
Stands stands_of(const Campaign& campaign, double leaf_area);

}  // namespace ideotype
