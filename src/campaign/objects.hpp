// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/canopy/panels.hpp"
#include "ideotype/light/optics.hpp"

namespace ideotype {

//! Rows of panels in a campaign, and their surface in each band.
struct PanelEntry {
    PanelRows rows;
    Lambertian optics{.05, 0}, nir_optics{.15, 0};
};

//! Something that stands in the field of a campaign and repeats with it.
struct ObjectEntry {
    std::string name;
    std::string file;  //!< OBJ file as written
    double x = 0, y = 0, z = 0, turn = 0;
    Lambertian optics{.4, 0}, nir_optics{.4, 0};
    //! Content of the file: three coordinates of each vertex [m], and four
    //! numbers of vertices of each face, from 0.
    std::vector<double> vertices, faces;
};

}  // namespace ideotype
