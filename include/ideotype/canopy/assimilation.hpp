// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ideotype/canopy/pieces.hpp"
#include "ideotype/canopy/scene.hpp"
#include "ideotype/core/estimate.hpp"
#include "ideotype/crop/plant.hpp"
#include "ideotype/light/band.hpp"
#include "ideotype/light/layers.hpp"
#include "ideotype/light/ray_scene.hpp"
#include "ideotype/light/tally.hpp"
#include "ideotype/physiology/photosynthesis.hpp"

namespace ideotype {

inline constexpr double mol_per_umol = 1e-6;

//! A flux of leaves per ground area in one randomisation, such as gross
//! assimilation of CO2, to which the units belong; amounts are for a mean day.
struct FluxTally {
    //! Amount by group of the uncut mesh [mol m-2].
    std::vector<double> groups;
    std::vector<double> layers;  //!< amount by layer of the pieces [mol m-2]
    std::vector<double> steps;   //!< flux of all leaves by step [umol m-2 s-1]
    std::vector<double>
        rows{};  //!< amount by row, if rows are distinguished [mol m-2]
    //! Leaf area index by group, and by row and group, of gross assimilation if
    //! randomisations have separate fields.
    std::vector<double> leaf_area{}, leaf_area_of_rows{};

    //! Adds another flux of the same leaves.
    FluxTally& operator+=(const FluxTally& more);

    double sum() const;  //!< amount of all leaves
};

//! A flux of leaves on a mean day, from all independent randomisations.
struct FluxReport {
    std::vector<FluxTally> tallies;
    Estimate sum;
    std::vector<Estimate> groups;  //!< flux of each group of the mesh
    std::vector<Estimate> layers;  //!< flux of each layer, the lowest first
    std::vector<Estimate> hours;   //!< flux at LightSeries::hours()
    std::vector<Estimate> dates;   //!< flux on each date, if there are several
};

//! Reports a flux from its tallies.
//! @param amount_of amount in a step over the flux, on a mean day
FluxReport report(std::vector<FluxTally> tallies, const LightSeries& series,
                  double (*amount_of)(const TimeStep& step));

//! Carbon that leaves lose [mol m-2 day-1].
struct CarbonLoss {
    double in_light = 0;  //!< dark respiration at times with any light
    double at_night = 0;  //!< respiration at other times
    double building = 0;  //!< carbon in the tissue of leaves
    double of_ears = 0;  //!< respiration of ears, when they fill, of the carbon

    CarbonLoss& operator+=(const CarbonLoss& more);

    //! Returns the loss if respiration and building are lowered to a share.
    CarbonLoss scaled(double share) const;

    //! Returns the respiration by day and night.
    double respired() const { return in_light + at_night + of_ears; }

    //! Returns the loss by which the carbon balance is less than
    //! AssimilationReport::before_losses().
    double all() const { return in_light + at_night + building + of_ears; }
};

//! Assimilation of the leaves of a canopy on a mean day [mol m-2 of ground
//! day-1], or in a second if the light is that of an instant.
struct AssimilationReport {
    FluxReport gross;  //!< flux; hours in [umol m-2 s-1]
    //! Gross assimilation less the respiration in light that is not among the
    //! losses, if leaves have their own temperature.
    std::optional<FluxReport> uptake;
    //! Loss of each group of the mesh; leaves respire as if as warm as the air.
    std::vector<CarbonLoss> losses;
    //! Losses of groups by randomisation, if these have separate fields.
    std::vector<std::vector<CarbonLoss>> losses_by_randomisation;
    //! Gross assimilation less respiration after silking by randomisation, if
    //! plants grow.
    std::vector<double> late_net;
    //! Dry mass of each group of leaves and living organs per ground area [kg
    //! m-2], without roots: that built in the time of the light, if plants
    //! grow.
    std::vector<double> dry_mass;

    //! Returns the flux by which losses are exceeded where leaves gain carbon.
    const FluxReport& before_losses() const { return uptake ? *uptake : gross; }

    //! Returns the losses of groups in a randomisation.
    const std::vector<CarbonLoss>& losses_in(std::size_t randomisation) const {
        return losses_by_randomisation.empty()
                   ? losses
                   : losses_by_randomisation[randomisation];
    }
};

//! Sums up losses of groups.
CarbonLoss sum_of(const std::vector<CarbonLoss>& losses);

//! Assimilation of one component or row, in units of AssimilationReport.
struct ComponentAssimilation {
    Estimate gross;
    Estimate uptake{};  //!< AssimilationReport::before_losses()
    CarbonLoss loss{};
    //! Loss by randomisation, if these have separate fields.
    std::vector<CarbonLoss> loss_by_randomisation{};
};

//! Sums up a report by component.
//! @param groups groups of the report, with the numbers of components
std::vector<ComponentAssimilation> by_component(
    const AssimilationReport& report, const std::vector<Group>& groups,
    std::size_t components);

//! The dry mass and tissue of a non-leaf organ in a group of a mesh.
struct OrganGroup {
    Tissue tissue{};
    double mass = 0;  //!< dry mass per ground area [kg m-2]
};

//! The rates of the leaves, or of an organ, of a group of a mesh.
struct LeafGroup {
    LeafRates rates{};
    //! Photosynthesis of the component; null: the group neither assimilates nor
    //! costs carbon.
    const Photosynthesis* photosynthesis = nullptr;
    //! Leaf area, or dry mass [kg m-2] of an organ, per ground area that was
    //! built, see Component::built.
    std::optional<double> built{};
    std::optional<OrganGroup> organ{};  //!< none: the group is of leaves
    Roots roots{};                      //!< roots that bear the group
    double ear_share = 0;               //!< see Component::ear_share
    std::uint32_t component = 0;        //!< component of a living group
    //! Leaf area index of the component if no plant is missing or deviates from
    //! its line; 0: fields do not differ. Dry mass and past growth are those
    //! of such plants, and fields have them in proportion to leaf area.
    double lai_of_line = 0;

    //! Returns whether leaves of the group exchange heat and water with the
    //! air. Other organs have few stomata, and exchange neither.
    bool exchanges_water() const { return photosynthesis && !organ; }
};

//! The photosynthesis of leaves of each group of a scene, by their rank.
//! If any leaf of a component has no rank, all its leaves count as one leaf.
//! Organs have the response of the highest leaf, with their share of its
//! capacity and without its respiration, which follows from their mass. Roots
//! count with the groups in proportion to the mass of which they grow.
//! @param groups groups of the scene
//! @param leaf_area_index leaf area index of each group; if plants vary, that
//! of plants that do not deviate from their line
//! @throws Error if leaves that differ have no rank.
std::vector<LeafGroup> leaf_groups(const Scene& scene,
                                   const std::vector<Group>& groups,
                                   const std::vector<double>& leaf_area_index);

//! Returns the loss of a group in some field or row: leaves in proportion to
//! their area there, organs and past growth in proportion to the leaf area
//! of their component, since these are where its plants are.
//! @param loss loss in the whole
//! @param part,whole leaf area by group in the field or row, and in the whole
CarbonLoss loss_of_part(const CarbonLoss& loss,
                        const std::vector<LeafGroup>& leaves, std::size_t group,
                        std::span<const double> part,
                        std::span<const double> whole);

//! Reports assimilation, respiration and the building of leaves.
//! @param uptake tallies of LeafFlux::uptake
//! @param respired tallies of LeafFlux::respiration; empty: none
//! @param leaves,leaf_area_index rates and area index of the mesh's groups
AssimilationReport report(std::vector<FluxTally> uptake,
                          const std::vector<FluxTally>& respired,
                          const std::vector<LeafGroup>& leaves,
                          const std::vector<double>& leaf_area_index,
                          const SeriesIllumination& light);

//! Returns the air around leaves in a step.
Air air_of(const TimeStep& step, const Photosynthesis& photosynthesis);

class LeafAir;

//! Light and leaves that assimilate in a field.
struct LitLeaves {
    const RayScene& scene;
    //! Groups of the scene's mesh.
    const std::vector<Group>& groups;
    const Band& par;
    double photons;  //!< photons per unit of PAR irradiance [umol J-1]
    //! Leaves of each group of the mesh; if the mesh is cut into pieces, of
    //! each group of the uncut mesh.
    const std::vector<LeafGroup>& leaves;
    const Layers& layers;
    LeafAir* air = nullptr;  //!< air for leaves with heat and water exchange
};

//! Finds the gross assimilation of leaves in one field, response by response:
//! the light that a point of a leaf absorbs is diffuse light D, which is taken
//! as even over a piece of a leaf, and where the sun shines on the point also
//! the beam b, which is the same everywhere on a triangle:
//!
//!     A = integral of f(D) + sum over first hits of beams of
//!         w [f(D + b) - f(D)] / b
//!
//! where f is the response and w the light that a hit absorbs: w / b is sunlit
//! leaf area. f is concave, so noise in D lowers A, by several per cent where
//! few paths meet a piece. So f is expanded to second order about an expected
//! diffuse light c: the mean light of the same piece in all plants that are
//! alike, joined to its neighbours until the mean is well known. The deviation
//! of a piece enters as D - c and (D - c)^2, and these estimates have no bias
//! however few paths meet the piece, see PairLight; nor does noise in c matter
//! to second order. Steps that share a sun are sums of the same numbers, so
//! that many steps cost little. The returned tallies are pseudo-values of a
//! jackknife over randomisations; their scatter gives the error. The remaining
//! bias is of third order: see tests/benchmark/README.md.
//!
//! @param tallies tallies with leaf light, of independent randomisations of one
//! field; a single tally is not corrected
//! @param lit lit leaves with the scene of pieces.mesh
//! @return tallies of gross assimilation, and then, if leaves exchange heat and
//! water, of each further LeafFlux
std::vector<std::vector<FluxTally>> assimilate(
    const std::vector<Tally>& tallies, const Pieces& pieces,
    const LitLeaves& lit);

}  // namespace ideotype
