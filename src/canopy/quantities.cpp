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

const std::vector<Declaration>& of_light() {
    static const std::vector<Declaration> all = light_quantities();
    return all;
}

//! All that a report has.
const std::vector<Declaration>& declared(bool with_assimilation) {
    static const std::vector<Declaration> both = [] {
        std::vector<Declaration> all = of_light();
        for (Declaration& more : assimilation_quantities())
            all.push_back(std::move(more));
        return all;
    }();
    return with_assimilation ? both : of_light();
}

//! The declaration of a quantity that any report may have; or null.
const Declaration* find(const std::string& quantity) {
    for (const Declaration& each : declared(true))
        if (each.quantity.name == quantity) return &each;
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
                              bool with_assimilation) {
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
    for (const Declaration& each : declared(with_assimilation))
        if ((has_days || each.quantity.axes != Names{"day"}) &&
            (boundary == Boundary::periodic ||
             each.quantity.name != extinction))
            set.quantities.push_back(each.quantity);
    return set;
}

std::vector<Estimate> measure(const CanopyReport& report) {
    std::vector<Estimate> all;
    for (const Declaration& each : declared(report.assimilation.has_value()))
        if (const auto* number = std::get_if<TakeNumber>(&each.take)) {
            if (const auto found = (*number)(report))
                all.push_back(found->estimate);
        } else if (const auto* profile = std::get_if<TakeProfile>(&each.take)) {
            for (const Randomised& x : (*profile)(report))
                all.push_back(x.estimate);
        } else {
            for (const Estimate& x : std::get<TakeNumbers>(each.take)(report))
                all.push_back(x);
        }
    return all;
}

std::vector<Measured> measure_numbers(const CanopyReport& report) {
    std::vector<Measured> all;
    for (const Declaration& each : declared(report.assimilation.has_value()))
        if (const auto* number = std::get_if<TakeNumber>(&each.take))
            if (const auto found = (*number)(report))
                all.push_back({each.quantity, found->estimate});
    return all;
}

std::vector<std::string> objective_names() {
    std::vector<std::string> names;
    for (const Declaration& each : declared(true))
        if (each.quantity.axes.empty() && !each.is_of_method)
            names.push_back(each.quantity.name);
    return names;
}

bool is_of_assimilation(const std::string& quantity) {
    const auto& light = of_light();
    return find(quantity) &&
           std::none_of(light.begin(), light.end(),
                        [&](const Declaration& each) {
                            return each.quantity.name == quantity;
                        });
}

std::string unit_of(const std::string& quantity) {
    if (const Declaration* found = find(quantity)) return found->quantity.unit;
    throw std::out_of_range("no quantity " + quantity);
}

Randomised measure_objective(const std::string& name,
                             const CanopyReport& report) {
    const bool is_missing = is_of_assimilation(name) && !report.assimilation;
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
