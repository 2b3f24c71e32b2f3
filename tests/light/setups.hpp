// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ideotype/light/illumination.hpp"
#include "reference.hpp"

namespace ideotype {

//! A mesh, how it repeats, and what lights it.
struct Setting {
    Mesh mesh;
    GroundPeriod period{};
    Illumination light;
};

//! One of the ways in which the engine can be asked for the same answer.
struct Setup {
    std::string name;
    std::string isa;         //!< which sets the width of the tree of boxes
    std::uint64_t seed = 1;  //!< seed of the light's paths
    //! More randomisations of fewer paths each, by this factor.
    int split = 1;
    //! Describes the same stand in another way.
    void (*rewrite)(Setting&) = nullptr;
};

//! First the usual one: the widest instruction set and the mesh as it is.
std::vector<Setup> setups();

//! Every face as two triangles with the same surface.
Mesh as_triangles(const Mesh& mesh);

//! Every face cut along the sides of the cells and its parts moved into the
//! cell at the origin.
Mesh cut_and_wrapped(const Mesh& mesh, GroundPeriod period);

}  // namespace ideotype
