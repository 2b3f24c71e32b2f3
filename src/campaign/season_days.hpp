// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "campaign.hpp"
#include "ideotype/climate/sun.hpp"

namespace ideotype {

//! A day of the season of growing plants.
struct SeasonDay {
    Date date{};
    double thermal_time = 0;  //!< of the main crop in the middle of the day
    double rain = 0;          //!< [mm]
    double reference =
        0;  //!< reference_evapotranspiration() [mm]; with [water]
    //! Growth of kernels over that at the best temperature, see filling_rate().
    double filling = 0;
    //! Dry matter of ears that maintenance respires, as a fraction.
    double ear_maintenance = 0;
};

//! Returns the days from emergence to maturity or to the end of the period.
std::vector<SeasonDay> season_days(const Campaign& campaign,
                                   const Case& scenario);

//! Returns whether grain is modelled: of a crop with [grain] that grows alone.
bool fills_grain(const Campaign& campaign);

}  // namespace ideotype
