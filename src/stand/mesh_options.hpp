// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ideotype/canopy/field.hpp"
#include "ideotype/climate/sky_sampler.hpp"
#include "ideotype/climate/sun.hpp"
#include "ideotype/light/ray_scene.hpp"

namespace CLI {
class App;
}

namespace ideotype {

//! The options of `light MESH`, the light in a mesh; x is east, y north, z up.
struct MeshOptions {
    struct Period {
        double x, y;  //!< coordinates [m]
    };

    std::string path;
    std::optional<Period> period;
    Boundary boundary = Boundary::periodic;
    std::optional<double> ground_area;  //!< area of ground [m2]
    //! A field of copies of the mesh, which is one plant at the origin.
    std::optional<FieldForm> field;

    std::optional<SunPosition> sun;
    std::optional<SkyModel> sky;
    std::optional<Site> site;  //!< site of a clear day, if date is set
    std::optional<Date> date;

    //! Light on level ground above the canopy [umol m-2 s-1]; if given, all
    //! light is in this unit.
    std::optional<double> beam_ppfd, sky_ppfd;
    std::string climate;         //!< file of a season's light; "": none
    std::string photosynthesis;  //!< file with [photosynthesis]; "": none
    std::string scene;           //!< file of materials and components; "": none
    bool is_exact = false;       //!< slow assimilation without bias
    bool is_by_face = false;     //!< whether to report light on each face

    PlantOptics optics = usual_optics[0];
    double soil_albedo = usual_soil_albedo[0];

    double tolerance = 1e-3;             //!< relative standard error
    std::optional<std::uint64_t> paths;  //!< paths, not a tolerance
    std::uint64_t seed = 1;
    bool is_json = false;
};

//! Declares the options of meshes for a command line.
void declare(CLI::App& verb, MeshOptions& options);

//! Reads arguments such as {"--sun", "60", "180"}.
//! @throws Error of wrong usage
MeshOptions read_mesh_options(std::vector<std::string> arguments);

//! Returns whether the light is that of a mean day, not of an instant.
inline bool has_day(const MeshOptions& options) {
    return options.site || !options.climate.empty();
}

//! Checks options.
//! @throws Error of wrong usage: missing, contradictory or impossible options.
void check(const MeshOptions& options);

}  // namespace ideotype
