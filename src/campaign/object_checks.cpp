// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "checks.hpp"
#include "ideotype/canopy/quantities.hpp"
#include "ideotype/core/units.hpp"
#include "ideotype/crop/obj_reader.hpp"
#include "reader.hpp"

namespace ideotype {

namespace {

//! A period of the cell: so many steps.
struct Period {
    std::string count_key, step_key;  //!< "field.rows", "spacing.row"
    double step = 0;                  //!< [m]
    int count = 0;
    int least = 1;  //!< the count is a multiple of it

    double length() const { return step * count; }
};

//! Tells how a length that does not go into a period would.
//! @param own what it consists of besides the value of the key
std::string remedy(const std::string& key, double part, double own,
                   const Period& period) {
    constexpr int most = 100;
    for (int count = period.least; count <= most; count += period.least)
        if (divides(part, count * period.step))
            return fmt::format("{} = {}", period.count_key, count);
    const auto nearest = [&](double length) {
        return fmt::format(
            "{} = {:.6g}", key,
            length / std::max(1., std::round(length / part)) - own);
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

//! Tells a length that does not go into a period.
void check_period(const std::string& key, const double& value, double own,
                  const Period& period, Problems& problems) {
    const double part = value + own, whole = period.length();
    if (divides(part, whole)) return;
    problems.add(
        &value,
        fmt::format("panel.{} is {} ({}{:.6g} m does not go into the "
                    "cell of {} {} x {} {:.6g} m = {:.6g} m a whole "
                    "number of times); use {}",
                    key, value, own > 0 ? "module and gap, " : "", part,
                    period.count_key, period.count, period.step_key,
                    period.step, whole, remedy(key, part, own, period)));
}

void check_rows(const PanelRows& rows, const FieldForm& field,
                const Spacing& spacing, Problems& problems) {
    if (!problems.usable({&rows.pitch, &rows.azimuth, &rows.module_length,
                          &rows.gap, &spacing.row, &spacing.plant,
                          &spacing.row_direction, &field.rows,
                          &field.plants}) ||
        !(spacing.plant > 0))
        return;
    Period across{"field.rows", "spacing.row", spacing.row, field.rows,
                  std::max(1, static_cast<int>(field.row_pattern.size()))};
    Period along{"field.plants", "spacing.plant", spacing.plant, field.plants};
    Cell cell;
    cell.period_x = across.length();
    cell.period_y = along.length();
    const auto layout = layout_of(rows, cell, spacing.row_direction);
    if (!layout)
        return problems.add(
            &rows.azimuth,
            fmt::format("panel.azimuth is {} (rows of plants run towards {} "
                        "deg, so that no cell repeats both); use {}, or "
                        "another spacing.row_direction",
                        rows.azimuth, spacing.row_direction,
                        std::fmod(spacing.row_direction +
                                      90 * std::round((rows.azimuth -
                                                       spacing.row_direction) /
                                                      90) +
                                      360,
                                  360)));
    if (!layout->is_along) std::swap(across, along);
    if (rows.pitch > 0) check_period("pitch", rows.pitch, 0, across, problems);
    const double pitch = in_cell(rows, cell, spacing.row_direction).pitch;
    if (problems.usable({&rows.width}) && rows.width > pitch)
        problems.add(
            &rows.width,
            fmt::format("panel.width is {} (rows are {:.6g} m apart, so "
                        "that modules would meet); use {:.6g} or less",
                        rows.width, pitch, pitch));
    if (rows.module_length > 0)
        check_period("gap", rows.gap, rows.module_length, along, problems);
}

void check_optics(const std::string& table, const Lambertian& optics,
                  Problems& problems) {
    constexpr double most = .99;
    if (problems.usable({&optics.reflectance, &optics.transmittance}) &&
        optics.scattered() > most)
        problems.add(
            &optics.transmittance,
            fmt::format("a {} reflects and transmits {} of the light "
                        "(of what it does not absorb nothing is known); "
                        "use {} or less",
                        table, optics.scattered(), most));
}

//! Tells modules that meet each other or the soil.
void check_modules(const PanelRows& rows, Problems& problems) {
    if (!problems.usable({&rows.width, &rows.height, &rows.tilt, &rows.tracks,
                          &rows.max_angle}))
        return;
    const double steepest = rows.tracks ? rows.max_angle : rows.tilt;
    const double lowest = rows.width / 2 * std::sin(steepest * degree);
    if (rows.height < lowest)
        problems.add(
            &rows.height,
            fmt::format("panel.height is {} (of the middle of modules, "
                        "whose lower edge would be in the soil); use "
                        "{:.6g} or more",
                        rows.height, lowest));
    if (problems.usable({&rows.gap, &rows.module_length}) && rows.gap > 0 &&
        rows.module_length == 0)
        problems.add(&rows.gap, fmt::format("panel.gap is {} (modules without "
                                            "end have none); add "
                                            "module_length, or remove it",
                                            rows.gap));
}

//! Tells numbers of faces that are of no vertex.
void check_faces(const ObjectEntry& object, Problems& problems) {
    if (!problems.usable({&object.file, &object.faces, &object.vertices}))
        return;
    const double count = static_cast<double>(object.vertices.size()) / 3;
    if (object.vertices.size() % 3 != 0 || object.faces.size() % 4 != 0 ||
        object.faces.empty() ||
        std::any_of(object.faces.begin(), object.faces.end(), [&](double v) {
            return !(v >= 0 && v < count && v == std::floor(v));
        }))
        problems.add(&object.faces,
                     fmt::format("object \"{}\" has no surfaces that fit its "
                                 "vertices; give a file: obj = \"post.obj\"",
                                 object.name));
}

}  // namespace

void read_objects(const std::string& file, Draft& draft, Problems& problems) {
    for (ObjectEntry& object : draft.campaign.objects) {
        if (!object.vertices.empty() || object.file.empty() ||
            !problems.usable({&object.file}))
            continue;
        try {
            const Mesh mesh = read_obj(path_from(file, object.file)).mesh;
            for (const glm::dvec3& v : mesh.vertices)
                object.vertices.insert(object.vertices.end(), {v.x, v.y, v.z});
            for (const auto& face : mesh.faces)
                object.faces.insert(object.faces.end(), face.begin(),
                                    face.end());
        } catch (const InputError& error) {
            for (const Problem& problem : error.problems())
                problems.add(problem.where, problem.what);
        } catch (const Error& error) {
            problems.add(&object.file,
                         std::string(error.what()) +
                             "; give a path relative to this file");
        }
    }
}

void check_objects(const Draft& draft, Problems& problems) {
    const Campaign& campaign = draft.campaign;
    std::map<std::string, int> names;
    for (const std::shared_ptr<Draft>& each : draft.components)
        names[lower_case(each->campaign.name)] = 1;
    const auto check_name = [&](const std::string& table,
                                const std::string& name) {
        if (problems.usable({&name}) && ++names[lower_case(name)] > 1)
            problems.add(&name, fmt::format("{}.name is \"{}\" (already used); "
                                            "give each a name of its own",
                                            table, name));
        if (problems.usable({&campaign.field.boundary, &name}) &&
            campaign.field.boundary == Boundary::isolated)
            problems.add(&name,
                         fmt::format("{} \"{}\" repeats with the field, "
                                     "and field.boundary is \"isolated\"; "
                                     "use \"periodic\"",
                                     table, name));
    };
    for (const PanelEntry& each : campaign.panels) {
        check_name("panel", each.rows.name);
        check_modules(each.rows, problems);
        check_optics("panel", each.optics, problems);
        check_optics("panel", each.nir_optics, problems);
        for (const Named<Spacing>& spacing : campaign.spacings)
            check_rows(each.rows, campaign.field, spacing.value, problems);
    }
    for (const ObjectEntry& each : campaign.objects) {
        check_name("object", each.name);
        check_faces(each, problems);
        check_optics("object", each.optics, problems);
        check_optics("object", each.nir_optics, problems);
    }
    for (const auto* list : {&campaign.maximised, &campaign.minimised})
        for (const std::string& each : *list)
            if (problems.usable({list}) && is_of_panels(each) &&
                campaign.panels.empty())
                problems.add(list, fmt::format("the objective {} needs panels; "
                                               "add [[panel]]",
                                               each));
}

}  // namespace ideotype
