// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <utility>

#include "declaration.hpp"
#include "ideotype/core/clock.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/mapped.hpp"

namespace ideotype {

namespace {

Scope scope_of(const Scene& scene, const Details& details) {
    return {scene.components.size(),
            mapped(scene.bands, &Band::name),
            scene.assimilates(),
            details.form,
            details.lines.has_value(),
            !scene.cell.row_ground.empty(),
            !scene.objects.empty(),
            has_panels(scene.objects),
            scene.light().series.grows,
            scene.water.has_value(),
            scene.has_living_organs(),
            details.soil,
            details.grain,
            details.prices};
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
    return {"day", "", "date", mapped(series.dates(), [](const Date& date) {
                return to_string(date);
            })};
}

using Names = std::vector<std::string>;

bool has_plant(const Component& component) {
    return component.plant.has_value();
}

//! Returns the name of a part, with its component if there are several.
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
        if (each.plant)
            for (const std::string& organ : organ_names(*each.plant))
                names.push_back(part_name(scene, each, organ));
        else
            for (const Group& group : each.mesh.groups)
                if (!group.id.is_leaf())
                    names.push_back(part_name(scene, each, group.name));
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

//! Removes the axes that have a single entry.
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
    IDEOTYPE_EXPECT(has_plant(scene.components.front()));
    const LightSeries& series = scene.light().series;
    QuantitySet set;
    set.axes = {leaf_axis(scene),
                organ_axis(scene),
                layer_axis(layers),
                hour_axis(series),
                {"light_source", "", "where light came from last",
                 Names{"beam", "sky", "scattered"}},
                {"leaf_side", "", "upper or lower side of leaves",
                 Names{"adaxial", "abaxial"}}};
    const bool has_days = series.days > 1;
    if (has_days) set.axes.push_back(day_axis(series));
    const Scope scope = scope_of(scene, details);
    if (scope.components > 1)
        set.axes.push_back({"component", "", "kind of plant",
                            mapped(scene.components, &Component::name)});
    if (scope.has_objects) {
        set.axes.push_back({"object", "", "fixed object",
                            mapped(scene.objects, &FixedObject::name)});
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
             each->quantity.name != extinction)) {
            set.quantities.push_back(without_short_axes(each->quantity, scene));
            if (each->names) set.quantities.back().names = each->names(details);
        }
    return set;
}

}  // namespace ideotype
