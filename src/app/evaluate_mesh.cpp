#include <cstdio>

#include <fmt/format.h>

#include "ideotype/app/mesh_study.hpp"
#include "ideotype/app/progress.hpp"
#include "json.hpp"

namespace ideotype {

namespace {

//! A part of the incident light; nothing of nothing is nothing.
Estimate fraction(Estimate part, double incident) {
    return incident > 0 ? scaled(part, 1 / incident) : Estimate{};
}

Json to_json(const BudgetEstimate& budget) {
    const auto part = [&](Estimate x) {
        return to_json(fraction(x, budget.incident));
    };
    return {{"incident", budget.incident},
            {"leaf", part(budget.leaves)},
            {"soil", part(budget.soil)},
            {"reflected", part(budget.reflected)}};
}

const char* boundary_name(const MeshOptions& options) {
    return options.boundary == MeshOptions::Boundary::periodic ? "periodic"
                                                               : "isolated";
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

Json to_json(const MeshReport& report, const MeshOptions& options) {
    Json json{{"mesh", options.path},
              {"boundary", boundary_name(options)},
              {"light", light_name(options)},
              {"unit", options.site ? "J m-2 day-1" : "1"}};
    json.update(to_json(report.light.day));
    const double incident = report.light.day.incident;
    for (std::size_t g = 0; g < report.groups.size(); ++g)
        json["groups"][report.groups[g].name] =
            to_json(fraction(report.light.groups[g], incident));
    json["lai"] = report.lai;
    json["ground_area_m2"] = report.ground_area;
    json["balance_error"] = report.light.balance_error;
    json["paths"] = report.paths;
    json["relative_standard_error"] = report.relative_error;
    if (!options.paths)
        json["tolerance"] = {{"asked", options.tolerance},
                             {"is_met", is_met(report, options)},
                             {"most_paths", most_tolerance_paths}};
    json["seed"] = options.seed;
    json["seconds"] = report.seconds;
    json["warnings"] = report.warnings;
    if (!options.site) return json;
    json["hours"] = Json::array();
    for (const StepReport& step : report.light.steps) {
        Json hour{{"hour", step.hour}, {"unit", "W m-2"}};
        hour.update(to_json(step.budget));
        json["hours"].push_back(hour);
    }
    return json;
}

void print_report(const MeshReport& report, const MeshOptions& options) {
    const BudgetEstimate& day = report.light.day;
    fmt::print("{}, {}, {}\n", options.path, boundary_name(options),
               light_name(options));
    fmt::print("LAI {:.4g} on {:.4g} m2 of ground, {} paths, {:.2g} s\n\n",
               report.lai, report.ground_area, report.paths, report.seconds);
    if (options.site)
        fmt::print("{:<16} {:.4f} MJ m-2 day-1 of PAR\n", "incident",
                   day.incident / 1e6);
    if (options.site && !(day.incident > 0))
        fmt::print("The sun stays below the horizon.\n");
    const auto line = [&](const std::string& name, Estimate x) {
        fmt::print("{:<16} {:>24}\n", name, format(fraction(x, day.incident)));
    };
    fmt::print("{:<16} {:>24}\n", "", "fraction of incident");
    line("leaf", day.leaves);
    line("soil", day.soil);
    line("reflected", day.reflected);
    fmt::print("{:<16} {:>24.1e}\n\n", "balance error",
               report.light.balance_error);
    for (std::size_t g = 0; g < report.groups.size(); ++g)
        line(report.groups[g].name, report.light.groups[g]);

    if (!report.light.steps.empty())
        fmt::print("\n{:>5} {:>10} {:>24} {:>24} {:>24}\n", "hour", "W m-2",
                   "leaf", "soil", "reflected");
    for (const StepReport& step : report.light.steps) {
        const auto part = [&](Estimate x) {
            return format(fraction(x, step.budget.incident));
        };
        fmt::print("{:>5} {:>10.2f} {:>24} {:>24} {:>24}\n", step.hour,
                   step.budget.incident, part(step.budget.leaves),
                   part(step.budget.soil), part(step.budget.reflected));
    }
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
