#pragma once

#include <string>
#include <vector>

#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! What can be bred of a leaf.
struct LeafTraits {
    double length = 0;           //!< arc length of the midrib [m]
    double width = 0;            //!< largest width of the blade [m]
    double insertion_angle = 0;  //!< of the leaf base from the stem [deg]
    double azimuth = 0;          //!< about the stem, 0 = along the row [deg]
};

//! What is given of a leaf.
struct LeafForm {
    double curvature = 0;         //!< how far the tip bends down [deg]
    double insertion_height = 0;  //!< above the soil [m]
};

//! The shape that all blades share.
struct BladeForm {
    //! Control values of the width profile: the width over arc length is a
    //! cubic B-spline with these six control values and knots at 1/3 and 2/3,
    //! scaled to a maximum of 1.
    std::vector<double> width_controls;
    double folding_angle = 10;        //!< rise of each half from flat [deg]
    double curvature_exponent = 1.5;  //!< of relative arc length
};

//! A cylinder on the soil.
struct StalkForm {
    bool is_present = true;
    double height = 2.0;      //!< [m]
    double diameter = 0.027;  //!< [m]
};

//! How finely curved surfaces are cut into faces.
struct Tessellation {
    int cells_along = 12;  //!< per leaf; two cells across, one per half
    int stalk_sides = 8;
};

//! Everything about a plant that is not bred.
struct PlantForm {
    std::string name;
    std::vector<LeafForm> leaves;  //!< lowest first
    BladeForm blade;
    StalkForm stalk;
};

//! One plant, to be built.
struct Plant {
    PlantForm form;
    std::vector<LeafTraits> traits;  //!< lowest leaf first
    Tessellation tessellation;
};

//! The surfaces of a plant: its foot at the origin, y along the row, z up.
//! Group i is leaf i + 1; the stalk, if present, is the last group.
//! @throws Error if the numbers of leaves differ.
Mesh build_plant(const Plant& plant);

}  // namespace ideotype
