// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "ideotype/canopy/scene.hpp"
#include "ideotype/climate/sun.hpp"

namespace ideotype {

//! Rows of photovoltaic modules: parallel, evenly spaced and without end.
struct PanelRows {
    std::string name = "panel";
    double pitch = 0;    //!< distance between rows [m]; 0: one row per cell
    double height = 0;   //!< height of the middle of modules [m]
    double width = 0;    //!< width of modules, across the row [m]
    double tilt = 0;     //!< tilt from level; 90: upright [deg]
    double azimuth = 0;  //!< direction of the front from north [deg]
    double offset = 0;   //!< distance of the first row from the cell's edge [m]
    double module_length = 0;  //!< length along the row [m]; 0: endless
    double gap = 0;            //!< distance between modules of a row [m]
    //! Whether modules turn about the axis of their row after the sun; the tilt
    //! is then unused.
    bool tracks = false;
    //! Largest turn of tracking modules from level [deg].
    double max_angle = 60;
    //! Whether modules turn back so that no row shades another.
    bool backtracks = true;
};

//! Returns the angle by which tracking modules are turned from level towards
//! the azimuth of their rows [deg], computed about a level axis as by pvlib's
//! tracking.singleaxis(); modules lie level when the sun is down.
double tracker_angle(const PanelRows& panels, const SunPosition& sun);

//! The layout of rows of panels in a cell, parallel to edges of the cell.
struct PanelLayout {
    bool is_along = true;  //!< whether panel rows are parallel to plant rows
    double across = 0;     //!< period of the cell across panel rows [m]
    double along = 0;      //!< period of the cell along panel rows [m]
};

//! Returns how rows of panels lie in a cell.
//! @param row_direction azimuth of the cell's y axis, clockwise from north
//! [deg]
//! @return nothing if panel rows are neither parallel nor at right angles to
//! the rows of plants
std::optional<PanelLayout> layout_of(const PanelRows& panels, const Cell& cell,
                                     double row_direction);

//! Returns the rows of panels with the pitch filled in that the cell implies.
PanelRows in_cell(PanelRows panels, const Cell& cell, double row_direction);

//! Returns whether a part divides a whole without remainder.
bool divides(double part, double whole);

//! Builds the modules of a cell, with one group, number 0, of a fixed object.
//! The adaxial side of faces is the front of modules.
//! @param tilt tilt that replaces the tilt of the rows [deg]
//! @throws Error if the rows do not repeat with the cell.
Mesh panel_mesh(const PanelRows& panels, const Cell& cell, double row_direction,
                double tilt);

}  // namespace ideotype
