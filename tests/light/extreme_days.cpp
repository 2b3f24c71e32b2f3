// SPDX-License-Identifier: Apache-2.0
// Extreme days and numbers of paths.
#include <cmath>
#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include "extremes.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/light/report.hpp"
#include "ideotype/light/sampler.hpp"

namespace ideotype {

namespace {

//! Returns a site where clocks show solar time.
Site at_latitude(double latitude) {
    return {"somewhere", latitude, 0, 0};
}

//! Returns the daily light absorbed by leaves in rows of maize under a clear
//! sky.
double leaves_over_day(Findings& findings, const LightSeries& day) {
    const SeriesIllumination illumination =
        illuminate(day, SkyModel::clear, 90);
    const Mesh mesh = load_reference_mesh("maize1");
    const Fractions f =
        findings.closing(mesh, own_cell, par, illumination.light, {512, 4});
    findings.require(f.leaves.mean > .8 && f.leaves.mean < 1,
                     "leaves absorb 0.8 to 1");
    return f.leaves.mean;
}

void trace_days(Findings& findings, const std::vector<double>& latitudes,
                const std::vector<Date>& dates) {
    for (const double latitude : latitudes)
        for (const Date& date : dates) {
            const LightSeries day =
                clear_days(at_latitude(latitude), {{date}, 0, 24, 60}, .45);
            if (day.steps.empty()) continue;
            findings.say(fmt::format("{} deg: {} h, {:.3f}", latitude,
                                     day.steps.size(),
                                     leaves_over_day(findings, day)));
        }
}

void solstice(Findings& findings) {
    trace_days(findings, {-90, -66.6, -42, 0, 42, 66.6, 90}, {{2025, 6, 21}});
}

void leap_day(Findings& findings) {
    trace_days(findings, {-42, 42}, {{2024, 2, 29}});
    const auto incident = [](const Date& date) {
        return clear_days(at_latitude(42), {{date}, 0, 24, 60}, .45).incident();
    };
    const double between =
        (incident({2024, 2, 28}) + incident({2024, 3, 1})) / 2;
    findings.require(std::abs(incident({2024, 2, 29}) / between - 1) < 1e-3,
                     "the light is between that of 28 February and 1 March");
}

void polar_night(Findings& findings) {
    for (const auto& [latitude, date] :
         {std::pair{78., Date{2025, 12, 21}}, {-78., Date{2025, 6, 21}}}) {
        const LightSeries day =
            clear_days(at_latitude(latitude), {{date}, 0, 24, 60}, .45);
        findings.require(day.steps.empty(), "no instant has light");
        const SeriesIllumination light = illuminate(day, SkyModel::uniform, 90);
        const Mesh mesh = load_reference_mesh("maize1");
        const RayScene scene(widest_device(), mesh, own_cell.x, own_cell.y);
        const DayReport result = report(
            simulate(scene, mesh.groups, par, light.light, {64, 2}, {}), light);
        findings.require(result.day.incident == 0 &&
                             result.day.leaves.mean == 0 &&
                             result.day.leaves.standard_error == 0 &&
                             result.balance_error == 0,
                         "all is zero");
    }
    findings.say("zeros");
}

void sunrise_between_steps(Findings& findings) {
    // At latitude 66 the sun may rise at any point between two steps, or just
    // before one.
    const Site site = at_latitude(66);
    const Date date{2025, 12, 15};
    const double fine = clear_days(site, {{date}, 0, 24, 1}, .45).incident();
    for (const double step : {60., 20., 5.}) {
        const LightSeries day = clear_days(site, {{date}, 0, 24, step}, .45);
        findings.require(!day.steps.empty(), "the sun rises");
        for (const TimeStep& instant : day.steps)
            findings.require(instant.sun.zenith < 90, "only suns that are up");
        leaves_over_day(findings, day);
        findings.say(fmt::format("every {} min {:.3f} of the light", step,
                                 day.incident() / fine));
    }
}

void one_path(Findings& findings) {
    const Mesh mesh = load_reference_mesh("maize1");
    findings.closing(mesh, own_cell, par, uniform_sky(), {1, 2});
    findings.closing(mesh, own_cell, par, sun_from(.01, 0), {1, 2});
}

void paths_beyond_two_to_the_32(Findings& findings) {
    // Path p of randomisation r is number r x paths + p.
    const Mesh mesh = load_reference_mesh("maize1");
    const RayScene scene(widest_device(), mesh, own_cell.x, own_cell.y);
    const Accuracy accuracy{4096, 16};
    const auto at = [&](std::uint32_t first) {
        const Fractions f =
            fractions_of(simulate(scene, mesh.groups, par, uniform_sky(),
                                  accuracy, {1, 0, first}),
                         mesh.groups.size(), 1);
        findings.require_closed(f);
        return f.leaves;
    };
    const Estimate near = at(0);
    for (const std::uint32_t first :
         {std::uint32_t{1} << 20,
          std::numeric_limits<std::uint32_t>::max() - 64}) {
        findings.require_agreement(at(first), near, 1e-3,
                                   fmt::format("from {}", first));
        findings.require(at(first).mean != near.mean, "other paths");
    }
}

void last_paths_of_the_largest_net(Findings& findings) {
    // The first and the last points of a net of 2^31 paths. Each block of 2^16
    // consecutive points that begins at a multiple of 2^16 is a net in every
    // dimension.
    constexpr std::uint32_t paths = std::uint32_t{1} << 31;
    constexpr std::uint32_t some = 1 << 16;
    PathSampler sampler(1, 0, 0, paths);
    for (const std::uint32_t begin : {std::uint32_t{0}, paths - some}) {
        std::vector<double> sums(path_dimensions + 4, 0.);
        for (std::uint32_t p = begin; p < begin + some; ++p) {
            sampler.begin(p);
            for (double& sum : sums) {
                const double x = sampler.next();
                findings.require(x >= 0 && x < 1, "numbers are in [0, 1)");
                sum += x / some;
            }
        }
        // The standard deviation of means of independent random numbers is
        // 0.0011.
        for (const double mean : sums)
            findings.require(std::abs(mean - .5) < .005, "means are 1/2");
    }
    findings.say("in [0, 1), means 1/2");
}

void too_few_paths(Findings& findings) {
    const Mesh mesh = load_reference_mesh("sheets1");
    const RayScene scene(widest_device(), mesh, 1, 1);
    for (const int paths : {0, -1, std::numeric_limits<int>::min()}) {
        bool is_refused = false;
        try {
            simulate(scene, mesh.groups, par, uniform_sky(), {paths, 2}, {});
        } catch (const Error&) {
            is_refused = true;
        }
        findings.require(is_refused, fmt::format("{} is refused", paths));
    }
    findings.say("refused");
}

}  // namespace

std::vector<ExtremeCase> extreme_days_and_paths() {
    return {{"21 June from pole to pole", "leaves absorb 0.8 to 1", solstice},
            {"leap day, both hemispheres", "between its neighbours", leap_day},
            {"polar night, both hemispheres", "zeros, no NaN", polar_night},
            {"sun that rises between two steps", "leaves absorb 0.8 to 1",
             sunrise_between_steps},
            {"1 path", "finite", one_path},
            {"path indices beyond 2^32", "the same within standard errors",
             paths_beyond_two_to_the_32},
            {"ends of a net of 2^31 paths", "uniform in [0, 1)",
             last_paths_of_the_largest_net},
            {"paths 0, -1, -2^31", "refused", too_few_paths}};
}

}  // namespace ideotype
