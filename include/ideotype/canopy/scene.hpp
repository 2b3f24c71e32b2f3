// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/mesh.hpp"
#include "ideotype/crop/plant_variation.hpp"
#include "ideotype/light/band.hpp"
#include "ideotype/light/boundary.hpp"
#include "ideotype/physiology/energy_balance.hpp"
#include "ideotype/physiology/photosynthesis.hpp"

namespace ideotype {

//! A rectangle of ground [m].
struct Rectangle {
    double x, y;          //!< lower corner
    double width, depth;  //!< along x and y
};

//! The ground of a scene: x across the rows, y along the rows, soil at z = 0.
struct Cell {
    Boundary boundary = Boundary::periodic;
    double period_x = 0;     //!< on which the stand repeats, if periodic [m]
    double period_y = 0;     //!< period along the rows [m]
    double ground_area = 0;  //!< that all figures refer to [m2]
    //! Ground of an isolated plot; what is not above it is cut away.
    std::optional<Rectangle> kept{};
    std::vector<double> rows{};  //!< places of rows along x, if there are [m]
    double row_distance = 0;  //!< mean distance between neighbouring rows [m]
    //! Ground that is nearer to each row than to others [m2], where rows are
    //! told apart: each then has plants of one component. Empty: they are not.
    std::vector<double> row_ground{};
};

//! The point of the ground where a plant stands [m].
struct Place {
    double x = 0, y = 0;
    std::uint32_t row = 0;  //!< row of the cell, from 0
};

//! A kind of plant and where its plants stand.
struct Component {
    std::string name;
    //! One plant with its foot at the origin, y along the row. The component of
    //! its groups is of no account: the scene numbers them.
    Mesh mesh;
    std::vector<Place> places{{}};
    //! Plants of a mixture: so many of these places are drawn for each field,
    //! and others of the mixture have the rest of the same places. 0: all.
    std::size_t mixed = 0;
    //! Plants turn at random by up to this angle either way [deg].
    double jitter = 0;
    //! The plant that the mesh is built of, from which others of its line
    //! deviate; a mesh from elsewhere has none.
    std::optional<Plant> plant{};
    Tessellation tessellation{};  //!< tessellation of the plants
    PlantVariation variation{};
    std::optional<Photosynthesis> photosynthesis{};  //!< if leaves assimilate
    double ground_per_plant = 0;  //!< all ground over the plants [m2]
    //! The plant full-grown, if it stands as it is at another age.
    std::optional<Plant> full_grown{};
    //! The area of each leaf that grew in the time of the light [m2 per plant],
    //! of plants that grow. Empty: all of it, in the days that photosynthesis
    //! tells.
    std::vector<double> built{};
    Stomata stomata{};  //!< stomata of leaves that exchange water

    //! Plants in a field, with those that are missing.
    std::size_t plants() const { return mixed > 0 ? mixed : places.size(); }
};

//! Something that does not grow and stands where its mesh has it, such as a
//! panel or a post. What moves with the sun has a group for each of its poses.
struct FixedObject {
    std::string name;
    Mesh mesh;
    bool is_panel = false;  //!< whose adaxial side is the front
};

//! The exchange of heat and water of leaves with the air, see leaf_exchange().
struct LeafWater {
    //! True if leaves have a temperature of their own, by their energy balance;
    //! else they have that of the air, and transpire without a boundary layer.
    bool has_leaf_temperature = true;
    //! True if the air within the canopy is its own: one node, which the canopy
    //! warms and moistens. Else it is the air above.
    bool has_canopy_air = true;
    double emissivity = 0.96;     //!< emissivity of leaves
    double stomatal_ratio = 1;    //!< of the lower face over the upper one
    double wind_attenuation = 2;  //!< a in exp(-a (1 - z / h)) in the canopy
    double hot = 35;              //!< leaves that are warmer count [deg C]
};

//! All that light can meet, the light itself, and what leaves make of it: the
//! one thing that canopies are evaluated from.
struct Scene {
    std::vector<Component> components;
    std::vector<FixedObject> objects{};
    Cell cell;
    //! The first one is PAR, which leaves assimilate.
    Bands bands;
    //! Photons in the unit of irradiance of the first band [umol J-1]; 1 if
    //! that unit is umol m-2 s-1.
    double photons = 4.57;
    std::optional<LeafWater> water{};  //!< if leaves exchange heat and water

    const SeriesIllumination& light() const {
        IDEOTYPE_EXPECT(!bands.empty());
        return bands.front().light;
    }

    //! Returns whether plants of any component differ by more than their
    //! direction.
    bool varies() const;
    //! Returns whether leaves of any component assimilate.
    bool assimilates() const;
};

//! Returns the groups of all components, then those of objects, each with its
//! number.
//! @param lines meshes in the place of those of the components, or empty
std::vector<Group> groups_of(const Scene& scene,
                             std::span<const Mesh> lines = {});

//! Optical properties of a plant in one waveband.
struct PlantOptics {
    Lambertian leaf, stalk, sheath;

    //! Returns the materials in the order of PlantMaterial.
    std::vector<Material> materials() const;
};

//! A waveband that campaigns can follow light in.
struct Waveband {
    std::string name;             //!< in keys and results
    std::string prefix;           //!< of keys that tables have for each band
    std::string table;            //!< that tells the optics of plants
    Irradiance TimeStep::*light;  //!< its light in each step of time
};

//! All of them. PAR is the first one.
inline const std::array wavebands{
    Waveband{"par", "", "optics", &TimeStep::par},
    Waveband{"nir", "nir_", "optics.nir", &TimeStep::nir}};
inline constexpr std::size_t nir_band = 1;  //!< place of the near infrared

//! Something in each of the wavebands, in their order.
template <class T>
using ByBand = std::array<T, wavebands.size()>;

//! Optical properties where nothing else is given. Leaves in PAR are as in
//! arXiv:2512.06064, stalks and sheaths those of maize; leaves in the near
//! infrared are those of maize by PROSPECT-D (Feret and others 2017,
//! doi:10.1016/j.rse.2017.03.004), all others there estimates.
inline constexpr ByBand<PlantOptics> usual_optics = std::to_array<PlantOptics>(
    {{{.05, .05}, {.31, .12}, {.09, 0}}, {{.4, .43}, {.4, .1}, {.4, .1}}});
inline constexpr ByBand<double> usual_soil_albedo = std::to_array({.1, .2});

//! Makes the mesh of a component that of another plant.
//! @param first place of its leaves' material among the scene's materials
void set_plant(Component& component, const Plant& plant,
               std::uint32_t first = 0);

}  // namespace ideotype
