// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! One leaf: a blade, or a petiole and at its end several leaflets, whose
//! middle one has the length and width that are told here.
struct Leaf {
    double length = 0;            //!< arc length of the midrib [m]
    double width = 0;             //!< largest width of the blade [m]
    double insertion_angle = 0;   //!< of its base from the stalk [deg]
    double curvature = 0;         //!< how far the tip bends down [deg]
    double azimuth = 0;           //!< about the stalk, 0: along the row [deg]
    double insertion_height = 0;  //!< above the soil [m]
    //! Turn of the blade about its midrib, halfway along it [deg]; a positive
    //! one lowers the edge that is on the right, as seen from the stalk.
    double roll = 0;
    //! Turn of the blade about its midrib from the base to the tip, in
    //! proportion to arc length [deg].
    double twist = 0;
    double petiole_length = 0;  //!< [m]; 0: the blade is at the stalk
    double petiole_angle = 0;   //!< of the petiole from the stalk [deg]
    //! Height above the leaf below, or of the lowest one above the soil [m];
    //! 0: insertion_height does not follow from it.
    double internode = 0;
    //! Points of a digitised midrib from the base to the tip: distance from the
    //! stalk and height, in any unit and from any origin. None: the angle of
    //! the midrib follows from insertion_angle and curvature.
    std::vector<glm::dvec2> midrib{};
    //! Parts of the length of a single blade: at its base that is not out yet,
    //! and at its tip that is dead. The blade begins where it comes out.
    double hidden = 0, dead = 0;
};

//! Sets insertion_angle and curvature of a leaf whose midrib is digitised: the
//! angle of its first segment, and by how much that of its last one is larger
//! [deg].
//! @return false, and nothing changes, if no two of its points differ
bool measure_midrib(Leaf& leaf);

//! The shape that all blades share, and the leaflets of compound leaves: they
//! begin at the end of the petiole and point to equal steps of azimuth, the
//! middle one where the leaf does.
struct Blade {
    //! Control values of the width profile: the width over arc length is a
    //! cubic B-spline with these six control values and knots at 1/3 and 2/3,
    //! scaled to a maximum of 1.
    std::vector<double> width_controls;
    double folding_angle = 10;        //!< rise of each half from flat [deg]
    double curvature_exponent = 1.5;  //!< of relative arc length
    int leaflets = 1;
    double leaflet_divergence = 0;  //!< azimuth between neighbours [deg]
    double lateral_size = 1;        //!< of the others over the middle one
    //! Distance along its own direction by which the middle one begins further
    //! out [m].
    double rachis_length = 0;
};

//! A cylinder that bears the blade of each leaf whose petiole_length is not 0,
//! and goes on as its rachis.
struct Petiole {
    bool is_present = true;
    double diameter = 0.003;  //!< [m]
};

//! The place where the midribs of leaves begin.
enum class LeafBase { surface, axis };

//! A cone without its tip that stands on the soil.
struct Stalk {
    bool is_present = true;
    double height = 2.0;           //!< [m]
    double base_diameter = 0.024;  //!< [m]
    double top_diameter = 0;       //!< [m]; 0: as at the base
    LeafBase leaf_base = LeafBase::surface;

    //! Half the diameter at a height above the soil [m].
    double radius(double z) const;
};

//! The sheath of each leaf, around the stalk below its blade. Of each sheath
//! shows what is above the insertion of the leaf below it.
struct Sheath {
    bool is_present = false;
    double length = 0.18;      //!< down from the insertion of the leaf [m]
    double thickness = 0.001;  //!< [m]
};

//! Materials of a plant, in the order in which scenes list them.
enum class PlantMaterial : std::uint32_t { leaf, stalk, sheath };

inline constexpr std::uint32_t plant_materials = 3;

//! Any other organ: one or more cones without tips, on top of the stalk or at
//! the insertion of a leaf.
struct Organ {
    std::string name;
    bool is_present = true;
    PlantMaterial material = PlantMaterial::stalk;  //!< material of its surface
    int leaf = 0;       //!< rank of the leaf that it is at; 0: the stalk's top
    double offset = 0;  //!< above that [m]
    int count = 1;      //!< evenly spaced about the stalk
    double spread = 0;  //!< height over which several are spread [m]
    double length = 0;  //!< [m]
    double base_diameter = 0;  //!< [m]
    double top_diameter = 0;   //!< [m]
    double inclination = 0;    //!< from the vertical [deg]
    //! Azimuth of the first [deg]: 0 is along the row, or that of the leaf.
    double azimuth = 0;
    int sides = 6;  //!< faces around each
};

//! One plant: what its organs measure.
struct Plant {
    std::string name;
    std::vector<Leaf> leaves;  //!< lowest first
    Blade blade;
    Stalk stalk;
    Sheath sheath;
    std::vector<Organ> organs;
    Petiole petiole{};
};

//! The name of the group of dead parts of leaves.
inline constexpr auto dead_leaves = "stalk_dead_leaves";

//! Returns the area of dead parts of leaves [m2].
double dead_area(const Mesh& mesh);

//! The fineness with which curved surfaces are cut into faces.
struct Tessellation {
    //! Cells along a blade, which has two across; leaflets have two thirds as
    //! many, at least 4, and four across.
    int cells_along = 12;
    int stalk_sides = 8;
};

//! Returns the names of a plant's present organs besides its leaves, in the
//! order of their groups: "stalk", "sheath", "petiole", "dead_leaves", then the
//! others.
std::vector<std::string> organ_names(const Plant& plant);

//! Returns whether any leaf has a petiole, be it present or not.
bool has_petioles(const Plant& plant);

//! Returns whether a part of any leaf is dead. Dead parts have the optics of
//! the stalk.
bool has_dead_leaves(const Plant& plant);

//! Puts each leaf whose internode is told so far above the leaf below it, and
//! the top of the stalk at the highest leaf if that is one of them.
void stack_internodes(Plant& plant);

//! Gives a plant an organ of that name, or takes it away; nothing happens to
//! plants that cannot have it.
void set_present(Plant& plant, const std::string& organ, bool is_present);

//! Returns the surfaces of a plant: its foot at the origin, y along the row, z
//! up. Group i is leaf i + 1; a group for each of organ_names() follows. The
//! component of all groups is 0, and materials are those of PlantMaterial.
//! @throws Error if a blade does not have six width controls.
Mesh build_plant(const Plant& plant, const Tessellation& tessellation);

}  // namespace ideotype
