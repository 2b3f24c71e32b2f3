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

//! The input for computing the light in a mesh with x east, y north and z up.
//! Every key is declared in spec/tables/mesh.cpp, with its unit, range and
//! default.
struct MeshSpec {
    struct Period {
        double x, y;  //!< period along x and y [m]
    };
    struct Sun {
        double elevation, azimuth;  //!< angles [deg]
    };
    //! A field that consists of copies of the mesh, which is one plant at the
    //! origin.
    struct Field {
        int rows, plants;
        double row_spacing, plant_spacing;  //!< distances [m]
    };

    std::string path{};       //!< OBJ file; empty for a mesh in memory
    bool is_by_face = false;  //!< whether to report the light on each face

    std::string scene{};  //!< file of materials and components; "": none
    std::optional<Period> period{};
    Boundary boundary = Boundary::periodic;
    std::optional<double> ground_area{};
    std::optional<Field> field{};
    std::optional<double> jitter{};
    std::optional<Sun> sun{};
    std::optional<SkyModel> sky{};
    std::optional<Site> site{};
    Date date{0, 1, 1};  //!< date of a clear day at the site; year 0: no date
    //! PPFD on level ground above the canopy [umol m-2 s-1]. If given, all
    //! light is reported in this unit.
    std::optional<double> beam_ppfd{}, sky_ppfd{};
    std::string climate{};  //!< file with the light of a season; "": none
    std::string photosynthesis{};  //!< file with [photosynthesis]; "": none
    bool is_exact = false;         //!< unbiased but slow assimilation
    PlantOptics optics = usual_optics[par_band];
    double soil_albedo = usual_soil_albedo[par_band];
    double tolerance = 1e-3;
    long long paths = 0;  //!< smallest number of paths; 0: by tolerance
    std::uint64_t seed = 1;

    bool has_date() const { return date.year > 0; }
    //! Returns whether the light is averaged over days, not that of an instant.
    bool has_day() const { return site || !climate.empty(); }
    bool has_ppfd() const { return beam_ppfd || sky_ppfd; }
};

//! Materials and components of a mesh, which apply to groups of faces by name.
//! A group uses the first entry that contains a prefix of the group's name.
struct MeshScene {
    struct Component {
        std::string name;
        std::vector<std::string>
            groups;  //!< prefixes; empty: name of the component
        std::optional<MeshLeaves> photosynthesis;
    };

    std::string file;
    std::vector<MaterialSpec> materials;
    std::vector<Component> components;
    std::map<std::string, double> soil_albedo;  //!< albedo in each band
};

extern const Description mesh_table;  //!< describes MeshSpec
//! Scene files, read into MeshScene. The albedo of the soil is a number or a
//! table.
extern const Description mesh_scene_table, mesh_soil_table;

//! A value from Python, or from the command line, where all values are texts.
using GivenValue = std::variant<bool, std::int64_t, double, std::string>;
//! Values by the name of a key or table of MeshSpec. For a table, these are the
//! values of its keys in order, such as {"sun", {60, 180}}.
using GivenKeys = std::map<std::string, std::vector<GivenValue>>;

//! Reads given keys as declared in mesh_table.
//! @param name returns the name of a key for messages
//! @throws Error of wrong usage with all problems.
MeshSpec read_mesh_spec(const GivenKeys& given, KeyNaming name);

}  // namespace ideotype
