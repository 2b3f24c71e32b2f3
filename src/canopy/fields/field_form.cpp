// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "ideotype/canopy/field.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {

namespace {

//! Returns the x coordinate of each row of a lattice [m]. The distance of the
//! first row from the edge of the cell is half of its distance from the row
//! before it.
std::vector<double> row_places(const FieldForm& form) {
    std::vector<double> rows;
    const std::vector<double>& pattern = form.row_pattern;
    if (pattern.empty()) {
        for (int row = 0; row < form.rows; ++row)
            rows.push_back((row + 0.5) * form.spacing.row);
        return rows;
    }
    IDEOTYPE_EXPECT(std::ranges::min(pattern) > 0);
    double sum = 0;
    for (const double distance : pattern) sum += distance;
    const double mean = sum / static_cast<double>(pattern.size());
    double x = pattern.back() / mean * form.spacing.row / 2;
    for (std::size_t row = 0; rows.size() < static_cast<std::size_t>(form.rows);
         ++row) {
        rows.push_back(x);
        x += pattern[row % pattern.size()] / mean * form.spacing.row;
    }
    return rows;
}

}  // namespace

Cell cell_of(const FieldForm& form) {
    IDEOTYPE_EXPECT(form.rows > 0 && form.plants > 0 && form.border_rows >= 0);
    IDEOTYPE_EXPECT(form.spacing.row > 0 && form.spacing.plant > 0);
    Cell cell;
    cell.boundary = form.boundary;
    cell.period_x = form.rows * form.spacing.row;
    cell.period_y = form.plants * form.spacing.plant;
    cell.ground_area = cell.period_x * cell.period_y;
    cell.rows = row_places(form);
    cell.row_distance = form.spacing.row;
    if (form.border_rows == 0) return cell;
    if (form.rows <= 2 * form.border_rows ||
        form.plants <= 2 * form.border_rows)
        throw Error(fmt::format(
            "a plot of {} x {} plants has no plant left if {} are cut away on "
            "each side; cut fewer, or take a larger plot",
            form.rows, form.plants, form.border_rows));
    const double x = form.border_rows * form.spacing.row;
    const double y = form.border_rows * form.spacing.plant;
    cell.kept = {x, y, cell.period_x - 2 * x, cell.period_y - 2 * y};
    cell.ground_area = cell.kept->width * cell.kept->depth;
    return cell;
}

std::vector<double> ground_of_rows(const FieldForm& form) {
    const std::vector<double> x = row_places(form);
    const double period = form.rows * form.spacing.row;
    const double length = form.plants * form.spacing.plant;
    std::vector<double> ground;
    for (std::size_t row = 0; row < x.size(); ++row) {
        const double before = row > 0 ? x[row - 1] : x.back() - period;
        const double after =
            row + 1 < x.size() ? x[row + 1] : x.front() + period;
        ground.push_back((after - before) / 2 * length);
    }
    return ground;
}

std::vector<Place> places_of(const FieldForm& form,
                             const std::vector<int>& rows) {
    std::vector<Place> places;
    const std::vector<double> x = row_places(form);
    for (int row = 0; row < form.rows; ++row) {
        if (!rows.empty() && std::ranges::find(rows, row) == rows.end())
            continue;
        for (int plant = 0; plant < form.plants; ++plant)
            places.push_back({x[static_cast<std::size_t>(row)],
                              (plant + 0.5) * form.spacing.plant,
                              static_cast<std::uint32_t>(row)});
    }
    return places;
}

void set_places(Component& component, const FieldForm& form,
                const std::vector<int>& rows) {
    component.places = places_of(form, rows);
    IDEOTYPE_EXPECT(!component.places.empty());
    component.jitter = form.jitter;
    component.variation = form.variation;
    const double share = static_cast<double>(form.rows * form.plants) /
                         static_cast<double>(component.places.size());
    component.ground_per_plant = form.spacing.row * form.spacing.plant * share;
}

Component component_of(const Plant& plant, const FieldForm& form,
                       const Tessellation& tessellation) {
    Component component;
    component.name = plant.name;
    component.tessellation = tessellation;
    set_plant(component, plant);
    set_places(component, form);
    return component;
}

}  // namespace ideotype
