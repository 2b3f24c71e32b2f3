// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ideotype/core/estimate.hpp"
#include "ideotype/core/mapped.hpp"
#include "ideotype/core/units.hpp"
#include "weather_table.hpp"

namespace ideotype {

namespace {

using namespace std::chrono;

//! Returns the extraterrestrial light on a horizontal plane [W m-2].
double extraterrestrial(const Site& site, ClockTime time) {
    const Date date = date_at(time);
    const double zenith = sun_position(site, date, hour_at(time)).zenith;
    return extraterrestrial_normal(date) *
           std::max(0.0, std::cos(zenith * degree));
}

double correlate(const std::vector<double>& a, const std::vector<double>& b) {
    const double ma = average(a), mb = average(b);
    double aa = 0, bb = 0, ab = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        aa += (a[i] - ma) * (a[i] - ma);
        bb += (b[i] - mb) * (b[i] - mb);
        ab += (a[i] - ma) * (b[i] - mb);
    }
    return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

//! Suggests a remedy for light that is out of step with the sun: another
//! setting of `stamp`, if it would remove the shift.
//! @param late delay of the measured light relative to the computed sun [h]
std::string suggest_remedy(const WeatherTable& table, double late) {
    constexpr double quarter = 0.25;  // Accuracy of the difference [h].
    const double half = duration<double, hours::period>(table.step).count() / 2;
    // The time from a stamp to the middle of its step [h].
    const auto to_middle = [&](Stamp stamp) {
        return stamp == Stamp::beginning ? half
               : stamp == Stamp::end     ? -half
                                         : 0;
    };
    for (const auto& [stamp, name] : {std::pair(Stamp::middle, "middle"),
                                      std::pair(Stamp::beginning, "beginning"),
                                      std::pair(Stamp::end, "end")})
        if (std::abs(to_middle(table.stamp()) - late - to_middle(stamp)) <
            quarter / 2)
            return fmt::format(
                "set stamp = \"{}\" if the times of the file mark that part "
                "of their steps, or check the place and the clock",
                name);
    return "check the place, the clock, and the part of a step that the times "
           "of the file mark (stamp)";
}

//! Compares the light with the sun at the site. The comparison is repeated with
//! the clock shifted in steps of 15 minutes, by up to half a day.
void check_clock(const WeatherTable& table,
                 const std::vector<WeatherStep>& series,
                 const std::vector<double>& measured, Site site,
                 Findings& findings) {
    const double offset = site.utc_offset;
    const auto correlate_at = [&](int quarters) {
        site.utc_offset = offset + quarters / 4.0;
        return correlate(measured, mapped(series, [&](const auto& step) {
                             return extraterrestrial(site, step.middle);
                         }));
    };
    const double unshifted = correlate_at(0);
    double best = unshifted;
    int shift = 0;
    const auto try_it = [&](int quarters) {
        const double r = correlate_at(quarters);
        if (r > best) best = r, shift = quarters;
    };
    // Try whole hours first, then quarters of hours around the best.
    for (int hours = -11; hours <= 12; ++hours) try_it(4 * hours);
    const int coarse = shift;
    for (int quarters = -3; quarters <= 3; ++quarters)
        try_it(coarse + quarters);

    const int line = series.front().line;
    if (best < 0.5)
        findings.stop(line, 1,
                      "the light hardly follows the sun (a correlation of "
                      "{:.2f}); is it the column of the light?",
                      best);
    // Clouds, too, shift the best match, by up to half an hour over ten days.
    const bool long_enough =
        series.back().middle - series.front().middle > 9 * 24h;
    const double hours = std::abs(shift) / 4.0;
    const std::string text = fmt::format(
        "the light comes {:.4g} h {} than the sun of the site (correlation "
        "{:.3f}, and {:.3f} with that shift); {}",
        hours, shift > 0 ? "later" : "earlier", unshifted, best,
        suggest_remedy(table, shift / 4.0));
    if (hours >= (long_enough ? 0.75 : 2)) findings.stop(line, 1, "{}", text);
    if (hours >= (long_enough ? 0.5 : 1)) findings.doubt(line, text, false);
}

//! Compares the light of each day with the extraterrestrial light, and reports
//! days whose light exceeds about 95 % of it.
void check_days(const std::vector<WeatherStep>& series,
                const std::vector<double>& measured, const Site& site,
                Findings& findings) {
    int bright = 0, days_checked = 0, first = 0;
    for (std::size_t i = 0; i < series.size();) {
        const ClockTime day = floor<days>(series[i].middle);
        const int line = series[i].line;
        double light = 0, outside = 0;
        for (; i < series.size() && floor<days>(series[i].middle) == day; ++i) {
            light += measured[i];
            outside += extraterrestrial(site, series[i].middle);
        }
        ++days_checked;
        if (light > 0.95 * outside + 20 * 24 && bright++ == 0) first = line;
    }
    const std::string text = fmt::format(
        "{} of {} days have more light than arrives outside the "
        "atmosphere",
        bright, days_checked);
    if (bright > 0.05 * days_checked)
        findings.stop(first, 1, "{} at this site; check the place and the unit",
                      text);
    if (bright > 0) findings.doubt(first, text, false);
}

//! Returns the fraction of days with a clearness index of at most k, in a month
//! with a mean index of 0.2. Few months of the cloudiest climates are that
//! dark. The distribution is that of Bendt, Collares-Pereira and Rabl (1981,
//! Solar Energy 27, 1-5). Its lowest index is 0.05, its highest that of
//! Hollands and Huget (1983, Solar Energy 30, 195-209).
double fraction_of_darker_days(double k) {
    constexpr double lowest = 0.05, highest = 0.585, gamma = -4.74;
    const double bounded = std::clamp(k, lowest, highest);
    return (std::exp(gamma * lowest) - std::exp(gamma * bounded)) /
           (std::exp(gamma * lowest) - std::exp(gamma * highest));
}

//! Compares the brightest day with the extraterrestrial light. Every day is too
//! dark if the light is in a wrong unit or covers only a part of the spectrum.
void check_brightest(const std::vector<WeatherStep>& series,
                     const std::vector<double>& measured, const Site& site,
                     Findings& findings) {
    // Skip days with less extraterrestrial light on average [W m-2]: in polar
    // winters, twilight contributes much of the light.
    constexpr double enough = 50;
    double brightest = -1;
    int line = 0, days_checked = 0;
    for (std::size_t i = 0; i < series.size();) {
        const ClockTime day = floor<days>(series[i].middle);
        const std::size_t begin = i;
        double light = 0, outside = 0;
        for (; i < series.size() && floor<days>(series[i].middle) == day; ++i) {
            light += measured[i];
            outside += extraterrestrial(site, series[i].middle);
        }
        if (outside < enough * static_cast<double>(i - begin)) continue;
        ++days_checked;
        if (light <= brightest * outside) continue;
        brightest = light / outside;
        line = series[begin].line;
    }
    if (days_checked == 0) return;
    const std::string text = fmt::format(
        "the brightest of {} day{} has {:.2g} of the light outside the "
        "atmosphere",
        days_checked, days_checked == 1 ? "" : "s", brightest);
    const std::string remedy =
        "check the unit, and that the column is all solar radiation";
    // Clouds with an optical thickness of 380 transmit a fraction of 0.02
    // (two-stream solution with an asymmetry of 0.85, without absorption). No
    // such cloud stays for all days.
    constexpr double thickest = 0.02;
    if (brightest < thickest)
        findings.stop(line, 1, "{} (clouds transmit {} or more); {}", text,
                      thickest, remedy);
    // Probability that all days are so dark, assuming that days are
    // independent.
    constexpr double credible = 0.001;
    if (std::pow(fraction_of_darker_days(brightest), days_checked) < credible)
        findings.doubt(line,
                       text +
                           " (even the darkest climates have brighter "
                           "days); " +
                           remedy,
                       false);
}

//! Checks that hardly any light comes at night.
void check_nights(const std::vector<WeatherStep>& series,
                  const std::vector<double>& measured, Findings& findings) {
    double total = 0, at_night = 0;
    for (std::size_t i = 0; i < series.size(); ++i) {
        total += measured[i];
        if (series[i].highest > -6 || measured[i] <= 5) continue;
        at_night += measured[i];
        findings.doubt(
            series[i].line,
            "a step of the night has light, which counts as diffuse");
    }
    if (at_night > 0.01 * total)
        findings.stop(
            series.front().line, 1,
            "{:.1f} % of the light comes at night (with the sun 6 deg below "
            "the horizon or lower); check the place and the clock",
            100 * at_night / total);
}

}  // namespace

void check_place(const WeatherTable& table,
                 const std::vector<WeatherStep>& series,
                 const std::vector<Irradiance>& light, const Site& site,
                 Findings& findings) {
    const std::vector<double> measured = mapped(
        light, [](const Irradiance& step) { return step.beam + step.diffuse; });
    if (*std::max_element(measured.begin(), measured.end()) <= 0)
        return findings.doubt(series.front().line,
                              "the period has no light at all", false);
    check_clock(table, series, measured, site, findings);
    check_days(series, measured, site, findings);
    check_brightest(series, measured, site, findings);
    check_nights(series, measured, findings);
}

}  // namespace ideotype
