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

//! A range of values.
struct Extent {
    double lower = std::numeric_limits<double>::infinity();
    double upper = -std::numeric_limits<double>::infinity();

    void add(double value) {
        lower = std::min(lower, value);
        upper = std::max(upper, value);
    }
};

//! The mean state of the air above the canopy in a climate.
struct AirOverview {
    double wind, wind_height;   //!< wind [m s-1] at a measurement height [m]
    double pressure, longwave;  //!< [kPa], [W m-2]
    double co2;                 //!< [umol mol-1]
    //! Names of the variables that are estimated.
    std::vector<std::string> estimated;
};

//! The sun and the light at a site, on a day or in a climate.
struct SkyOverview {
    Site site;
    std::string day;      //!< name of the day or climate
    std::size_t days;     //!< number of dates
    Daylight sun;         //!< sun on the middle date
    std::size_t steps;    //!< number of instants or time steps with light
    double par, diffuse;  //!< PAR [J m-2 day-1] and its diffuse part
    double left_out =
        0;  //!< share of the light of a clear day before start and after end
    //! Light-weighted means [deg C, 0 to 1]; nothing if unknown.
    std::optional<double> temperature{}, humidity{};
    //! Air of a climate, if the weather contains any of these variables.
    std::optional<AirOverview> air{};
};

//! An overview of the stands of a campaign, over all cases and scenarios.
struct StandsOverview {
    Extent period_x, period_y;  //!< periods of the cell [m]
    Extent lai;  //!< LAI of the baseline, including other components
    //! One entry for each site and day or climate.
    std::vector<SkyOverview> skies;

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
