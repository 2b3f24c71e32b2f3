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

//! Prices of a season, in any currency.
struct Prices {
    double grain = 0;                //!< of grain with market_moisture [t-1]
    double seed = 0;                 //!< of each plant that is sown
    double water = 0;                //!< of irrigation [m-3]
    double electricity = 0;          //!< of panels [kWh-1]
    double module_efficiency = 0.2;  //!< electricity over light on panels
    double other = 0;                //!< of all other costs [ha-1]
};

//! The part of a season's revenue and costs that one stage reports. Those of
//! the season as a whole belong to the last stage.
struct SeasonPrices {
    Prices prices;
    double days = 0;   //!< days of the season
    double seeds = 0;  //!< plants that are sown, reported by the stage [m-2]
    double share = 0;  //!< 1 for the last stage, otherwise 0
};

}  // namespace ideotype
