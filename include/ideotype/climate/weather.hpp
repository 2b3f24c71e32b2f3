// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "ideotype/climate/light_series.hpp"

namespace ideotype {

//! Days of a file, both included.
struct Period {
    Date from;
    Date to;
};

//! The weather of a period, night included, without gaps.
struct Weather {
    std::string file;
    double utc_offset = 0;  //!< of the clock of dates and hours [h]
    //! Hours and suns are those of the middle of each step.
    LightSeries series;
};

}  // namespace ideotype
