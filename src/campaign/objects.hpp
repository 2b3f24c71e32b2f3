// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/canopy/panels.hpp"
#include "ideotype/canopy/scene.hpp"

namespace ideotype {

//! Rows of panels in a campaign, with the optics of panels in each band.
struct PanelEntry {
    PanelRows rows;
    ByBand<Lambertian> optics = std::to_array<Lambertian>({{.05, 0}, {.15, 0}});
};

//! An object in the field of a campaign that repeats with the field.
struct ObjectEntry {
    std::string name;
    std::string file;  //!< OBJ file as written
    double x = 0, y = 0, z = 0, turn = 0;
    ByBand<Lambertian> optics = std::to_array<Lambertian>({{.4, 0}, {.4, 0}});
    //! Content of the file: three coordinates of each vertex [m], and four
    //! vertex numbers of each face, from 0.
    std::vector<double> vertices, faces;
};

}  // namespace ideotype
