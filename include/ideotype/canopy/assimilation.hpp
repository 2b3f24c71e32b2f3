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
//! assimilation of CO2. The units below are those of CO2 assimilation; amounts
//! are for a mean day.
struct FluxTally {
    //! Amount by group of the uncut mesh [mol m-2].
    std::vector<double> groups;
    std::vector<double> layers;  //!< amount by layer of the pieces [mol m-2]
    std::vector<double> steps;   //!< flux of all leaves by step [umol m-2 s-1]
    std::vector<double>
        rows{};  //!< amount by row, if rows are distinguished [mol m-2]
    //! Leaf area index by group, and by row and group, for gross assimilation
    //! if each randomisation uses a separate field.
    std::vector<double> leaf_area{}, leaf_area_of_rows{};

    //! Adds another flux of the same leaves, element by element.
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

//! Computes a flux report from tallies.
//! @param amount_of returns the factor that converts the flux in a step to the
//! amount of the step
FluxReport report(std::vector<FluxTally> tallies, const LightSeries& series,
                  double (*amount_of)(const TimeStep& step));

//! Carbon that leaves lose [mol m-2 day-1].
struct CarbonLoss {
    double in_light = 0;  //!< dark respiration at times with any light
    double at_night = 0;  //!< respiration at other times
    double building = 0;  //!< carbon in the tissue of leaves
    double of_ears = 0;   //!< respiration of the ears during grain filling

    CarbonLoss& operator+=(const CarbonLoss& more);

    //! Returns the loss if respiration and leaf construction are multiplied by
    //! a share.
    CarbonLoss scaled(double share) const;

    //! Returns the respiration by day and night.
    double respired() const { return in_light + at_night + of_ears; }

    //! Returns the sum of the losses: AssimilationReport::before_losses() less
    //! this sum is the net carbon balance.
    double all() const { return in_light + at_night + building + of_ears; }
};

//! Assimilation of the leaves of a canopy on a mean day [mol m-2 of ground
//! day-1]. If the light is a single instant, values are per second.
struct AssimilationReport {
    FluxReport gross;  //!< flux; hours in [umol m-2 s-1]
    //! Gross assimilation less the part of respiration in light that `losses`
    //! does not contain, if leaf temperature is computed.
    std::optional<FluxReport> uptake;
    //! Loss of each group of the mesh, with leaves respiring at air
    //! temperature.
    std::vector<CarbonLoss> losses;
    //! Losses of groups by randomisation, if each randomisation uses a separate
    //! field.
    std::vector<std::vector<CarbonLoss>> losses_by_randomisation;
    //! Gross assimilation less respiration after silking, by randomisation, if
    //! plants grow.
    std::vector<double> late_net;
    //! Gross assimilation less respiration without that of ears on each of
    //! LightSeries::dates() [mol m-2], by randomisation, if asked for.
    std::vector<std::vector<double>> net_of_dates;
    //! Dry mass of each group of leaves and living organs, without roots, per
    //! ground area [kg m-2]. If plants grow, only the dry mass that was built
    //! during the period of the light.
    std::vector<double> dry_mass;

    //! Returns the flux from which losses are subtracted: `uptake` if leaf
    //! temperature is computed, otherwise `gross`.
    const FluxReport& before_losses() const { return uptake ? *uptake : gross; }

    //! Returns the losses of groups in a randomisation.
    const std::vector<CarbonLoss>& losses_in(std::size_t randomisation) const {
        return losses_by_randomisation.empty()
                   ? losses
                   : losses_by_randomisation[randomisation];
    }
};

//! Adds the losses of groups.
CarbonLoss sum_of(const std::vector<CarbonLoss>& losses);

//! Assimilation of one component or row, in units of AssimilationReport.
struct ComponentAssimilation {
    Estimate gross;
    Estimate uptake{};  //!< AssimilationReport::before_losses()
    CarbonLoss loss{};
    //! Loss by randomisation, if each randomisation uses a separate field.
    std::vector<CarbonLoss> loss_by_randomisation{};
};

//! Adds up a report by component.
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
    //! Photosynthesis model of the component. Null: the group neither
    //! assimilates nor incurs carbon losses.
    const Photosynthesis* photosynthesis = nullptr;
    //! Leaf area, or dry mass of an organ [kg m-2], that was built per ground
    //! area; see Component::built.
    std::optional<double> built{};
    std::optional<OrganGroup> organ{};  //!< none: the group is of leaves
    Roots roots{};                //!< roots that are attributed to the group
    double ear_share = 0;         //!< see Component::ear_share
    std::uint32_t component = 0;  //!< component of a living group
    //! Leaf area index of the component if no plant is missing or deviates from
    //! its line; 0: all fields are equal. Dry mass and past growth are computed
    //! for such plants and scale with the leaf area of a field.
    double lai_of_line = 0;

    //! Returns whether leaves of the group exchange heat and water with the
    //! air. Other organs have few stomata, and exchange neither.
    bool exchanges_water() const { return photosynthesis && !organ; }
};

//! Returns the photosynthesis of the leaves of each group of a scene by leaf
//! rank. If any leaf of a component has no rank, all its leaves count as one
//! leaf. Organs use the response of the highest leaf, scaled to their share of
//! its capacity. Their respiration is computed from their dry mass instead.
//! Each group includes the roots that grow in proportion to its dry mass.
//! @param groups groups of the scene
//! @param leaf_area_index leaf area index of each group; if plants vary, the
//! index of plants that do not deviate from their line
//! @throws Error if leaves with different rates have no rank.
std::vector<LeafGroup> leaf_groups(const Scene& scene,
                                   const std::vector<Group>& groups,
                                   const std::vector<double>& leaf_area_index);

//! Returns the loss of a group in one field or row. Losses of leaves scale with
//! the area of the group there. Losses of organs and of past growth scale with
//! the leaf area of the component there, because it shows where the component's
//! plants are.
//! @param loss loss in the whole canopy
//! @param part,whole leaf area by group in the field or row, and in the whole
//! canopy
CarbonLoss loss_of_part(const CarbonLoss& loss,
                        const std::vector<LeafGroup>& leaves, std::size_t group,
                        std::span<const double> part,
                        std::span<const double> whole);

//! Reports assimilation, respiration and leaf construction.
//! @param uptake tallies of LeafFlux::uptake
//! @param respired tallies of LeafFlux::respiration; empty: none
//! @param leaves,leaf_area_index rates and area index of the mesh's groups
//! @param is_by_date whether to report AssimilationReport::net_of_dates
AssimilationReport report(std::vector<FluxTally> uptake,
                          const std::vector<FluxTally>& respired,
                          const std::vector<LeafGroup>& leaves,
                          const std::vector<double>& leaf_area_index,
                          const SeriesIllumination& light,
                          bool is_by_date = false);

//! Returns the air around leaves in a step.
Air air_of(const TimeStep& step, const Photosynthesis& photosynthesis);

class LeafAir;
struct CanopyFluxes;

//! A field with its light and the assimilation models of its leaves.
struct LitLeaves {
    const RayScene& scene;
    //! Groups of the scene's mesh.
    const std::vector<Group>& groups;
    const Band& par;
    double photons;  //!< photons per unit of PAR irradiance [umol J-1]
    //! Leaves of each group of the mesh. If the mesh is cut into pieces: of
    //! each group of the uncut mesh.
    const std::vector<LeafGroup>& leaves;
    const Layers& layers;
    LeafAir* air = nullptr;  //!< air for leaves with heat and water exchange
};

//! Computes the gross assimilation of the leaves in one field, one response f
//! at a time. A point on a leaf absorbs diffuse light D, which is taken as
//! uniform over a piece of a leaf. Where the sun shines on the point, it also
//! absorbs the beam b, which is uniform over a triangle:
//!
//!     A = integral of f(D) + sum over first hits of beams of
//!         w [f(D + b) - f(D)] / b
//!
//! where w is the light absorbed at a hit, so that w / b is sunlit leaf area.
//! Because f is concave, noise in D lowers A, by several per cent where few
//! paths meet a piece. Therefore f is expanded to second order about an
//! expected diffuse light c: the mean light of the same piece over all
//! identical plants, pooled with neighbouring pieces until the mean is precise.
//! The deviation of a piece enters as D - c and (D - c)^2. The estimates of
//! both are unbiased however few paths meet the piece, see PairLight. Noise in
//! c has no effect to second order. Time steps with the same sun position are
//! combinations of the same sums, so many steps cost little. The returned
//! tallies are jackknife pseudo-values over randomisations; their scatter gives
//! the standard error. The second-order term of a place is bounded by its
//! response, so that few paths give no heavy tails. The remaining bias is of
//! third order: see tests/benchmark/README.md.
//!
//! @param tallies tallies with leaf light, from independent randomisations of
//! one field; a single tally is not bias-corrected
//! @param lit field with the scene of pieces.mesh
//! @return tallies of gross assimilation, followed by tallies of each further
//! LeafFlux if leaves exchange heat and water
CanopyFluxes assimilate(const std::vector<Tally>& tallies, const Pieces& pieces,
                        const LitLeaves& lit);

}  // namespace ideotype
