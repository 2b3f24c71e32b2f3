// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/canopy/scene.hpp"
#include "ideotype/climate/sun.hpp"

namespace ideotype {

//! Rows of photovoltaic modules: parallel, evenly spaced and without end.
struct PanelRows {
    std::string name = "panel";
    double pitch = 0;    //!< from row to row [m]; 0: one row in each cell
    double height = 0;   //!< height of the middle of modules [m]
    double width = 0;    //!< width of modules, across the row [m]
    double tilt = 0;     //!< from level; 90 stands upright [deg]
    double azimuth = 0;  //!< where the front looks, clockwise from north [deg]
    double offset = 0;   //!< of the first row from the edge of the cell [m]
    double module_length = 0;  //!< along the row [m]; 0: one without end
    double gap = 0;            //!< between the modules of a row [m]
    //! Modules turn about the axis of their row after the sun, in the place of
    //! the tilt.
    bool tracks = false;
    double max_angle = 60;   //!< from level, of modules that track [deg]
    bool backtracks = true;  //!< so that no row shades another
};

//! Returns how far modules that track are turned from level towards the azimuth
//! of their rows [deg], as pvlib's tracking.singleaxis() computes it about a
//! level axis; they lie level when the sun is down.
double tracker_angle(const PanelRows& panels, const SunPosition& sun);

//! The layout of rows of panels in a cell, whose edges they are parallel to.
struct PanelLayout {
    bool is_along = true;  //!< whether they are parallel to the rows of plants
    double across = 0;     //!< period of the cell across panel rows [m]
    double along = 0;      //!< distance along them [m]
};

//! Returns how rows of panels lie in a cell.
//! @param row_direction of the cell's y axis, clockwise from north [deg]
//! @return nothing if panel rows are neither parallel nor at right angles to
//! the rows of plants
std::optional<PanelLayout> layout_of(const PanelRows& panels, const Cell& cell,
                                     double row_direction);

//! Returns the rows with their pitch, if it is that of the cell.
PanelRows in_cell(PanelRows panels, const Cell& cell, double row_direction);

//! Returns whether a length goes into another a whole number of times.
bool divides(double part, double whole);

//! Builds the modules of a cell, of which groups [0] is one of a fixed object.
//! The adaxial side of faces is the front of modules.
//! @param tilt in the place of that of the rows [deg]
//! @throws Error if the rows do not repeat with the cell.
Mesh panel_mesh(const PanelRows& panels, const Cell& cell, double row_direction,
                double tilt);

}  // namespace ideotype
