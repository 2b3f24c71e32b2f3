// SPDX-License-Identifier: Apache-2.0
#include "light_output.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ideotype/canopy/quantities.hpp"
#include "ideotype/core/clock.hpp"
#include "run/progress.hpp"
#include "run/summary.hpp"

namespace ideotype {

double assimilation_scale(Span span) {
    return span == Span::single ? 1e6 : 1;
}

const char* assimilation_unit(Span span) {
    return span == Span::single ? "umol m-2 s-1" : "mol m-2 day-1";
}

namespace {

bool has_stalks(const CanopyReport& report) {
    return std::any_of(report.groups.begin(), report.groups.end(),
                       [](const Group& group) { return !group.id.is_leaf(); });
}

//! The name of a group, with that of its component where there are several.
std::string group_name(const CanopyReport& report, std::size_t group) {
    const Group& own = report.groups[group];
    return report.components.size() > 1 && !own.id.is_object()
               ? report.components[own.id.component].name + '_' + own.name
               : own.name;
}

//! The sunlit leaf area of an instant is known only with a sun.
bool has_sun(const StepReport& step) {
    return step.sunlit && step.budget.leaves_beam.mean > 0;
}

Json to_json(const BudgetEstimate& budget, const CanopyReport& report,
             const char* incident_unit) {
    const auto part = [&](Estimate x) {
        return to_json(fraction_of(x, budget.incident));
    };
    Json json{{"incident", budget.incident},
              {"incident_unit", incident_unit},
              {"unit", "fraction of incident"}};
    if (report.boundary == Boundary::isolated)
        json["entered"] = part(budget.entered);
    json["leaf"] = part(budget.leaves);
    if (has_stalks(report)) json["stalk"] = part(budget.stalks);
    json["soil"] = part(budget.soil);
    json["reflected"] = part(budget.reflected);
    json["leaf_by_origin"] = {{"beam", part(budget.leaves_beam)},
                              {"sky", part(budget.leaves_sky)},
                              {"scattered", part(budget.leaves_scattered)}};
    return json;
}

//! A table of day's totals: fractions, and of days also energy.
class Totals {
  public:
    Totals(double incident, Span span) : incident_(incident), span_(span) {}

    void head(const std::string& name) const {
        if (span_ == Span::day)
            fmt::print("\n{:<20} {:>24} {:>24}\n", name, "MJ m-2 day-1",
                       "fraction of incident");
        else
            fmt::print("\n{:<20} {:>24}\n", name, "fraction of incident");
    }

    void line(const std::string& name, Estimate x) const {
        const std::string part = format(fraction_of(x, incident_));
        if (span_ == Span::day)
            fmt::print("{:<20} {:>24} {:>24}\n", name, format(scaled(x, 1e-6)),
                       part);
        else
            fmt::print("{:<20} {:>24}\n", name, part);
    }

  private:
    double incident_;
    Span span_;
};

void print_budget(const CanopyReport& report, const Totals& totals) {
    const DayReport& light = report.par().light;
    const BudgetEstimate& day = light.day;
    totals.head(fmt::format("LAI {:.4g}", report.lai));
    totals.line("incident", {day.incident, 0});
    if (report.boundary == Boundary::isolated)
        totals.line("entered", day.entered);
    totals.line("leaf", day.leaves);
    totals.line("  of the sun", day.leaves_beam);
    totals.line("  of the sky", day.leaves_sky);
    totals.line("  scattered", day.leaves_scattered);
    totals.line("  upper faces", light.adaxial);
    totals.line("  lower faces", light.abaxial);
    if (has_stalks(report)) totals.line("stalk", day.stalks);
    totals.line("soil", day.soil);
    totals.line("reflected", day.reflected);
    fmt::print("{:<20} {:.1e}\n", "balance error", light.balance_error);
    if (report.boundary == Boundary::isolated)
        fmt::print(
            "\nThe plot stands alone: light enters from all sides, and the "
            "balance closes over\nwhat comes in through the bounding box of "
            "its surfaces. Fractions are of what the\nground area of {:.4g} m2 "
            "receives, so an edge-lit plot can absorb more than 1.\n",
            report.ground_area);
}

Estimate lowered(Estimate gross, double loss) {
    return {gross.mean - loss, gross.standard_error};
}

void print_assimilation(const CanopyReport& report, Span span) {
    const AssimilationReport& all = *report.assimilation;
    const double scale = assimilation_scale(span);
    const auto line = [&](const std::string& name, Estimate gross,
                          double loss) {
        fmt::print("{:<20} {:>24} {:>24}\n", name, format(scaled(gross, scale)),
                   format(scaled(lowered(gross, loss), scale)));
    };
    fmt::print("\n{:<20} {:>24} {:>24}\n",
               fmt::format("CO2 [{}]", assimilation_unit(span)),
               "gross assimilation", "net");
    line("leaf", all.gross, all.net_loss());
    for (std::size_t g = 0; g < report.groups.size(); ++g)
        if (report.groups[g].id.is_leaf())
            line("  " + group_name(report, g), all.groups[g],
                 all.respiration[g].in_light);
    if (!report.light_classes) return;
    const auto& [sunlit, shaded] = *report.light_classes;
    fmt::print("\n{:<20} {:>24} {:>24}\n", "absorbed PPFD", "sunlit leaf area",
               "shaded [m2 m-2]");
    for (std::size_t c = 0; c < ppfd_classes; ++c)
        fmt::print("{:<20} {:>24} {:>24}\n",
                   fmt::format("from {} umol m-2 s-1", class_begin(c)),
                   format(sunlit[c]), format(shaded[c]));
}

void print_hours(const CanopyReport& report) {
    fmt::print("\nhours are on the clock of the site, {}",
               clock_name(report.par().light.utc_offset));
    fmt::print("\n{:<5} {:>8} {:>20} {:>20} {:>20} {:>20} {:>20}\n", "hour",
               "W m-2", "leaf", "  of the sun", "soil", "reflected",
               "sunlit leaf area");
    for (const StepReport& step : report.par().light.steps) {
        const BudgetEstimate& budget = step.budget;
        const auto part = [&](Estimate x) {
            return format(fraction_of(x, budget.incident));
        };
        fmt::print("{:<5} {:>8.2f} {:>20} {:>20} {:>20} {:>20} {:>20}\n",
                   clock_time(step.hour), budget.incident, part(budget.leaves),
                   part(budget.leaves_beam), part(budget.soil),
                   part(budget.reflected),
                   has_sun(step) ? format(*step.sunlit) : "-");
    }
}

//! Leaf area by the light that it absorbs.
Json light_classes_json(const LightClassReport& classes) {
    Json json{{"ppfd_unit", "umol m-2 s-1"}, {"unit", "m2 m-2"}};
    for (std::size_t c = 0; c < ppfd_classes; ++c) {
        Json one{{"from", class_begin(c)}};
        if (c + 1 < ppfd_classes) one["to"] = class_begin(c + 1);
        one["sunlit"] = to_json(classes.sunlit[c]);
        one["shaded"] = to_json(classes.shaded[c]);
        json["classes"].push_back(std::move(one));
    }
    return json;
}

//! By the names of a history; those of a single light that are no rates.
Json quantities_json(const CanopyReport& report, Span span) {
    Json json = Json::object();
    for (const auto& [quantity, estimate] : measure_numbers(report)) {
        const std::string& unit = quantity.unit;
        if (span == Span::single && unit != "1" && unit != "m2 m-2") continue;
        json[quantity.name] = to_json(estimate);
        json[quantity.name]["unit"] = unit;
    }
    return json;
}

Json assimilation_json(const CanopyReport& report, Span span) {
    const AssimilationReport& all = *report.assimilation;
    const double scale = assimilation_scale(span);
    const auto part = [&](Estimate x) {
        Json json = to_json(scaled(x, scale));
        json["unit"] = assimilation_unit(span);
        return json;
    };
    const auto both = [&](Estimate gross, double loss) {
        return Json{{"gross", part(gross)},
                    {"net", part(lowered(gross, loss))}};
    };
    Json json = both(all.gross, all.net_loss());
    if (span == Span::day)
        json["carbon_balance"] = part(lowered(all.gross, all.carbon_loss()));
    Json groups = Json::object();
    for (std::size_t g = 0; g < report.groups.size(); ++g)
        if (report.groups[g].id.is_leaf())
            groups.get_ref<Json::object_t&>().emplace_back(
                group_name(report, g),
                both(all.groups[g], all.respiration[g].in_light));
    json["groups"] = std::move(groups);
    if (report.light_classes)
        json["leaf_area_by_absorbed_ppfd"] =
            light_classes_json(*report.light_classes);
    return json;
}

}  // namespace

Json to_json(const CanopyReport& report, Span span) {
    const DayReport& light = report.par().light;
    const auto part = [&](Estimate x) {
        return to_json(fraction_of(x, light.day.incident));
    };
    Json json =
        to_json(light.day, report, span == Span::day ? "J m-2 day-1" : "1");
    json["leaf_by_face"] = {{"upper", part(light.adaxial)},
                            {"lower", part(light.abaxial)}};
    json["leaf_by_layer"] = Json::array();
    for (std::size_t l = 0; l < light.layers.size(); ++l) {
        const double lower = report.layers.thickness * static_cast<double>(l);
        json["leaf_by_layer"].push_back(
            {{"from_m", lower},
             {"to_m", lower + report.layers.thickness},
             {"leaf", part(light.layers[l])}});
    }
    // Names differ; to look each up among the others takes too long.
    Json groups = Json::object();
    for (std::size_t g = 0; g < report.groups.size(); ++g)
        groups.get_ref<Json::object_t&>().emplace_back(group_name(report, g),
                                                       part(light.groups[g]));
    json["groups"] = std::move(groups);
    if (report.boundary == Boundary::isolated)
        json["surface"] =
            "bounding box of the plot, down to the soil: the balance closes "
            "over what entered through it, from all sides; fractions of what "
            "the ground area receives may exceed 1";
    json["lai"] = report.lai;
    json["ground_area_m2"] = report.ground_area;
    json["balance_error"] = light.balance_error;
    if (span == Span::day) json["clock"] = clock_name(light.utc_offset);
    for (const StepReport& step : light.steps) {
        Json hour{{"hour", step.hour}};
        hour.update(to_json(step.budget, report, "W m-2"));
        if (has_sun(step)) hour["sunlit_leaf_area"] = to_json(*step.sunlit);
        if (span == Span::day)
            json["hours"].push_back(hour);
        else if (has_sun(step))
            json["sunlit_leaf_area"] = hour["sunlit_leaf_area"];
    }
    json["quantities"] = quantities_json(report, span);
    if (report.assimilation)
        json["assimilation"] = assimilation_json(report, span);
    return json;
}

void print_light(const CanopyReport& report, Span span) {
    const DayReport& light = report.par().light;
    if (!(light.day.incident > 0))
        fmt::print("\nThe sun stays below the horizon.\n");
    const Totals totals(light.day.incident, span);
    print_budget(report, totals);
    if (report.assimilation) print_assimilation(report, span);
    totals.head("organ");
    for (std::size_t g = 0; g < report.groups.size(); ++g)
        totals.line(group_name(report, g), light.groups[g]);
    totals.head("height, leaves");
    for (std::size_t l = light.layers.size(); l-- > 0;)
        totals.line(
            fmt::format("{:.2f} - {:.2f} m",
                        report.layers.thickness * static_cast<double>(l),
                        report.layers.thickness * static_cast<double>(l + 1)),
            light.layers[l]);
    if (span == Span::day)
        print_hours(report);
    else if (has_sun(light.steps.front()))
        fmt::print("\n{:<20} {:>24}\n", "sunlit leaf area",
                   format(*light.steps.front().sunlit));
}

}  // namespace ideotype
