// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "weather_light.hpp"

namespace ideotype {

//! How the light of a file fits to the sun of a site that shines by a clock
//! which is ahead by some hours.
struct SunFit {
    double shift = 0;        //!< [h] at which the fit is best; later: positive
    double correlation = 0;  //!< of light and sun, best
    double unshifted = 0;    //!< the same without a shift
};

//! Compares light with the extraterrestrial of a site, at shifts of a quarter
//! of an hour up to half a day. Nothing if there is no light.
std::optional<SunFit> fit_to_sun(const std::vector<SeriesStep>& series,
                                 const std::vector<Irradiance>& light,
                                 Site site);

//! Stops or warns if the light is hardly that of the site.
//! @throws InputError
void check_place(const std::vector<SeriesStep>& series,
                 const std::vector<Irradiance>& light, double utc_offset,
                 const std::optional<Station>& station,
                 const WeatherRequest& request, Doubts& doubts);

}  // namespace ideotype
