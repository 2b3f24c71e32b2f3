// SPDX-License-Identifier: Apache-2.0
#include "ideotype/canopy/panels.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/units.hpp"

namespace ideotype {

namespace {

//! Returns the azimuth of the front relative to the cell's y axis, in quarter
//! turns.
double quarters_of(const PanelRows& panels, double row_direction) {
    return (panels.azimuth - row_direction) / 90;
}

int count_of(double part, double whole) {
    return static_cast<int>(std::lround(whole / part));
}

}  // namespace

double tracker_angle(const PanelRows& panels, const SunPosition& sun) {
    IDEOTYPE_EXPECT(panels.max_angle >= 0);
    if (!(sun.zenith < 90)) return 0;
    const double zenith = sun.zenith * degree;
    const double ideal = std::atan2(
        std::sin(zenith) * std::cos((sun.azimuth - panels.azimuth) * degree),
        std::cos(zenith));
    double angle = ideal;
    if (panels.backtracks) {
        IDEOTYPE_EXPECT(panels.pitch > 0 && panels.width > 0);
        const double lit = panels.pitch / panels.width * std::cos(ideal);
        if (lit < 1) angle -= std::copysign(std::acos(lit), ideal);
    }
    return std::clamp(angle / degree, -panels.max_angle, panels.max_angle);
}

bool divides(double part, double whole) {
    IDEOTYPE_EXPECT(part > 0 && whole > 0);
    constexpr double rounding = 1e-6;
    const double times = whole / part;
    return std::lround(times) > 0 &&
           std::abs(times - std::round(times)) < rounding * times;
}

std::optional<PanelLayout> layout_of(const PanelRows& panels, const Cell& cell,
                                     double row_direction) {
    constexpr double rounding = 1e-9;
    const double quarters = quarters_of(panels, row_direction);
    if (std::abs(quarters - std::round(quarters)) > rounding)
        return std::nullopt;
    if (std::lround(quarters) % 2 != 0)
        return PanelLayout{true, cell.period_x, cell.period_y};
    return PanelLayout{false, cell.period_y, cell.period_x};
}

PanelRows in_cell(PanelRows panels, const Cell& cell, double row_direction) {
    const auto layout = layout_of(panels, cell, row_direction);
    if (panels.pitch == 0 && layout) panels.pitch = layout->across;
    return panels;
}

Mesh panel_mesh(const PanelRows& panels, const Cell& cell, double row_direction,
                double tilt) {
    IDEOTYPE_EXPECT(panels.width > 0 && panels.module_length >= 0);
    const auto layout = layout_of(panels, cell, row_direction);
    const bool is_endless = panels.module_length == 0;
    const double step = layout && is_endless
                            ? layout->along
                            : panels.module_length + panels.gap;
    if (!layout || !divides(panels.pitch, layout->across) ||
        !divides(step, layout->along))
        throw Error(
            fmt::format("the rows of {} do not repeat with the cell of {} x {} "
                        "m; choose a spacing of rows that divides the cell",
                        panels.name, cell.period_x, cell.period_y));
    const double length = is_endless ? step : panels.module_length;
    // Rotating by whole quarters avoids rounding errors.
    const long turn =
        ((std::lround(quarters_of(panels, row_direction)) % 4) + 4) % 4;
    const glm::dvec3 front{turn == 1   ? 1
                           : turn == 3 ? -1
                                       : 0,
                           turn == 0   ? 1
                           : turn == 2 ? -1
                                       : 0,
                           0};
    const glm::dvec3 row{-front.y, front.x, 0};
    const glm::dvec3 down = std::cos(tilt * degree) * front -
                            glm::dvec3{0, 0, std::sin(tilt * degree)};
    Mesh mesh;
    mesh.groups = {{panels.name, {0, SurfaceId::object}}};
    for (int r = 0; r < count_of(panels.pitch, layout->across); ++r)
        for (int m = 0; m < count_of(step, layout->along); ++m) {
            const double across = panels.offset + r * panels.pitch;
            const double along = (m + 0.5) * step;
            const glm::dvec3 middle{layout->is_along ? across : along,
                                    layout->is_along ? along : across,
                                    panels.height};
            const glm::dvec3 d = panels.width / 2 * down, l = length / 2 * row;
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            for (const glm::dvec3& corner : {middle - d - l, middle + d - l,
                                             middle + d + l, middle - d + l})
                mesh.vertices.push_back(corner);
            mesh.faces.push_back({first, first + 1, first + 2, first + 3});
            mesh.face_group.push_back(0);
        }
    return mesh;
}

}  // namespace ideotype
