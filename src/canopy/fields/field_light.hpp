// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ideotype/canopy/canopy.hpp"
#include "ideotype/canopy/light_classes.hpp"
#include "ideotype/light/sunlit.hpp"
#include "ideotype/light/tolerance.hpp"
#include "plan.hpp"
#include "water/leaf_air.hpp"

namespace ideotype {

//! The names of bands besides PAR that warm leaves.
inline constexpr auto nir = "nir", longwave = "longwave";

//! One plant of each component, as fields are made of them.
struct Lines {
    //! @param scene of the request, or with other groups
    Lines(const Scene& scene, const CanopyRequest& request);

    //! Leaves are cut into pieces, or rows are told apart; then there are:
    bool are_cut = false;
    std::vector<Pieces> pieces;  //!< without their meshes
    std::vector<Mesh> meshes;    //!< meshes of the pieces
    std::vector<Group> groups;   //!< groups of the scene before leaves were cut
    //! The width of blades of each group of plants, if leaves exchange heat
    //! [m].
    std::vector<double> widths;
    double height = 0;  //!< height of the highest plant [m]
};

//! Returns the bands that light is followed in, see SharedByFields.
//! @throws Error if leaves have a temperature and there is no near infrared.
Bands bands_of(const Scene& scene);

//! Numbers that all fields of an evaluation share. The first field tells those
//! that are not known before.
struct SharedByFields {
    Layers layers;
    std::vector<LeafGroup> leaves{};  //!< leaves of each group of the lines
    //! The bands of the scene, and the longwave radiation of the sky as one in
    //! which surfaces are black, if leaves exchange heat.
    Bands bands;
    std::optional<Simulation>
        trial{};  //!< the work that the tolerance asks for
};

//! Light and assimilation in some fields: by randomisation of all of them, or,
//! where each field is one of many, by field. Areas are sums over fields.
struct FieldLight {
    //! Adds what was found in more fields.
    void append(FieldLight more);

    BandTallies light;
    //! Light that leaves absorb by row, where rows are told apart
    //! [J m-2 of ground; band, randomisation, row].
    std::vector<std::vector<std::vector<double>>> rows;
    FluxTallies fluxes;                       //!< if leaves assimilate
    std::vector<double> leaf_area_of_layers;  //!< index, of those [m2 m-2]
    SunlitFractions sunlit;                   //!< by points of leaves
    SunlitFractions hit_by_sun;               //!< by first hits
    std::vector<LightClasses> light_classes;
    std::vector<PlantArea> areas;         //!< areas of components [m2 m-2]
    std::vector<double> leaf_area_index;  //!< of groups of the lines
    std::vector<double> areas_of_groups;  //!< of all copies of faces [m2]
    //! Leaf area index of each row, where they are told apart, and group.
    std::vector<double> areas_of_rows;
    std::uint64_t paths = 0;
    bool is_capped = false;
    Timing seconds;
    int fields = 0;
};

//! Draws a field of a scene, and follows light and assimilation in it.
//! @param scene that the lines are of
FieldLight light_in_field(int number, const CanopyRequest& request,
                          const Scene& scene, const Plan& plan,
                          const Lines& lines, const Device& device,
                          const Clock& clock, SharedByFields& shared);

//! Makes the report of an evaluation from what was found in its fields.
//! @param scene of the request, or with other groups
CanopyReport report_on(const CanopyRequest& request, const Scene& scene,
                       const Lines& lines, const SharedByFields& shared,
                       const FieldLight& found);

}  // namespace ideotype
