// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "campaign/meshes.hpp"
#include "checks.hpp"
#include "ideotype/core/units.hpp"

namespace ideotype {

namespace {

//! A period of the cell, divided into equal spacings.
struct Period {
    std::string count_key, step_key;  //!< keys like "field.rows", "spacing.row"
    double step = 0;                  //!< length of a step [m]
    int count = 0;
    int least = 1;  //!< a divisor that the count must have

    double length() const { return step * count; }
};

//! Returns advice if a length does not divide a period.
//! @param extra part of the length that is added to the value of the key
std::string remedy(const std::string& key, double part, double extra,
                   const Period& period) {
    constexpr int largest = 100;
    for (int count = period.least; count <= largest; count += period.least)
        if (divides(part, count * period.step))
            return fmt::format("{} = {}", period.count_key, count);
    const auto nearest = [&](double length) {
        return fmt::format(
            "{} = {:.6g}", key,
            length / std::max(1., std::round(length / part)) - extra);
    };
    const double group = period.least * period.step;
    const auto count =
        static_cast<int>(period.least * std::max(1., std::round(part / group)));
    const std::string other = fmt::format("{} = {} with {}", period.count_key,
                                          count, nearest(count * period.step));
    if (count == period.count) return nearest(period.length());
    return part < period.length() ? nearest(period.length()) + ", or " + other
                                  : other;
}

//! Reports a length of panels that does not divide a period.
//! @param extra part of the length that is added to the value of the key
void check_period(const std::string& key, double value, double extra,
                  const Period& period, const Problems& problems) {
    const double part = value + extra, whole = period.length();
    problems.rule({key}, [&]() -> std::string {
        if (divides(part, whole)) return "";
        return fmt::format(
            "panel.{} is {} ({}{:.6g} m does not go into the cell of {} {} x "
            "{} {:.6g} m = {:.6g} m a whole number of times); use {}",
            key, value, extra > 0 ? "module and gap, " : "", part,
            period.count_key, period.count, period.step_key, period.step, whole,
            remedy(key, part, extra, period));
    });
}

void check_rows(const PanelRows& rows, const FieldForm& field,
                const Spacing& spacing, const Problems& problems) {
    Period across{"field.rows", "spacing.row", spacing.row, field.rows,
                  std::max(1, static_cast<int>(field.row_pattern.size()))};
    Period along{"field.plants", "spacing.plant", spacing.plant, field.plants};
    Cell cell;
    cell.period_x = across.length();
    cell.period_y = along.length();
    const double towards = spacing.row_direction;
    const auto layout = layout_of(rows, cell, towards);
    problems.rule(
        {"azimuth"}, !layout,
        "panel.azimuth is {} (rows of plants run towards {} deg, so that no "
        "cell repeats both); use {}, or another spacing.row_direction",
        rows.azimuth, towards,
        std::fmod(
            towards + 90 * std::round((rows.azimuth - towards) / 90) + 360,
            360));
    if (!layout) return;
    if (!layout->is_along) std::swap(across, along);
    if (rows.pitch > 0) check_period("pitch", rows.pitch, 0, across, problems);
    const double pitch = in_cell(rows, cell, towards).pitch;
    problems.rule({"width"}, rows.width > pitch,
                  "panel.width is {} (rows are {:.6g} m apart, so that modules "
                  "would meet); use {:.6g} or less",
                  rows.width, pitch, pitch);
    if (rows.module_length > 0)
        check_period("gap", rows.gap, rows.module_length, along, problems);
}

//! Reports surfaces of panels and objects that absorb no light.
void check_optics(const ByBand<Lambertian>& optics, const Problems& problems) {
    for (std::size_t b = 0; b < wavebands.size(); ++b)
        check_surface(wavebands[b].prefix, optics[b], .99, problems);
}

//! Reports modules that touch each other or the soil.
void check_modules(const PanelRows& rows, const Problems& problems) {
    const double steepest = rows.tracks ? rows.max_angle : rows.tilt;
    const double lowest = rows.width / 2 * std::sin(steepest * degree);
    problems.rule(
        {"height", "width", "tilt", "tracks", "max_angle"},
        rows.height < lowest,
        "panel.height is {} (the height of the middle of the modules, whose "
        "lower edge would be in the soil); use {:.6g} or more",
        rows.height, lowest);
    problems.rule({"gap", "module_length"},
                  rows.gap > 0 && rows.module_length == 0,
                  "panel.gap is {} (modules without end have none); add "
                  "module_length, or remove it",
                  rows.gap);
}

//! Reports an object that is much larger than the periodic cell. Warns if an
//! object extends below the soil.
//! @param table path of the object, such as "object[0]"
void check_size(const ObjectEntry& object, const Spec& spec,
                const std::string& table, const Problems& problems) {
    const Problems of_object = problems.in(table);
    if (!of_object.usable({"obj", "faces", "vertices", "x", "y", "z", "turn"}))
        return;
    const Mesh mesh = mesh_of(object);
    const std::string& file = object.mesh.file;
    const std::string key = file.empty() ? "vertices" : "obj";
    const std::string name =
        fmt::format("object.{} \"{}\"", key, file.empty() ? object.name : file);
    const auto [bottom, top] = heights_of(mesh);
    of_object.doubt(
        {key}, top <= 0,
        "{} is below the soil (its top is at z = {:.4g} m), so it has no "
        "effect; raise it by object.z",
        name, top);
    of_object.doubt(
        {key}, top > 0 && bottom < -least_depth,
        "{} reaches {:.4g} m below the soil (z = 0), where there is no "
        "light; raise it by object.z",
        name, -bottom);
    if (spec.field.boundary == Boundary::isolated) return;
    for (std::size_t i = 0; i < spec.spacings.size(); ++i) {
        const Spacing& spacing = spec.spacings[i].value;
        const std::string between = fmt::format("spacing[{}].", i);
        const auto fault = [&]() -> std::string {
            if (!(spacing.plant > 0)) return "";
            Cell cell;
            cell.period_x = spacing.row * spec.field.rows;
            cell.period_y = spacing.plant * spec.field.plants;
            const auto excess = excess_of(mesh, 1, cell);
            if (!excess) return "";
            return fmt::format(
                "{} {}; check that it is in metres, or use a smaller object",
                name, *excess);
        };
        problems.rule(
            {fmt::format("{}.{}", table, key), between + "row",
             between + "plant", "field.rows", "field.plants", "field.boundary"},
            fault);
    }
}

//! Checks that panels repeat with the field at every spacing of the plants.
void check_panel(const PanelEntry& panel, const Spec& spec,
                 const Problems& of_panel, const Problems& problems) {
    check_modules(panel.rows, of_panel);
    check_optics(panel.optics, of_panel);
    for (std::size_t i = 0; i < spec.spacings.size(); ++i) {
        const Spacing& spacing = spec.spacings[i].value;
        if (of_panel.usable({"pitch", "azimuth", "module_length", "gap"}) &&
            problems.in("spacing", i)
                .usable({"row", "plant", "row_direction"}) &&
            problems.usable({"field.rows", "field.plants"}) &&
            spacing.plant > 0)
            check_rows(panel.rows, spec.field, spacing, of_panel);
    }
}

}  // namespace

void check_objects(const Spec& spec, const Problems& problems) {
    std::set<std::string> names;
    for (const ComponentSpec& each : spec.components)
        names.insert(lower_case(each.name));
    const auto check_name = [&](const std::string& table, std::size_t entry,
                                const std::string& name) {
        const std::string key = fmt::format("{}[{}].name", table, entry);
        problems.rule(
            ProblemCode::duplicate, {key},
            [&] { return !names.insert(lower_case(name)).second; },
            "{}.name is \"{}\" (already used); give each a different name",
            table, name);
        problems.rule({key, "field.boundary"},
                      spec.field.boundary == Boundary::isolated,
                      "{} \"{}\" repeats with the field (and field.boundary is "
                      "\"isolated\"); use \"periodic\"",
                      table, name);
    };
    for (std::size_t i = 0; i < spec.panels.size(); ++i) {
        check_name("panel", i, spec.panels[i].rows.name);
        check_panel(spec.panels[i], spec, problems.in("panel", i), problems);
    }
    for (std::size_t i = 0; i < spec.objects.size(); ++i) {
        const ObjectEntry& object = spec.objects[i];
        const Problems of_object = problems.in("object", i);
        check_name("object", i, object.name);
        of_object.rule(
            {"faces", "obj", "vertices"}, !is_whole(object.mesh),
            "object \"{}\" has no surfaces that fit its vertices; give a "
            "file: obj = \"post.obj\"",
            object.name);
        check_size(object, spec, fmt::format("object[{}]", i), problems);
        check_optics(object.optics, of_object);
    }
}

}  // namespace ideotype
