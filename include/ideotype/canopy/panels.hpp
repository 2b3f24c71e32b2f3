// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "ideotype/canopy/scene.hpp"
#include "ideotype/climate/sun.hpp"

namespace ideotype {

//! Rows of photovoltaic modules: parallel, evenly spaced and infinite.
struct PanelRows {
    std::string name = "panel";
    double pitch = 0;    //!< distance between rows [m]; 0: one row per cell
    double height = 0;   //!< height of the centre of modules [m]
    double width = 0;    //!< width of modules, across the row [m]
    double tilt = 0;     //!< tilt from level; 90: upright [deg]
    double azimuth = 0;  //!< azimuth of the front, clockwise from north [deg]
    //! Distance of the first row from the edge of the cell [m].
    double offset = 0;
    double module_length = 0;  //!< module length along the row [m]; 0: infinite
    double gap = 0;            //!< distance between modules of a row [m]
    //! Whether modules track the sun by rotating about the axis of their row;
    //! the tilt is then unused.
    bool tracks = false;
    //! Largest rotation of tracking modules from level [deg].
    double max_angle = 60;
    //! Whether modules rotate back so that no row shades another.
    bool backtracks = true;
};

//! Returns the rotation of tracking modules from level towards the azimuth of
//! their rows [deg], about a level axis, as in pvlib's tracking.singleaxis().
//! Modules are level when the sun is down.
double tracker_angle(const PanelRows& panels, const SunPosition& sun);

//! The layout of panel rows in a cell, parallel to edges of the cell.
struct PanelLayout {
    bool is_along = true;  //!< whether panel rows are parallel to plant rows
    double across = 0;     //!< period of the cell across panel rows [m]
    double along = 0;      //!< period of the cell along panel rows [m]
};

//! Returns the layout of panel rows in a cell.
//! @param row_direction azimuth of the cell's y axis, clockwise from north
//! [deg]
//! @return nothing if panel rows are neither parallel nor at right angles to
//! the rows of plants
std::optional<PanelLayout> layout_of(const PanelRows& panels, const Cell& cell,
                                     double row_direction);

//! Returns panel rows with the pitch that the cell implies if they do not
//! specify one.
PanelRows in_cell(PanelRows panels, const Cell& cell, double row_direction);

//! Returns whether a part divides a whole without remainder.
bool divides(double part, double whole);

//! Builds the modules of a cell as one group, number 0, of a fixed object.
//! The adaxial side of faces is the front of modules.
//! @param tilt tilt that replaces the tilt of the rows [deg]
//! @throws Error if the rows do not repeat with the cell.
Mesh panel_mesh(const PanelRows& panels, const Cell& cell, double row_direction,
                double tilt);

}  // namespace ideotype
