#include <cstdio>

#include <fmt/format.h>

#include "ideotype/app/mesh_study.hpp"
#include "light_output.hpp"

namespace ideotype {

namespace {

const char* boundary_name(const MeshOptions& options) {
    return options.boundary == Boundary::periodic ? "periodic" : "isolated";
}

std::string light_name(const MeshOptions& options) {
    if (options.site)
        return fmt::format("clear day {:04}-{:02}-{:02} at {} N {} E, UTC {:+}",
                           options.date->year, options.date->month,
                           options.date->day, options.site->latitude,
                           options.site->longitude, options.site->utc_offset);
    if (options.sky)
        return *options.sky == SkyModel::uniform    ? "uniform sky"
               : *options.sky == SkyModel::overcast ? "overcast sky"
                                                    : "clear sky";
    return fmt::format("sun at elevation {} and azimuth {}",
                       90 - options.sun->zenith, options.sun->azimuth);
}

bool is_met(const MeshReport& report, const MeshOptions& options) {
    return report.relative_error <= options.tolerance;
}

Span span_of(const MeshOptions& options) {
    return options.site ? Span::day : Span::single;
}

Json to_json(const MeshReport& report, const MeshOptions& options) {
    Json json{{"mesh", options.path},
              {"boundary", boundary_name(options)},
              {"light", light_name(options)}};
    json.update(to_json(report.canopy, span_of(options)));
    json["paths"] = report.paths;
    json["relative_standard_error"] = report.relative_error;
    if (!options.paths)
        json["tolerance"] = {{"asked", options.tolerance},
                             {"is_met", is_met(report, options)},
                             {"most_paths", most_tolerance_paths}};
    json["seed"] = options.seed;
    json["seconds"] = report.seconds;
    json["warnings"] = report.warnings;
    return json;
}

void print_report(const MeshReport& report, const MeshOptions& options) {
    fmt::print("{}, {}, {}\n{:.4g} m2 of ground, {} paths, {:.2g} s\n",
               options.path, boundary_name(options), light_name(options),
               report.canopy.ground_area, report.paths, report.seconds);
    print_light(report.canopy, span_of(options));
}

}  // namespace

ExitCode evaluate_mesh(const MeshOptions& options) {
    const MeshReport report = study(options);
    for (const std::string& warning : report.warnings)
        fmt::print(stderr, "ideotype: warning: {}: {}\n", options.path,
                   warning);
    if (!options.paths && !is_met(report, options))
        fmt::print(stderr,
                   "ideotype: warning: the relative standard error is {:.2g}, "
                   "not {:.2g}, after the most paths ({})\n",
                   report.relative_error, options.tolerance, report.paths);
    if (options.is_json)
        fmt::print("{}\n", to_text(to_json(report, options)));
    else
        print_report(report, options);
    return ExitCode::ok;
}

}  // namespace ideotype
