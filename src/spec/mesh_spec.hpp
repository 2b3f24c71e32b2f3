// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "spec/problems.hpp"
#include "spec/spec.hpp"

namespace ideotype {

struct Description;

//! The light in a mesh: x is east, y north, z up. Every key, with its unit,
//! range and default, is declared in spec/tables/mesh.cpp.
struct MeshSpec {
    struct Period {
        double x, y;  //!< period along x and y [m]
    };
    struct Sun {
        double elevation, azimuth;  //!< angles [deg]
    };
    //! A field of copies of the mesh, which is one plant at the origin.
    struct Field {
        int rows, plants;
        double row_spacing, plant_spacing;  //!< distances [m]
    };

    std::string path{};       //!< OBJ file; a mesh in memory has none
    bool is_by_face = false;  //!< whether to report light on each face

    std::string scene{};  //!< file of materials and components; "": none
    std::optional<Period> period{};
    Boundary boundary = Boundary::periodic;
    std::optional<double> ground_area{};
    std::optional<Field> field{};
    std::optional<double> jitter{};
    std::optional<Sun> sun{};
    std::optional<SkyModel> sky{};
    std::optional<Site> site{};
    Date date{0, 1, 1};  //!< date of a clear day at the site; year 0: none
    //! Light on level ground above the canopy [umol m-2 s-1]; if given, all
    //! light is in this unit.
    std::optional<double> beam_ppfd{}, sky_ppfd{};
    std::string climate{};         //!< file of a season's light; "": none
    std::string photosynthesis{};  //!< file with [photosynthesis]; "": none
    bool is_exact = false;         //!< slow assimilation without bias
    PlantOptics optics = usual_optics[par_band];
    double soil_albedo = usual_soil_albedo[par_band];
    double tolerance = 1e-3;
    long long paths = 0;  //!< least number of paths; 0: by the tolerance
    std::uint64_t seed = 1;

    bool has_date() const { return date.year > 0; }
    //! Returns whether the light is that of a mean day, not of an instant.
    bool has_day() const { return site || !climate.empty(); }
    bool has_ppfd() const { return beam_ppfd || sky_ppfd; }
};

//! The surfaces of a mesh by the names of their groups. The first entry with a
//! text that the name of a group begins with counts.
struct MeshScene {
    struct Component {
        std::string name;
        std::vector<std::string> groups;  //!< none: that of its name
        std::optional<MeshLeaves> photosynthesis;
    };

    std::string file;
    std::vector<MaterialSpec> materials;
    std::vector<Component> components;
    std::map<std::string, double> soil_albedo;  //!< albedo in each band
};

extern const Description mesh_table;  //!< records are MeshSpec
//! Scene files; records are MeshScene. The albedo of the soil is a number or a
//! table.
extern const Description mesh_scene_table, mesh_soil_table;

//! A value of the command line, where all values are texts, or of Python.
using GivenValue = std::variant<bool, std::int64_t, double, std::string>;
//! Values by the names of keys and of tables of MeshSpec; a table has its keys'
//! values in their order, such as {"sun", {60, 180}}.
using GivenKeys = std::map<std::string, std::vector<GivenValue>>;

//! Reads given keys as the table of meshes declares them.
//! @param name the name of a key for messages
//! @throws Error of wrong usage with all problems.
MeshSpec read_mesh_spec(const GivenKeys& given, KeyNaming name);

}  // namespace ideotype
