// SPDX-License-Identifier: Apache-2.0
#include "ideotype/canopy/quantities.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "declaration.hpp"
#include "ideotype/core/clock.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {

namespace {

//! The quantities of one kind, which are made once.
template <std::vector<Declaration> (*made)()>
const std::vector<Declaration>& all_of() {
    static const std::vector<Declaration> all = made();
    return all;
}

//! Returns all that a canopy of some scope has, in the order of columns.
std::vector<const Declaration*> declared(const Scope& scope) {
    std::vector<const Declaration*> all;
    const auto add = [&](const std::vector<Declaration>& more) {
        for (const Declaration& each : more)
            if (!each.is_in || each.is_in(scope)) all.push_back(&each);
    };
    add(all_of<light_quantities>());
    if (scope.assimilates) add(all_of<assimilation_quantities>());
    if (scope.has_lines) add(all_of<line_quantities>());
    add(all_of<part_quantities>());
    add(all_of<row_quantities>());
    add(all_of<object_quantities>());
    add(all_of<water_quantities>());
    return all;
}

//! A canopy that has every quantity.
const Scope everything{2,    {"par", "nir"}, true, true, true,
                       true, true,           true, true};

//! Returns whether any object is a panel.
template <class Object>
bool has_panels(const std::vector<Object>& objects) {
    return std::any_of(objects.begin(), objects.end(),
                       [](const Object& each) { return each.is_panel; });
}

Scope scope_of(const CanopyReport& report) {
    Scope scope{report.components.size(),
                {},
                report.assimilation.has_value(),
                report.lines.has_value(),
                !report.rows.empty(),
                !report.objects.empty(),
                has_panels(report.objects),
                report.grows,
                report.water.has_value()};
    for (const BandReport& band : report.bands)
        scope.bands.push_back(band.name);
    return scope;
}

Scope scope_of(const Scene& scene, const Details& details) {
    Scope scope{scene.components.size(),
                {},
                scene.assimilates(),
                details.lines.has_value(),
                !scene.cell.row_ground.empty(),
                !scene.objects.empty(),
                has_panels(scene.objects),
                scene.light().series.grows,
                scene.water.has_value()};
    for (const Band& band : scene.bands) scope.bands.push_back(band.name);
    return scope;
}

std::vector<const Declaration*> declared(const CanopyReport& report) {
    return declared(scope_of(report));
}

bool is_in(const std::vector<Declaration>& all, const std::string& quantity) {
    return std::any_of(all.begin(), all.end(), [&](const Declaration& each) {
        return each.quantity.name == quantity;
    });
}

//! Returns the declaration of a quantity that a canopy has; or null.
const Declaration* find(const std::string& quantity,
                        const Scope& scope = everything) {
    for (const Declaration* each : declared(scope))
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

namespace {

using Names = std::vector<std::string>;

bool has_plant(const Component& component) {
    return component.plant.has_value();
}

//! The name of a part of a component, where there are several.
std::string part_name(const Scene& scene, const Component& component,
                      const std::string& part) {
    return scene.components.size() == 1 ? part : component.name + '_' + part;
}

Axis leaf_axis(const Scene& scene) {
    if (scene.components.size() == 1)
        return counted("leaf", "leaf rank, 1 is the lowest",
                       scene.components.front().plant->leaves.size(), 1);
    Names names;
    for (const Component& each : scene.components)
        for (const Group& group : each.mesh.groups)
            if (group.id.is_leaf())
                names.push_back(part_name(scene, each, group.name));
    return {"leaf", "", "component, and leaf rank, 01 is the lowest",
            std::move(names)};
}

Axis organ_axis(const Scene& scene) {
    Names names;
    for (const Component& each : scene.components) {
        names.push_back(part_name(scene, each, "leaves"));
        for (const std::string& organ : organ_names(*each.plant))
            names.push_back(part_name(scene, each, organ));
    }
    return {"organ", "", "leaves together, or another organ", std::move(names)};
}

Axis row_axis(const Scene& scene) {
    Names names(scene.cell.row_ground.size());
    for (const Component& each : scene.components)
        for (const Place& place : each.places)
            names[place.row] =
                part_name(scene, each, std::to_string(place.row + 1));
    return {"field_row", "", "row of the field, 1 has the lowest x",
            std::move(names)};
}

//! Leaves out the axes that have a single place.
Quantity without_short_axes(Quantity quantity, const Scene& scene) {
    std::erase_if(quantity.axes, [&](const std::string& axis) {
        return (axis == "component" && scene.components.size() == 1) ||
               (axis == "band" && scene.bands.size() == 1);
    });
    return quantity;
}

}  // namespace

QuantitySet canopy_quantities(const Scene& scene, const Layers& layers,
                              const Details& details) {
    IDEOTYPE_EXPECT(!scene.components.empty());
    IDEOTYPE_EXPECT(std::ranges::all_of(scene.components, &has_plant));
    const LightSeries& series = scene.light().series;
    QuantitySet set;
    set.axes = {leaf_axis(scene),
                organ_axis(scene),
                layer_axis(layers),
                hour_axis(series),
                {"light_source", "", "where light came from at last",
                 Names{"beam", "sky", "scattered"}},
                {"leaf_side", "", "upper or lower side of leaves",
                 Names{"adaxial", "abaxial"}}};
    const bool has_days = series.days > 1;
    if (has_days) set.axes.push_back(day_axis(series));
    const Scope scope = scope_of(scene, details);
    if (scope.components > 1) {
        Names names;
        for (const Component& each : scene.components)
            names.push_back(each.name);
        set.axes.push_back(
            {"component", "", "kind of plant", std::move(names)});
    }
    if (scope.has_objects) {
        Names names;
        for (const FixedObject& each : scene.objects)
            names.push_back(each.name);
        set.axes.push_back({"object", "", "fixed object", std::move(names)});
        set.axes.push_back({"object_side", "",
                            "side of panels, or of faces of other objects",
                            Names{"front", "back"}});
    }
    if (scope.bands.size() > 1)
        set.axes.push_back({"band", "", "waveband", scope.bands});
    if (scope.has_rows) set.axes.push_back(row_axis(scene));
    for (const Declaration* each : declared(scope))
        if ((has_days || each->quantity.axes != Names{"day"}) &&
            (scene.cell.boundary == Boundary::periodic ||
             each->quantity.name != extinction))
            set.quantities.push_back(without_short_axes(each->quantity, scene));
    return set;
}

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
    std::vector<Estimate> all;
    for (const Randomised& each : measure_by_randomisation(report))
        all.push_back(each.estimate);
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
    for (const Declaration* each : declared(everything))
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

bool is_of_nir(const std::string& quantity) {
    Scope par = everything;
    par.bands = {"par"};
    return find(quantity) && !find(quantity, par);
}

bool is_of_water(const std::string& quantity) {
    return is_in(all_of<water_quantities>(), quantity);
}

bool is_of_growth(const std::string& quantity) {
    Scope grown = everything;
    grown.grows = false;
    return find(quantity) && !find(quantity, grown);
}

bool is_of_panels(const std::string& quantity) {
    Scope open = everything;
    open.has_panels = false;
    return find(quantity) && !find(quantity, open);
}

bool is_of_two_components(const std::string& quantity) {
    Scope one = everything;
    one.components = 1;
    return find(quantity) && !find(quantity, one);
}

std::string unit_of(const std::string& quantity) {
    if (const Declaration* found = find(quantity)) return found->quantity.unit;
    throw std::out_of_range("no quantity " + quantity);
}

Randomised measure_objective(const std::string& name,
                             const CanopyReport& report) {
    const Declaration* found = find(name, scope_of(report));
    if (const auto* number =
            found ? std::get_if<TakeNumber>(&found->take) : nullptr)
        if (auto randomised = (*number)(report)) return *randomised;
    throw Error("this canopy has no single number " + name);
}

std::vector<Randomised> measure_profile(const std::string& name,
                                        const CanopyReport& report) {
    const Declaration* found = find(name, scope_of(report));
    const auto* profile =
        found ? std::get_if<TakeProfile>(&found->take) : nullptr;
    if (!profile) throw Error("this canopy has no profile " + name);
    return (*profile)(report);
}

}  // namespace ideotype
