// SPDX-License-Identifier: Apache-2.0
#include "ideotype/climate/daylight.hpp"

#include <algorithm>
#include <cmath>

namespace ideotype {

namespace {

//! Elevation of the sun [deg] by the local clock.
class Elevation {
  public:
    Elevation(const Site& site, const Date& date) : site_(site), date_(date) {}

    double at(double hour) const {
        return 90 - sun_position(site_, date_, hour).zenith;
    }

    //! The hour of the largest value between two hours, which rises before it
    //! and falls after it.
    double highest(double first, double last) const {
        while (last - first > precision) {
            const double third = (last - first) / 3;
            if (at(first + third) < at(last - third))
                first += third;
            else
                last -= third;
        }
        return (first + last) / 2;
    }

    //! The hour when the sun is at the horizon, if it is above at one of two
    //! hours and below at the other.
    std::optional<double> crossing(double low, double high) const {
        if (at(low) >= 0 || at(high) < 0) return std::nullopt;
        while (std::abs(high - low) > precision) {
            const double middle = (low + high) / 2;
            (at(middle) < 0 ? low : high) = middle;
        }
        return high;
    }

  private:
    static constexpr double precision = 1e-4;  //!< [h]

    const Site& site_;
    const Date& date_;
};

//! The equation of time is below 17 minutes; far north and south the sun's
//! declination moves the highest place a little.
constexpr double largest_shift = 1;  //!< [h]

}  // namespace

Daylight daylight(const Site& site, const Date& date) {
    const Elevation elevation(site, date);
    const double mean_noon = 12 + clock_ahead(site);
    Daylight day;
    day.noon =
        elevation.highest(mean_noon - largest_shift, mean_noon + largest_shift);
    day.elevation = elevation.at(day.noon);
    day.sunrise = elevation.crossing(day.noon - 12, day.noon);
    day.sunset = elevation.crossing(day.noon + 12, day.noon);
    return day;
}

double clock_ahead(const Site& site) {
    return std::remainder(site.utc_offset - site.longitude / 15, 24);
}

double share_left_out(const Site& site, const DaySpan& span) {
    constexpr int instants = 24 * 60;
    const double midnight = clock_ahead(site);
    double all = 0, kept = 0;
    for (const Date& date : span.dates)
        for (int i = 0; i < instants; ++i) {
            const double hour = midnight + (i + 0.5) * 24 / instants;
            const Irradiance light =
                clear_sky(site, date, sun_position(site, date, hour));
            const double sum = light.beam + light.diffuse;
            all += sum;
            if (hour > span.start && hour < span.end) kept += sum;
        }
    return all > 0 ? 1 - kept / all : 0;
}

}  // namespace ideotype
