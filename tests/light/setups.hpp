// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ideotype/light/illumination.hpp"
#include "reference.hpp"

namespace ideotype {

//! A mesh with its period and its light.
struct Setting {
    Mesh mesh;
    GroundPeriod period{};
    Illumination light;
};

//! A way to compute the light of a stand with the engine; all setups must
//! agree.
struct Setup {
    std::string name;
    std::string isa;  //!< instruction set, which sets the width of the tree
    std::uint64_t seed = 1;  //!< seed of the light's paths
    //! The factor by which the number of randomisations increases and the
    //! number of paths in each decreases.
    int split = 1;
    //! Converts the stand to an equivalent description.
    void (*rewrite)(Setting&) = nullptr;
};

//! Returns all setups. The first is the standard one: the widest instruction
//! set and the unchanged mesh.
std::vector<Setup> setups();

//! Cuts every face into two triangles that form the same surface.
Mesh as_triangles(const Mesh& mesh);

//! Cuts every face at the sides of cells, and moves the parts into the cell at
//! the origin.
Mesh cut_and_wrapped(const Mesh& mesh, GroundPeriod period);

}  // namespace ideotype
