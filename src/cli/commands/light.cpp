// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/formats/light_output.hpp"
#include "run/progress.hpp"
#include "stand/mesh_study.hpp"

namespace ideotype {

namespace {

std::string light_name(const MeshSpec& spec) {
    if (!spec.climate.empty()) return "mean day of " + spec.climate;
    if (spec.site)
        return fmt::format("clear day {} at {} N {} E, UTC {:+}",
                           to_string(spec.date), spec.site->latitude,
                           spec.site->longitude, spec.site->utc_offset);
    if (spec.sun && spec.sky && spec.beam_ppfd)
        return fmt::format("sun at elevation {} and azimuth {}, and sky",
                           spec.sun->elevation, spec.sun->azimuth);
    if (spec.sky) return fmt::format("{} sky", name_of(*spec.sky));
    return fmt::format("sun at elevation {} and azimuth {}",
                       spec.sun->elevation, spec.sun->azimuth);
}

//! Returns the largest relative standard error of the light that leaves absorb
//! in any waveband; infinite if no path has hit a leaf.
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
    fmt::print(stderr,
               "ideotype: warning: {} after the largest number of paths ({}); ",
               std::isfinite(error)
                   ? fmt::format("the relative standard error is {:.2g}, not "
                                 "{:.2g},",
                                 error, tolerance)
                   : "no path has hit a leaf",
               report.canopy.paths);
    fmt::print(stderr, "use a larger --tolerance\n");
}

Json to_json(const Lambertian& surface) {
    return {{"reflectance", surface.reflectance},
            {"transmittance", surface.transmittance}};
}

Json to_json(const MeshReport& report, const MeshSpec& spec, double seconds) {
    Json json{{"mesh", spec.path},
              {"boundary", name_of(spec.boundary)},
              {"light", light_name(spec)}};
    if (spec.scene.empty()) {
        json.update(to_json(report.canopy, span_of(spec)));
        if (report.canopy.assimilation)
            json["assimilation"]["method"] = spec.is_exact ? "exact" : "pieces";
        json["optics"] = {{"leaf", to_json(spec.optics.leaf)},
                          {"stalk", to_json(spec.optics.stalk)},
                          {"sheath", to_json(spec.optics.sheath)},
                          {"soil_albedo", spec.soil_albedo}};
    } else {
        json["scene"] = spec.scene;
        json.update(scene_json(report.canopy, span_of(spec)));
    }
    json["paths"] = report.canopy.paths;
    const double error = relative_error(report);
    // JSON cannot represent infinity.
    json["relative_standard_error"] =
        std::isfinite(error) ? Json(error) : Json(nullptr);
    if (spec.paths == 0)
        json["tolerance"] = {{"asked", spec.tolerance},
                             {"is_met", !report.canopy.is_capped},
                             {"most_paths", most_tolerance_paths}};
    json["seed"] = spec.seed;
    json["seconds"] = seconds;
    json["warnings"] = report.warnings;
    return json;
}

}  // namespace

ExitCode light_in_mesh(const LightOptions& options) {
    const double began = now();
    MeshSpec spec = read_mesh_spec(options.given, option_of_key);
    spec.path = options.mesh;
    const MeshReport report = study(spec, option_of_key);
    const double seconds = now() - began;
    for (const std::string& warning : report.warnings)
        fmt::print(stderr, "ideotype: warning: {}: {}\n", spec.path, warning);
    if (report.canopy.is_capped) warn_of_tolerance(report, spec.tolerance);
    const Json json = to_json(report, spec, seconds);
    if (options.is_json)
        fmt::print("{}\n", to_text(json));
    else
        print_outline(json);
    return ExitCode::ok;
}

}  // namespace ideotype
