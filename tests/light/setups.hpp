// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ideotype/light/illumination.hpp"
#include "reference.hpp"

namespace ideotype {

//! A mesh, its period and its light.
struct Setting {
    Mesh mesh;
    GroundPeriod period{};
    Illumination light;
};

//! One of the ways in which the engine can be asked for the same answer.
struct Setup {
    std::string name;
    std::string isa;  //!< instruction set, which sets the width of the tree
    std::uint64_t seed = 1;  //!< seed of the light's paths
    //! The factor by which there are more randomisations of fewer paths each.
    int split = 1;
    //! Describes the same stand in another way.
    void (*rewrite)(Setting&) = nullptr;
};

//! Returns all setups; the first is the usual one, with the widest instruction
//! set and the mesh as it is.
std::vector<Setup> setups();

//! Cuts every face into two triangles with the same surface.
Mesh as_triangles(const Mesh& mesh);

//! Cuts every face along the sides of the cells and moves its parts into the
//! cell at the origin.
Mesh cut_and_wrapped(const Mesh& mesh, GroundPeriod period);

}  // namespace ideotype
