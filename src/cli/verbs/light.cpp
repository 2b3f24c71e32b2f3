// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>

#include "cli/formats/light_output.hpp"
#include "cli/verbs.hpp"
#include "run/progress.hpp"
#include "stand/mesh_study.hpp"

namespace ideotype {

namespace {

std::string light_name(const MeshOptions& options) {
    if (!options.climate.empty()) return "mean day of " + options.climate;
    if (options.site)
        return fmt::format("clear day {} at {} N {} E, UTC {:+}",
                           to_string(*options.date), options.site->latitude,
                           options.site->longitude, options.site->utc_offset);
    if (options.sun && options.sky && options.beam_ppfd)
        return fmt::format("sun at elevation {} and azimuth {}, and sky",
                           90 - options.sun->zenith, options.sun->azimuth);
    if (options.sky)
        return *options.sky == SkyModel::uniform    ? "uniform sky"
               : *options.sky == SkyModel::overcast ? "overcast sky"
                                                    : "clear sky";
    return fmt::format("sun at elevation {} and azimuth {}",
                       90 - options.sun->zenith, options.sun->azimuth);
}

//! Returns the largest relative error of the leaves' light in any band;
//! infinite if no path has met a leaf.
double relative_error(const MeshReport& report) {
    double largest = 0;
    for (const BandReport& band : report.canopy.bands) {
        const Estimate& leaves = band.light.day.leaves;
        if (leaves.standard_error > 0)
            largest = std::max(largest, leaves.standard_error / leaves.mean);
    }
    return largest;
}

void warn_of_tolerance(const MeshReport& report, double tolerance) {
    const double error = relative_error(report);
    fmt::print(stderr, "ideotype: warning: {} after the most paths ({}); ",
               std::isfinite(error)
                   ? fmt::format("the relative standard error is {:.2g}, not "
                                 "{:.2g},",
                                 error, tolerance)
                   : "no path has met a leaf",
               report.canopy.paths);
    fmt::print(stderr, "ask for less with --tolerance\n");
}

Json to_json(const Lambertian& surface) {
    return {{"reflectance", surface.reflectance},
            {"transmittance", surface.transmittance}};
}

Span span_of(const MeshOptions& options) {
    return has_day(options) ? Span::day : Span::single;
}

Json to_json(const MeshReport& report, const MeshOptions& options,
             double seconds) {
    Json json{{"mesh", options.path},
              {"boundary", options.boundary == Boundary::periodic ? "periodic"
                                                                  : "isolated"},
              {"light", light_name(options)}};
    if (options.scene.empty()) {
        json.update(to_json(report.canopy, span_of(options)));
        if (report.canopy.assimilation)
            json["assimilation"]["method"] =
                options.is_exact ? "exact" : "pieces";
        json["optics"] = {{"leaf", to_json(options.optics.leaf)},
                          {"stalk", to_json(options.optics.stalk)},
                          {"sheath", to_json(options.optics.sheath)},
                          {"soil_albedo", options.soil_albedo}};
    } else {
        json["scene"] = options.scene;
        json.update(scene_json(report.canopy, span_of(options)));
    }
    json["paths"] = report.canopy.paths;
    const double error = relative_error(report);
    // JSON has no infinity.
    json["relative_standard_error"] =
        std::isfinite(error) ? Json(error) : Json(nullptr);
    if (!options.paths)
        json["tolerance"] = {{"asked", options.tolerance},
                             {"is_met", !report.canopy.is_capped},
                             {"most_paths", most_tolerance_paths}};
    json["seed"] = options.seed;
    json["seconds"] = seconds;
    json["warnings"] = report.warnings;
    return json;
}

}  // namespace

ExitCode light_in_mesh(const MeshOptions& options) {
    const double began = now();
    const MeshReport report = study(options);
    const double seconds = now() - began;
    for (const std::string& warning : report.warnings)
        fmt::print(stderr, "ideotype: warning: {}: {}\n", options.path,
                   warning);
    if (report.canopy.is_capped) warn_of_tolerance(report, options.tolerance);
    const Json json = to_json(report, options, seconds);
    if (options.is_json)
        fmt::print("{}\n", to_text(json));
    else
        print_outline(json);
    return ExitCode::ok;
}

}  // namespace ideotype
