// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ideotype/canopy/scene.hpp"
#include "ideotype/physiology/photosynthesis.hpp"

namespace ideotype {

//! A file that tells what the groups of a mesh are: which material each is made
//! of in each waveband, and which component it belongs to.
struct MeshScene {
    //! A material. Of all that fit a group, the first one counts.
    struct Matter {
        std::vector<std::string> groups;  //!< what names of groups begin with
        std::vector<Material> bands{};
    };
    //! A component; the same rule holds.
    struct Kind {
        std::string name;
        std::vector<std::string> groups;  //!< what names of groups begin with
        std::optional<Photosynthesis> photosynthesis{};
    };

    std::string file;
    std::vector<std::string> bands;   //!< "par" first, if it is one of them
    std::vector<double> soil_albedo;  //!< in each band
    std::vector<Matter> materials;
    std::vector<Kind> components;
};

//! Reads a scene file.
//! @throws InputError with all problems.
//! @throws Error if the file cannot be read.
MeshScene read_mesh_scene(const std::string& path);

}  // namespace ideotype
