// SPDX-License-Identifier: Apache-2.0
#include "ideotype/canopy/quantities.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "declaration.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/mapped.hpp"
#include "randomised.hpp"

namespace ideotype {

namespace {

//! Returns the quantities of one kind, which are created once.
template <std::vector<Declaration> (*made)()>
const std::vector<Declaration>& all_of() {
    static const std::vector<Declaration> all = made();
    return all;
}

}  // namespace

std::vector<const Declaration*> declared(const Scope& scope) {
    std::vector<const Declaration*> all;
    const auto add = [&](const std::vector<Declaration>& more) {
        for (const Declaration& each : more)
            if (!each.is_in || each.is_in(scope)) all.push_back(&each);
    };
    add(all_of<light_quantities>());
    if (scope.assimilates) add(all_of<assimilation_quantities>());
    if (scope.has_form) add(all_of<form_quantities>());
    if (scope.has_lines) add(all_of<line_quantities>());
    add(all_of<part_quantities>());
    add(all_of<row_quantities>());
    add(all_of<object_quantities>());
    add(all_of<water_quantities>());
    add(all_of<season_quantities>());
    return all;
}

namespace {

const Scope everything = [] {
    Scope all{2,    {},   true, true, true, true, true,
              true, true, true, true, true, true, true};
    for (const Waveband& each : wavebands) all.bands.push_back(each.name);
    return all;
}();

Scope scope_of(const CanopyReport& report) {
    return {report.components.size(),
            mapped(report.bands, &BandReport::name),
            report.assimilation.has_value(),
            report.form.has_value(),
            report.lines.has_value(),
            !report.rows.empty(),
            !report.objects.empty(),
            has_panels(report.objects),
            report.grows,
            report.water.has_value(),
            report.has_living_organs,
            report.season_water.has_value(),
            report.season_grain.has_value(),
            report.season_prices.has_value()};
}

std::vector<const Declaration*> declared(const CanopyReport& report) {
    return declared(scope_of(report));
}

bool is_in(const std::vector<Declaration>& all, const std::string& quantity) {
    return std::any_of(all.begin(), all.end(), [&](const Declaration& each) {
        return each.quantity.name == quantity;
    });
}

//! Returns the declaration of a quantity if a canopy has it, otherwise null.
const Declaration* find(const std::string& quantity,
                        const Scope& scope = everything) {
    for (const Declaration* each : declared(scope))
        if (each->quantity.name == quantity) return each;
    return nullptr;
}

//! Returns the declaration of a quantity. @throws std::out_of_range if no
//! quantity has this name.
const Declaration& declaration_of(const std::string& quantity) {
    if (const Declaration* found = find(quantity)) return *found;
    throw std::out_of_range("no quantity " + quantity);
}

//! Returns whether a quantity requires the properties that `take_away` removes.
bool needs(const std::string& quantity, const auto& take_away) {
    Scope others = everything;
    take_away(others);
    return find(quantity) && !find(quantity, others);
}

}  // namespace

std::vector<Randomised> measure_by_randomisation(const CanopyReport& report) {
    std::vector<Randomised> all;
    for (const Declaration* each : declared(report))
        if (const auto* number = std::get_if<TakeNumber>(&each->take)) {
            if (auto found = (*number)(report))
                all.push_back(std::move(*found));
        } else if (const auto* profile =
                       std::get_if<TakeProfile>(&each->take)) {
            for (Randomised& x : (*profile)(report))
                all.push_back(std::move(x));
        } else {
            for (const Estimate& x : std::get<TakeNumbers>(each->take)(report))
                all.push_back({x, {}});
        }
    return all;
}

std::vector<Estimate> measure(const CanopyReport& report) {
    return mapped(measure_by_randomisation(report), &Randomised::estimate);
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
    for (const Declaration* each : declared(everything))
        if (each->quantity.axes.empty() && !each->is_of_method)
            names.push_back(each->quantity.name);
    return names;
}

bool is_of_assimilation(const std::string& quantity) {
    return is_in(all_of<assimilation_quantities>(), quantity);
}

bool is_of_form(const std::string& quantity) {
    return is_in(all_of<form_quantities>(), quantity);
}

bool is_of_lines(const std::string& quantity) {
    return is_in(all_of<line_quantities>(), quantity);
}

bool is_of_band(const std::string& quantity, const std::string& band) {
    return needs(quantity,
                 [&](Scope& scope) { std::erase(scope.bands, band); });
}

bool is_of_water(const std::string& quantity) {
    return is_in(all_of<water_quantities>(), quantity);
}

bool is_of_soil(const std::string& quantity) {
    return needs(quantity, [](Scope& scope) { scope.has_soil = false; });
}

bool is_of_grain(const std::string& quantity) {
    return needs(quantity, [](Scope& scope) { scope.has_grain = false; });
}

bool is_of_prices(const std::string& quantity) {
    return needs(quantity, [](Scope& scope) { scope.has_prices = false; });
}

bool is_of_growth(const std::string& quantity) {
    return needs(quantity, [](Scope& scope) { scope.grows = false; });
}

bool is_of_panels(const std::string& quantity) {
    return needs(quantity, [](Scope& scope) { scope.has_panels = false; });
}

bool is_of_two_components(const std::string& quantity) {
    return needs(quantity, [](Scope& scope) { scope.components = 1; });
}

std::string unit_of(const std::string& quantity) {
    return declaration_of(quantity).quantity.unit;
}

MeanOver mean_over(const std::string& quantity) {
    return declaration_of(quantity).mean_over;
}

Randomised measure_objective(const std::string& name,
                             const CanopyReport& report) {
    const Declaration* found = find(name, scope_of(report));
    if (const auto* number =
            found ? std::get_if<TakeNumber>(&found->take) : nullptr)
        if (auto randomised = (*number)(report)) return *randomised;
    throw Error("this canopy has no quantity without axes that is called " +
                name);
}

std::vector<Randomised> measure_profile(const std::string& name,
                                        const CanopyReport& report) {
    const Declaration* found = find(name, scope_of(report));
    const auto* profile =
        found ? std::get_if<TakeProfile>(&found->take) : nullptr;
    if (!profile)
        throw Error(
            "this canopy has no quantity with one axis that is called " + name);
    return (*profile)(report);
}

}  // namespace ideotype
