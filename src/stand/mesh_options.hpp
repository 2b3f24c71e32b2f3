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

//! The options of `light MESH`, the light in any mesh; x is
//! east, y is north, z is up.
struct MeshOptions {
    struct Period {
        double x, y;  //!< [m]
    };

    std::string path;
    std::optional<Period> period;
    Boundary boundary = Boundary::periodic;
    std::optional<double> ground_area;  //!< [m2]
    //! Repeats the mesh, as one plant at the origin, into a field.
    std::optional<FieldForm> field;

    std::optional<SunPosition> sun;
    std::optional<SkyModel> sky;
    std::optional<Site> site;  //!< with date: a whole clear day
    std::optional<Date> date;

    //! On level ground above the canopy [umol m-2 s-1]: with them all light
    //! is in this unit.
    std::optional<double> beam_ppfd, sky_ppfd;
    std::string climate;         //!< file of a season's light; "": none
    std::string photosynthesis;  //!< file with this table; "": none
    std::string scene;           //!< file of materials and components; "": none
    bool is_exact = false;       //!< assimilation without bias, slowly
    bool is_by_face = false;     //!< also the light on each face

    PlantOptics optics = usual_optics[0];
    double soil_albedo = usual_soil_albedo[0];

    double tolerance = 1e-3;             //!< relative standard error
    std::optional<std::uint64_t> paths;  //!< instead of a tolerance
    std::uint64_t seed = 1;
    bool is_json = false;
};

//! Declares the options of meshes for a command line.
void declare(CLI::App& verb, MeshOptions& options);

//! Reads arguments as a command line has them: {"--sun", "60", "180"}.
//! @throws Error of wrong usage
MeshOptions read_mesh_options(std::vector<std::string> arguments);

//! Returns whether the light is that of a mean day, not a single one.
inline bool has_day(const MeshOptions& options) {
    return options.site || !options.climate.empty();
}

//! @throws Error of wrong usage: options that miss, contradict each other or
//! have impossible values.
void check(const MeshOptions& options);

}  // namespace ideotype
