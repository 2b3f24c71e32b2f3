// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
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
    double period_x = 0;     //!< period across the rows, if periodic [m]
    double period_y = 0;     //!< period along the rows [m]
    double ground_area = 0;  //!< ground area of all figures [m2]
    //! Ground of an isolated plot; surfaces beyond it are cut away.
    std::optional<Rectangle> kept{};
    std::vector<double> rows{};  //!< x coordinates of rows, if any [m]
    double row_distance = 0;  //!< mean distance between neighbouring rows [m]
    //! Area of the ground that is nearest to each row [m2], where rows are
    //! distinguished and each row has one component. Empty: rows are not
    //! distinguished.
    std::vector<double> row_ground{};
};

//! The point of the ground where a plant stands [m].
struct Place {
    double x = 0, y = 0;
    std::uint32_t row = 0;  //!< row of the cell, from 0
};

//! The roots of plants, which grow and respire in proportion to the dry mass of
//! leaves and living organs.
struct Roots {
    double share = 0;  //!< dry mass divided by that of leaves and organs
    //! Respiration at 25 deg C: carbohydrate per dry mass [kg kg-1 d-1].
    double maintenance = 0;
};

//! A kind of plant and the positions of its plants.
struct Component {
    std::string name;
    //! One plant with its foot at the origin and the row along y. The component
    //! numbers in this mesh are ignored: the scene numbers its components.
    Mesh mesh;
    std::vector<Place> places{{}};
    //! Number of plants in a mixture. For each field, this many of the
    //! positions are selected at random; other components of the mixture occupy
    //! the rest. 0: the component occupies all positions.
    std::size_t mixed = 0;
    //! Largest random rotation of plants, either way [deg].
    double jitter = 0;
    //! Angle by which the plane of each plant's leaves turns towards the widest
    //! gap between plants, relative to its angle from the direction of the gap,
    //! and whether this gap is along the row instead of across it.
    double turn = 0;
    bool is_gap_along_row = false;
    //! The plant from which the mesh is built and from which other plants of
    //! its line deviate. None if the mesh was not built by this program.
    std::optional<Plant> plant{};
    Tessellation tessellation{};  //!< tessellation of the plants
    PlantVariation variation{};
    //! Model of assimilation, if leaves assimilate.
    std::optional<Photosynthesis> photosynthesis{};
    double ground_per_plant = 0;  //!< total ground area per plant [m2]
    //! The full-grown plant, if `plant` has another age.
    std::optional<Plant> full_grown{};
    //! The full-grown plant at the reference density of its crop, if plants
    //! respond to density. It is compared with measured lines.
    std::optional<Plant> at_reference{};
    //! The area of each leaf that was built during the period of the light [m2
    //! per plant], if plants grow. Empty: all leaf area, built in the number of
    //! days that `photosynthesis` specifies.
    std::vector<double> built{};
    //! The dry mass of each organ of list_organs() that was built during that
    //! period [kg per plant], if `built` is not empty.
    std::vector<double> built_organs{};
    Stomata stomata{};  //!< stomata, for leaves that exchange water
    Roots roots{};      //!< roots, if they are included
    //! Share of gross assimilation less respiration, in the period of the
    //! light, that the ears later respire during grain filling.
    double ear_share = 0;

    //! Returns the number of plants in a field, missing plants included.
    std::size_t plants() const { return mixed > 0 ? mixed : places.size(); }
};

//! An object that does not grow and stands where its mesh is, such as a panel
//! or a post. An object that moves with the sun has one group per orientation.
struct FixedObject {
    std::string name;
    Mesh mesh;
    bool is_panel = false;  //!< whether the object is a panel
};

//! Leaves above this temperature count as hot [deg C].
inline constexpr double hot_leaf = 35;

//! The exchange of heat and water between leaves and the air, see
//! leaf_exchange().
struct LeafWater {
    //! Whether the energy balance determines leaf temperature. If not, leaves
    //! are at air temperature and transpire without a boundary layer.
    bool has_leaf_temperature = true;
    //! Whether the air within the canopy has a separate state: one node, which
    //! the canopy warms and moistens. If not, leaves are in the air above the
    //! canopy.
    bool has_canopy_air = true;
    //! Conductance of the lower over that of the upper leaf side.
    double stomatal_ratio = 1;
    //! A in the wind profile exp(-a (1 - z / h)) within the canopy.
    double wind_attenuation = 2;
    //! Openings of stomata under stress for which fluxes are also computed, in
    //! falling order, see ClosedStomata.
    std::vector<double> openings{};
};

//! All surfaces that light can meet, the light sources, and the models of
//! leaves: the complete description from which a canopy is evaluated.
struct Scene {
    std::vector<Component> components;
    std::vector<FixedObject> objects{};
    Cell cell;
    //! Wavebands of the light; the first is PAR, which drives assimilation.
    Bands bands;
    //! Photons per unit of irradiance of the first band [umol J-1]; 1 if the
    //! irradiance is in umol m-2 s-1.
    double photons = 4.57;
    //! Options of the exchange, if leaves exchange heat and water.
    std::optional<LeafWater> water{};

    const SeriesIllumination& light() const {
        IDEOTYPE_EXPECT(!bands.empty());
        return bands.front().light;
    }

    //! Returns whether plants of any component differ in more than their
    //! rotation.
    bool varies() const {
        return std::ranges::any_of(components, &PlantVariation::is_any,
                                   &Component::variation);
    }
    //! Returns whether leaves of any component assimilate.
    bool assimilates() const;

    //! Returns whether any assimilating component has non-leaf organs of living
    //! tissue.
    bool has_living_organs() const;
};

//! Returns the groups of all components followed by those of all objects, each
//! with the number of its component or object.
//! @param lines meshes that replace the components' meshes, or empty
std::vector<Group> groups_of(const Scene& scene,
                             std::span<const Mesh> lines = {});

//! Optical properties of a plant in one waveband.
struct PlantOptics {
    Lambertian leaf, stalk, sheath;

    //! Returns the materials in the order of PlantMaterial.
    std::vector<Material> materials() const {
        return {Material(leaf), Material(stalk), Material(sheath)};
    }
};

//! A waveband in which campaigns can trace light.
struct Waveband {
    std::string name;             //!< name of the band in keys and results
    std::string prefix;           //!< prefix of the band's keys in tables
    std::string table;            //!< table with the optics of plants
    Irradiance TimeStep::*light;  //!< light of the band in a step
};

//! All wavebands of campaigns. PAR is the first one.
inline const std::array wavebands{
    Waveband{"par", "", "optics", &TimeStep::par},
    Waveband{"nir", "nir_", "optics.nir", &TimeStep::nir}};
inline constexpr std::size_t par_band = 0, nir_band = 1;  //!< in wavebands

//! A list of one item for each of the wavebands, in their order.
template <class T>
using ByBand = std::array<T, wavebands.size()>;

//! Optical properties that apply if a campaign specifies no others. PAR: leaves
//! as in arXiv:2512.06064, stalks and sheaths as measured for maize. Near
//! infrared: leaves of maize by PROSPECT-D (Feret and others 2017,
//! doi:10.1016/j.rse.2017.03.004); all other values are estimates.
inline constexpr ByBand<PlantOptics> usual_optics = std::to_array<PlantOptics>(
    {{{.05, .05}, {.31, .12}, {.09, 0}}, {{.4, .43}, {.4, .1}, {.4, .1}}});
inline constexpr ByBand<double> usual_soil_albedo = std::to_array({.1, .2});

//! Replaces the mesh of a component by that of another plant.
//! @param first index of the leaf material among the scene's materials
void set_plant(Component& component, const Plant& plant,
               std::uint32_t first = 0);

}  // namespace ideotype
