// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "ideotype/core/mesh.hpp"
#include "ideotype/crop/plasticity.hpp"

namespace ideotype {

//! One leaf: a blade, or a petiole with several leaflets at its end. Length and
//! width of a compound leaf refer to its middle leaflet.
struct Leaf {
    double length = 0;            //!< arc length of the midrib [m]
    double width = 0;             //!< largest width of the blade [m]
    double insertion_angle = 0;   //!< angle of the base from the stalk [deg]
    double curvature = 0;         //!< angle by which the tip bends down [deg]
    double azimuth = 0;           //!< about the stalk; 0: along the row [deg]
    double insertion_height = 0;  //!< height above the soil [m]
    //! Rotation of the blade about its midrib, at half its length [deg]; a
    //! positive rotation lowers the edge that is on the right as seen from the
    //! stalk.
    double roll = 0;
    //! Rotation of the tip relative to the base about the midrib, proportional
    //! to arc length in between [deg].
    double twist = 0;
    //! Petiole length [m]; 0: the blade is at the stalk.
    double petiole_length = 0;
    double petiole_angle = 0;  //!< petiole angle from the stalk [deg]
    //! Height above the insertion of the leaf below, or above the soil for the
    //! lowest leaf [m]. 0: insertion_height is given instead.
    double internode = 0;
    //! Points of a digitised midrib from the base to the tip: distance from the
    //! stalk and height, in any unit and from any origin. Empty:
    //! insertion_angle and curvature determine the midrib.
    std::vector<glm::dvec2> midrib{};
    //! Fractions of the length of a simple blade: `hidden` is the part at the
    //! base that is still in the whorl, `dead` the dead part at the tip. The
    //! visible blade begins where it emerges.
    double hidden = 0, dead = 0;
};

//! Sets insertion_angle and curvature of a leaf from its digitised midrib: the
//! angle of the first segment, and the difference between the angles of the
//! last and the first segment [deg].
//! @return false, leaving the leaf unchanged, if all points coincide
bool measure_midrib(Leaf& leaf);

//! The shape of all blades, and the leaflets of compound leaves. Leaflets begin
//! at the end of the petiole. Their azimuths differ by equal steps, and the
//! middle leaflet points in the azimuth of the leaf.
struct Blade {
    //! Control values of the width profile: the width over arc length is a
    //! cubic B-spline with these six control values and knots at 1/3 and 2/3,
    //! scaled to a maximum of 1.
    std::vector<double> width_controls;
    double folding_angle = 10;        //!< rise of each half above flat [deg]
    double curvature_exponent = 1.5;  //!< exponent of relative arc length
    int leaflets = 1;
    //! Azimuth difference between leaflets [deg].
    double leaflet_divergence = 0;
    //! Distance by which the middle leaflet starts further out than the others,
    //! along its axis [m].
    double rachis_length = 0;
};

//! A cylinder that carries the blade of each leaf with a petiole_length above
//! 0, and continues as the leaf's rachis.
struct Petiole {
    bool is_present = true;
    double diameter = 0.003;  //!< diameter [m]
};

//! The tissue of an organ other than a leaf. If capacity is 0, its surface does
//! not assimilate; if density is 0, it neither respires nor costs carbon.
struct Tissue {
    //! Capacity of gross assimilation per outer surface area, relative to the
    //! capacity of the highest leaf per one-sided area.
    double capacity = 0;
    double density = 0;  //!< dry mass per volume [kg m-3]
    //! Respiration at 25 deg C: carbohydrate per dry mass [kg kg-1 d-1].
    double maintenance = 0;
    //! Carbohydrate used per dry mass built [kg kg-1]: 1 / 0.658 for stems
    //! (WOFOST, CVS).
    double construction = 1.52;

    //! Returns whether the tissue assimilates, respires or costs carbon.
    bool is_living() const { return capacity > 0 || density > 0; }
};

//! A truncated cone that stands on the soil. Leaves begin at its surface; if a
//! plant has no stalk, leaves begin at the axis.
struct Stalk : Tissue {
    bool is_present = true;
    double height = 2.0;           //!< height [m]
    double base_diameter = 0.024;  //!< diameter at the soil [m]
    double top_diameter = 0;  //!< diameter at the top [m]; 0: as at the base

    //! Returns the radius at a height above the soil [m].
    double radius(double z) const;
};

//! The sheath of each leaf, around the stalk below its blade. A sheath is
//! visible only above the insertion of the next lower leaf.
struct Sheath : Tissue {
    bool is_present = false;
    double length = 0.18;      //!< length down from the insertion [m]
    double thickness = 0.001;  //!< thickness [m]
};

//! Materials of a plant, in the order in which scenes list them.
enum class PlantMaterial : std::uint32_t { leaf, stalk, sheath };

inline constexpr std::uint32_t plant_materials = 3;

//! Another organ: one or more truncated cones, on top of the stalk or at the
//! insertion of a leaf. The azimuth of the first cone is that of the row or of
//! the leaf.
struct Organ : Tissue {
    std::string name;
    bool is_present = true;
    PlantMaterial material = PlantMaterial::stalk;  //!< material of its surface
    //! Rank of the leaf that bears the organ; 0: top of the stalk.
    int leaf = 0;
    double offset = 0;  //!< height above the insertion or the top [m]
    int count = 1;      //!< number of cones, evenly spaced about the stalk
    //! Height range over which the cones are distributed [m].
    double spread = 0;
    double length = 0;         //!< length of each cone [m]
    double base_diameter = 0;  //!< diameter at the base [m]
    double top_diameter = 0;   //!< diameter at the tip [m]
    double inclination = 0;    //!< angle from the vertical [deg]
    int sides = 6;             //!< faces around each cone
    //! Thermal time after silking at which the organ dies [deg C d]; from then
    //! on it has the optics of the stalk and does not assimilate. 0: it stays
    //! green.
    double senescence = 0;
};

//! One plant, described by the measures of its organs.
struct Plant {
    std::string name;
    std::vector<Leaf> leaves;  //!< leaves, lowest first
    Blade blade;
    Stalk stalk;
    Sheath sheath;
    std::vector<Organ> organs;
    Petiole petiole{};
    Plasticity plasticity{};
};

//! Name of the group of dead parts of leaves.
inline constexpr auto dead_leaves = "stalk_dead_leaves";

//! Returns the area of dead parts of leaves [m2].
double dead_area(const Mesh& mesh);

//! Resolution at which curved surfaces are divided into faces.
struct Tessellation {
    //! Cells along a blade, which is two cells wide. Leaflets are four cells
    //! wide and have two thirds as many cells along, at least 4.
    int cells_along = 12;
    int stalk_sides = 8;
};

//! An organ other than a leaf. All sheaths together count as one organ, all
//! petioles as one, and all dead parts of leaves as one.
struct PlantOrgan {
    std::string name;
    bool is_present = false;
    Tissue tissue{};
    double mass = 0;  //!< dry mass [kg]; 0 if the organ is not present
};

//! Lists all organs of a plant except leaves, in the order of their groups:
//! "stalk", "sheath", "petiole", "dead_leaves", then other organs. The mass of
//! sheaths includes parts hidden by lower sheaths, and grows as the blades
//! emerge.
std::vector<PlantOrgan> list_organs(const Plant& plant);

//! Returns the names of the organs of list_organs() that are present.
std::vector<std::string> organ_names(const Plant& plant);

//! Returns whether any leaf has a petiole, even if petioles are not present.
bool has_petioles(const Plant& plant);

//! Returns whether a part of any leaf is dead. Dead parts have the optics of
//! the stalk.
bool has_dead_leaves(const Plant& plant);

//! Sets the height of each leaf with a given internode length: that length
//! above the leaf below. If the internode length of the highest leaf is given,
//! the top of the stalk is set to its height.
void stack_internodes(Plant& plant);

//! Adds or removes the organ with this name; has no effect if the plant cannot
//! have the organ.
void set_present(Plant& plant, const std::string& organ, bool is_present);

//! Returns the surfaces of a plant, with its foot at the origin, the row along
//! y, and z up. Group i is leaf i + 1; one group for each of organ_names()
//! follows. All groups have component 0, and materials are numbered as in
//! PlantMaterial.
//! @throws Error if a blade does not have six width controls.
Mesh build_plant(const Plant& plant, const Tessellation& tessellation);

}  // namespace ideotype
