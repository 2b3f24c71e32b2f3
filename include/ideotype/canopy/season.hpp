// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace ideotype {

//! Numbers of a season, by randomisation, and if they are also by date:
//! [randomisation, date].
using ByRandomisation = std::vector<double>;
using ByDate = std::vector<std::vector<double>>;

//! The part of the water of a season's soil that one stage of growing plants
//! reports, so that sums over stages are those of the season: all from the last
//! stage, and each day from the stage that represents most of it.
struct SeasonWater {
    ByRandomisation evaporation, drainage, runoff, irrigation, rain;  //!< [mm]
    ByRandomisation soil_water;  //!< mean of the season [mm]
    //! Transpiration that stress prevents, over that with enough water.
    ByRandomisation stress;
    ByDate evaporation_of_dates, soil_water_of_dates;  //!< [mm]
};

//! The part of a season's grain that one stage reports, as SeasonWater.
struct SeasonGrain {
    ByRandomisation kernels;  //!< [m-2]
    ByRandomisation mass;     //!< dry mass [kg m-2]
    ByRandomisation harvest_index;
    ByDate mass_of_dates, shoot_of_dates;  //!< dry mass in the evening [kg m-2]
};

}  // namespace ideotype
