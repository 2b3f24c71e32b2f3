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

//! The input of a study of light in a mesh: x is east, y north, z up. Every
//! key, with its unit, range and default, is declared in spec/tables/mesh.cpp.
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
    //! PPFD on level ground above the canopy [umol m-2 s-1]; if given, all
    //! light has this unit.
    std::optional<double> beam_ppfd{}, sky_ppfd{};
    std::string climate{};         //!< file of a season's light; "": none
    std::string photosynthesis{};  //!< file with [photosynthesis]; "": none
    bool is_exact = false;         //!< unbiased but slow assimilation
    PlantOptics optics = usual_optics[par_band];
    double soil_albedo = usual_soil_albedo[par_band];
    double tolerance = 1e-3;
    long long paths = 0;  //!< smallest number of paths; 0: set by the tolerance
    std::uint64_t seed = 1;

    bool has_date() const { return date.year > 0; }
    //! Returns whether the light is that of a mean day, not of an instant.
    bool has_day() const { return site || !climate.empty(); }
    bool has_ppfd() const { return beam_ppfd || sky_ppfd; }
};

//! Materials and components of a mesh, assigned by group name. The first entry
//! with a prefix of the group name applies.
struct MeshScene {
    struct Component {
        std::string name;
        std::vector<std::string>
            groups;  //!< empty: groups that begin with its name
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

//! A value from the command line, where all values are texts, or from Python.
using GivenValue = std::variant<bool, std::int64_t, double, std::string>;
//! Values by names of keys and tables of MeshSpec; a table has the values of
//! its keys in order, such as {"sun", {60, 180}}.
using GivenKeys = std::map<std::string, std::vector<GivenValue>>;

//! Reads given keys as declared in mesh_table.
//! @param name returns the name of a key for messages
//! @throws Error of wrong usage with all problems.
MeshSpec read_mesh_spec(const GivenKeys& given, KeyNaming name);

}  // namespace ideotype
