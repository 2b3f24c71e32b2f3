// SPDX-License-Identifier: Apache-2.0
#include "ideotype/canopy/quantities.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "declaration.hpp"
#include "ideotype/core/clock.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {

namespace {

//! The quantities of one kind, which are made once.
template <std::vector<Declaration> (*made)()>
const std::vector<Declaration>& all_of() {
    static const std::vector<Declaration> all = made();
    return all;
}

//! All that a report may have, in the order of their columns.
std::vector<const Declaration*> declared(bool with_assimilation,
                                         bool with_lines) {
    std::vector<const Declaration*> all;
    const auto add = [&](const std::vector<Declaration>& more) {
        for (const Declaration& each : more) all.push_back(&each);
    };
    add(all_of<light_quantities>());
    if (with_assimilation) add(all_of<assimilation_quantities>());
    if (with_lines) add(all_of<line_quantities>());
    return all;
}

std::vector<const Declaration*> declared(const CanopyReport& report) {
    return declared(report.assimilation.has_value(), report.lines.has_value());
}

bool is_in(const std::vector<Declaration>& all, const std::string& quantity) {
    return std::any_of(all.begin(), all.end(), [&](const Declaration& each) {
        return each.quantity.name == quantity;
    });
}

//! The declaration of a quantity that any report may have; or null.
const Declaration* find(const std::string& quantity) {
    for (const Declaration* each : declared(true, true))
        if (each->quantity.name == quantity) return each;
    return nullptr;
}

Axis layer_axis(const Layers& layers) {
    std::vector<double> middles;
    for (std::size_t l = 0; l < layers.count; ++l)
        middles.push_back(layers.thickness * (static_cast<double>(l) + 0.5));
    return {"layer", "m", "height of the middle of the layer above the soil",
            std::move(middles)};
}

Axis hour_axis(const LightSeries& series) {
    return {"hour", "h",
            "time on the clock of the site, " + clock_name(series.utc_offset),
            series.hours()};
}

Axis day_axis(const LightSeries& series) {
    std::vector<std::string> dates;
    for (const Date& date : series.dates()) dates.push_back(to_string(date));
    return {"day", "", "date", std::move(dates)};
}

}  // namespace

QuantitySet canopy_quantities(const Plant& plant, const Layers& layers,
                              const LightSeries& series, Boundary boundary,
                              const Details& details) {
    using Names = std::vector<std::string>;
    QuantitySet set;
    Names organs = organ_names(plant);
    organs.insert(organs.begin(), "leaves");
    set.axes = {
        counted("leaf", "leaf rank, 1 is the lowest", plant.leaves.size(), 1),
        {"organ", "", "leaves together, or another organ", std::move(organs)},
        layer_axis(layers),
        hour_axis(series),
        {"light_source", "", "where light came from at last",
         Names{"beam", "sky", "scattered"}},
        {"leaf_side", "", "upper or lower side of leaves",
         Names{"adaxial", "abaxial"}}};
    const bool has_days = series.days > 1;
    if (has_days) set.axes.push_back(day_axis(series));
    for (const Declaration* each : declared(details.photosynthesis.has_value(),
                                            details.lines.has_value()))
        if ((has_days || each->quantity.axes != Names{"day"}) &&
            (boundary == Boundary::periodic ||
             each->quantity.name != extinction))
            set.quantities.push_back(each->quantity);
    return set;
}

std::vector<Estimate> measure(const CanopyReport& report) {
    std::vector<Estimate> all;
    for (const Declaration* each : declared(report))
        if (const auto* number = std::get_if<TakeNumber>(&each->take)) {
            if (const auto found = (*number)(report))
                all.push_back(found->estimate);
        } else if (const auto* profile =
                       std::get_if<TakeProfile>(&each->take)) {
            for (const Randomised& x : (*profile)(report))
                all.push_back(x.estimate);
        } else {
            for (const Estimate& x : std::get<TakeNumbers>(each->take)(report))
                all.push_back(x);
        }
    return all;
}

std::vector<Measured> measure_numbers(const CanopyReport& report) {
    std::vector<Measured> all;
    for (const Declaration* each : declared(report))
        if (const auto* number = std::get_if<TakeNumber>(&each->take))
            if (const auto found = (*number)(report))
                all.push_back({each->quantity, found->estimate});
    return all;
}

std::vector<std::string> objective_names() {
    std::vector<std::string> names;
    for (const Declaration* each : declared(true, true))
        if (each->quantity.axes.empty() && !each->is_of_method)
            names.push_back(each->quantity.name);
    return names;
}

bool is_of_assimilation(const std::string& quantity) {
    return is_in(all_of<assimilation_quantities>(), quantity);
}

bool is_of_lines(const std::string& quantity) {
    return is_in(all_of<line_quantities>(), quantity);
}

std::string unit_of(const std::string& quantity) {
    if (const Declaration* found = find(quantity)) return found->quantity.unit;
    throw std::out_of_range("no quantity " + quantity);
}

Randomised measure_objective(const std::string& name,
                             const CanopyReport& report) {
    const bool is_missing =
        (is_of_assimilation(name) && !report.assimilation) ||
        (is_of_lines(name) && !report.lines);
    const Declaration* found = is_missing ? nullptr : find(name);
    if (const auto* number =
            found ? std::get_if<TakeNumber>(&found->take) : nullptr)
        if (auto randomised = (*number)(report)) return *randomised;
    throw Error("this canopy has no single number " + name);
}

std::vector<Randomised> measure_profile(const std::string& name,
                                        const CanopyReport& report) {
    const Declaration* found = find(name);
    const auto* profile =
        found ? std::get_if<TakeProfile>(&found->take) : nullptr;
    if (!profile || (is_of_assimilation(name) && !report.assimilation))
        throw Error("this canopy has no profile " + name);
    return (*profile)(report);
}

}  // namespace ideotype
