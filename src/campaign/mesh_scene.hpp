// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ideotype/canopy/scene.hpp"
#include "ideotype/physiology/photosynthesis.hpp"

namespace ideotype {

//! A file that describes the groups of a mesh: the material of each group in
//! each waveband, and the component of each group.
struct MeshScene {
    //! A material; the first material that fits a group counts.
    struct Matter {
        std::vector<std::string> groups;  //!< prefixes of group names
        std::vector<Material> bands{};
    };
    //! A component; the first component that fits a group counts.
    struct Kind {
        std::string name;
        std::vector<std::string> groups;  //!< prefixes of group names
        std::optional<Photosynthesis> photosynthesis{};
    };

    std::string file;
    std::vector<std::string> bands;   //!< bands, "par" first if present
    std::vector<double> soil_albedo;  //!< albedo in each band
    std::vector<Matter> materials;
    std::vector<Kind> components;
};

//! Reads a scene file.
//! @throws InputError with all problems.
//! @throws Error if the file cannot be read.
MeshScene read_mesh_scene(const std::string& path);

}  // namespace ideotype
