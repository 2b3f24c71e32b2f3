// SPDX-License-Identifier: Apache-2.0
#include "parts_output.hpp"

#include <string>
#include <vector>

#include <fmt/format.h>

#include "ideotype/canopy/quantities.hpp"
#include "run/progress.hpp"

namespace ideotype {

namespace {

//! A component or row with figures per area of some ground.
struct Part {
    std::string name;
    double lai;
    Estimate light;
    std::optional<Estimate> net;
};

std::vector<Part> components_of(const CanopyReport& report) {
    std::vector<Part> parts;
    const auto light = measure_parts("absorbed_par", report);
    for (const ComponentReport& each : report.components)
        parts.push_back(
            {each.name, each.lai, light[parts.size()].estimate, {}});
    if (!report.assimilation) return parts;
    const auto net = measure_parts("net_assimilation", report);
    for (std::size_t i = 0; i < parts.size(); ++i)
        parts[i].net = net[i].estimate;
    return parts;
}

std::vector<Part> rows_of(const CanopyReport& report) {
    std::vector<Part> parts;
    const auto lai = measure_profile("lai_by_row", report);
    const auto light = measure_profile("absorbed_light_by_row", report);
    for (const RowReport& row : report.rows) {
        const std::size_t i = parts.size();
        parts.push_back({fmt::format("{} {}, {:.3g} m",
                                     report.components[row.component].name,
                                     i + 1, row.position),
                         lai[i].estimate.mean,
                         light[i * report.bands.size()].estimate,
                         {}});
    }
    if (!report.assimilation) return parts;
    const auto net = measure_profile("net_assimilation_by_row", report);
    for (std::size_t i = 0; i < parts.size(); ++i)
        parts[i].net = net[i].estimate;
    return parts;
}

Json to_json(const Part& part) {
    const auto number = [](const Estimate& x, const char* unit) {
        Json json = to_json(x);
        json["unit"] = unit;
        return json;
    };
    Json json{{"lai", part.lai},
              {"absorbed_par", number(part.light, "MJ m-2 day-1")}};
    if (part.net) json["net_assimilation"] = number(*part.net, "mol m-2 day-1");
    return json;
}

void print(const std::string& title, const std::vector<Part>& parts) {
    fmt::print("\n{:<20} {:>8} {:>24} {:>24}\n", title, "LAI",
               "PAR [MJ m-2 day-1]",
               parts.front().net ? "net CO2 [mol m-2 day-1]" : "");
    for (const auto& [name, lai, light, net] : parts)
        fmt::print("{:<20} {:>8.3f} {:>24} {:>24}\n", name, lai, format(light),
                   net ? format(*net) : "");
}

}  // namespace

Json parts_json(const CanopyReport& report) {
    Json json = Json::object();
    if (report.components.size() > 1)
        for (const Part& each : components_of(report))
            json["components"][each.name] = to_json(each);
    if (report.rows.empty()) return json;
    const std::vector<Part> rows = rows_of(report);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const RowReport& row = report.rows[i];
        Json one{{"component", report.components[row.component].name},
                 {"position_m", row.position},
                 {"width_m", row.width}};
        one.update(to_json(rows[i]));
        json["rows"].push_back(std::move(one));
    }
    return json;
}

void print_parts(const CanopyReport& report) {
    if (report.components.size() > 1)
        print("per all ground", components_of(report));
    if (!report.rows.empty()) print("per ground of row", rows_of(report));
}

}  // namespace ideotype
