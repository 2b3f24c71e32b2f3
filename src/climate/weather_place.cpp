// SPDX-License-Identifier: Apache-2.0
#include "weather_place.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ideotype/core/units.hpp"
#include "weather_problems.hpp"

namespace ideotype {

namespace {

using namespace std::chrono;

constexpr double earth_radius = 6371;  //!< [km]

//! Along the surface [km].
double distance(const Station& a, const Site& b) {
    const double north = std::sin((b.latitude - a.latitude) * degree / 2);
    const double east = std::sin((b.longitude - a.longitude) * degree / 2);
    const double h = north * north + std::cos(a.latitude * degree) *
                                         std::cos(b.latitude * degree) * east *
                                         east;
    return 2 * earth_radius * std::asin(std::min(1.0, std::sqrt(h)));
}

//! Light outside the atmosphere on a horizontal plane [W m-2].
double extraterrestrial(const Site& site, ClockTime time) {
    const Date date = date_at(time);
    const double zenith = sun_position(site, date, hour_at(time)).zenith;
    return extraterrestrial_normal(date) *
           std::max(0.0, std::cos(zenith * degree));
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    double ma = 0, mb = 0;
    for (std::size_t i = 0; i < a.size(); ++i) ma += a[i], mb += b[i];
    ma /= static_cast<double>(a.size());
    mb /= static_cast<double>(a.size());
    double aa = 0, bb = 0, ab = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        aa += (a[i] - ma) * (a[i] - ma);
        bb += (b[i] - mb) * (b[i] - mb);
        ab += (a[i] - ma) * (b[i] - mb);
    }
    return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

double total(const Irradiance& light) {
    return light.beam + light.diffuse;
}

//! Days with more light than almost all of the sun's.
struct Bright {
    int days = 0, all = 0, line = 0;
};

Bright too_bright(const std::vector<SeriesStep>& series,
                  const std::vector<Irradiance>& light, const Site& site) {
    Bright bright;
    for (std::size_t i = 0; i < series.size();) {
        const ClockTime day = floor<days>(series[i].middle);
        const int line = series[i].line;
        double there = 0, most = 0;
        for (; i < series.size() && floor<days>(series[i].middle) == day; ++i) {
            there += total(light[i]);
            most += extraterrestrial(site, series[i].middle);
        }
        ++bright.all;
        if (there <= 0.95 * most + 20 * 24) continue;
        if (bright.days++ == 0) bright.line = line;
    }
    return bright;
}

}  // namespace

std::optional<SunFit> fit_to_sun(const std::vector<SeriesStep>& series,
                                 const std::vector<Irradiance>& light,
                                 Site site) {
    std::vector<double> measured;
    for (const Irradiance& each : light) measured.push_back(total(each));
    if (*std::max_element(measured.begin(), measured.end()) <= 0)
        return std::nullopt;
    // The sun of a clock that is ahead: an offset from UTC that is larger.
    const double offset = site.utc_offset;
    const auto at = [&](int quarters) {
        site.utc_offset = offset + quarters / 4.0;
        std::vector<double> sun;
        for (const SeriesStep& step : series)
            sun.push_back(extraterrestrial(site, step.middle));
        return correlation(measured, sun);
    };
    SunFit fit{0, at(0), 0};
    fit.unshifted = fit.correlation;
    // Hours first, then the quarters around the best of them.
    int best = 0;
    const auto try_it = [&](int quarters) {
        const double r = at(quarters);
        if (r <= fit.correlation) return;
        fit.correlation = r;
        best = quarters;
    };
    for (int hours = -11; hours <= 12; ++hours) try_it(4 * hours);
    const int coarse = best;
    for (int quarters = -3; quarters <= 3; ++quarters)
        try_it(coarse + quarters);
    fit.shift = best / 4.0;
    return fit;
}

void check_place(const std::vector<SeriesStep>& series,
                 const std::vector<Irradiance>& light, double utc_offset,
                 const std::optional<Station>& station,
                 const WeatherRequest& request, Doubts& doubts) {
    Problems problems(request.file);
    Site site = request.site;
    site.utc_offset = utc_offset;
    const int line = series.front().line;
    if (station) {
        const double apart = distance(*station, site);
        const std::string what =
            fmt::format("of {:.2f} N {:.2f} E, {:.0f} km from the site",
                        station->latitude, station->longitude, apart);
        if (apart > 500)
            problems.stop(
                1, 1,
                fmt::format("the file is {} (another climate); choose "
                            "a file of the site",
                            what));
        if (apart > 50) doubts.note(1, "the file is " + what);
    }

    const std::optional<SunFit> fit = fit_to_sun(series, light, site);
    if (!fit) {
        doubts.note(line, "the period has no light at all");
        return;
    }
    if (fit->correlation < 0.5)
        problems.stop(line, 1,
                      fmt::format("the light hardly follows the sun (a "
                                  "correlation of {:.2f}); is it the column of "
                                  "the light?",
                                  fit->correlation));
    // Clouds move it too: up to half an hour in ten days.
    const bool long_enough =
        series.back().middle - series.front().middle > 9 * 24h;
    const std::string shift = fmt::format(
        "the light comes {:.4g} h {} than the sun of the site (correlation "
        "{:.3f}, and {:.3f} with that shift); check the place, the clock, and "
        "which part of a step the stamps name",
        std::abs(fit->shift), fit->shift > 0 ? "later" : "earlier",
        fit->unshifted, fit->correlation);
    if (std::abs(fit->shift) >= (long_enough ? 0.75 : 2))
        problems.stop(line, 1, shift);
    if (std::abs(fit->shift) >= (long_enough ? 0.5 : 1))
        doubts.note(line, shift);

    const Bright bright = too_bright(series, light, site);
    if (bright.days > 0 && bright.days > 0.05 * bright.all)
        problems.stop(
            bright.line, 1,
            fmt::format("{} of {} days have more light than the sun of the "
                        "site outside the atmosphere; check the place and the "
                        "unit",
                        bright.days, bright.all));
    if (bright.days > 0)
        doubts.note(bright.line,
                    fmt::format("{} of {} days have more light than the sun",
                                bright.days, bright.all));

    double all = 0, dark = 0;
    for (std::size_t i = 0; i < series.size(); ++i) {
        all += total(light[i]);
        if (series[i].highest > -6 || total(light[i]) <= 5) continue;
        dark += total(light[i]);
        doubts.count(series[i].line,
                     "a step of the night has light, which counts as diffuse");
    }
    if (dark > 0.01 * all)
        problems.stop(line, 1,
                      fmt::format("{:.1f} % of the light comes at night (with "
                                  "the sun 6 deg below the horizon or lower); "
                                  "check the place and the clock",
                                  100 * dark / all));
}

}  // namespace ideotype
