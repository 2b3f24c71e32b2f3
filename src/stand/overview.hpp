// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "ideotype/climate/sun.hpp"

namespace ideotype {

//! The range of some values.
struct Extent {
    double lower = std::numeric_limits<double>::infinity();
    double upper = -std::numeric_limits<double>::infinity();

    void add(double value) {
        lower = std::min(lower, value);
        upper = std::max(upper, value);
    }
};

//! The mean air of a climate above the canopy.
struct AirOverview {
    double wind, wind_height;            //!< wind [m s-1] at a height [m]
    double pressure, longwave;           //!< [kPa], [W m-2]
    double co2;                          //!< [umol mol-1]
    std::vector<std::string> estimated;  //!< names of estimated variables
};

//! The sun and the light at a site on a day or in a climate.
struct SkyOverview {
    Site site;
    std::string day;      //!< name of the day or climate
    std::size_t days;     //!< number of dates
    Daylight sun;         //!< sun on the middle date
    std::size_t steps;    //!< number of instants or time steps with light
    double par, diffuse;  //!< PAR [J m-2 day-1] and its diffuse part
    double left_out =
        0;  //!< share of the light of a clear day outside start and end
    //! Means weighted by light [deg C, 0 to 1]; nothing if unknown.
    std::optional<double> temperature{}, humidity{};
    //! Air of a climate, if the weather states any of it.
    std::optional<AirOverview> air{};
};

//! An overview of the stands of all cases of a campaign and of their scenarios.
struct StandsOverview {
    Extent period_x, period_y;  //!< periods of the cell [m]
    Extent lai;                 //!< LAI of the baseline with other components
    std::vector<SkyOverview> skies;  //!< one for each site and day or climate

    //! Returns the range of a number over all skies.
    Extent over_skies(const auto& number) const {
        Extent extent;
        for (const SkyOverview& each : skies) extent.add(number(each));
        return extent;
    }
};

//! @param leaf_area mean leaf area over all components per planting position
//! [m2]
StandsOverview overview_of(const Campaign& campaign, double leaf_area);

//! The stand of the baseline at a stage of growth.
struct StageOverview {
    std::string climate;
    Date emergence;
    Stage stage;
    double green = 0, dead = 0;  //!< leaf area index
};

//! Returns the stages of a case, if plants grow.
std::vector<StageOverview> stages_overview(const Campaign& campaign,
                                           const Case& chosen);

}  // namespace ideotype
