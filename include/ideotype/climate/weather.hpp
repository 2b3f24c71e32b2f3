#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ideotype/climate/day.hpp"

namespace ideotype {

//! Days of a file, both included.
struct Period {
    Date from;
    Date to;
};

//! What a weather file tells about one of its time steps, mostly an hour.
struct WeatherStep {
    Date date;
    TimeStep light;  //!< its hour and sun are those of the middle of the step
    std::optional<double> temperature;  //!< of the air [deg C]
    std::optional<double> humidity;     //!< relative, 0 to 1
};

//! The weather of a period, night included, without gaps and in order.
struct Weather {
    std::string file;
    double utc_offset = 0;  //!< of the clock of dates and hours [h]
    std::vector<WeatherStep> steps;

    int days() const;        //!< dates with a step
    double beam() const;     //!< PAR of all steps [J m-2]
    double diffuse() const;  //!< PAR of all steps [J m-2]
};

}  // namespace ideotype
