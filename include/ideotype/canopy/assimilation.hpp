// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "ideotype/canopy/pieces.hpp"
#include "ideotype/canopy/scene.hpp"
#include "ideotype/core/estimate.hpp"
#include "ideotype/light/band.hpp"
#include "ideotype/light/layers.hpp"
#include "ideotype/light/ray_scene.hpp"
#include "ideotype/light/tally.hpp"
#include "ideotype/physiology/photosynthesis.hpp"

namespace ideotype {

inline constexpr double mol_per_umol = 1e-6;

//! A flux of leaves per ground area in one randomisation, such as gross
//! assimilation of CO2, whose units are given; amounts are those of a mean day.
struct FluxTally {
    std::vector<double> groups;  //!< of the mesh that was cut [mol m-2]
    std::vector<double> layers;  //!< by the heights of pieces [mol m-2]
    std::vector<double> steps;   //!< of all leaves [umol m-2 s-1]
    std::vector<double> rows{};  //!< where they are told apart [mol m-2]

    double sum() const;  //!< of all leaves
};

//! A flux of leaves on a mean day, from all randomisations, which are
//! independent.
struct FluxReport {
    std::vector<FluxTally> tallies;
    Estimate sum;
    std::vector<Estimate> groups;  //!< of the mesh
    std::vector<Estimate> layers;  //!< the lowest first
    std::vector<Estimate> hours;   //!< of LightSeries::hours()
    std::vector<Estimate> dates;   //!< of each, of several days
};

//! Reports a flux from its tallies.
//! @param amount_of a step, over the flux in it, on a mean day
FluxReport report(std::vector<FluxTally> tallies, const LightSeries& series,
                  double (*amount_of)(const TimeStep& step));

//! CO2 that leaves lose by respiration in the dark [mol m-2 day-1].
struct Respiration {
    double in_light = 0;  //!< at the times with any light
    double at_night = 0;
};

//! Assimilation of the leaves of a canopy on a mean day [mol m-2 of ground
//! day-1], or in a second, as the light is.
struct AssimilationReport {
    FluxReport gross;                      //!< of hours [umol m-2 s-1]
    std::vector<Respiration> respiration;  //!< of each group of the mesh
    //! Carbon that leaves of each group of the mesh are built of, and of all.
    std::vector<double> building_of_groups;
    double building = 0;
    //! Gross assimilation after silking by randomisation, and the respiration
    //! of leaves in that time, of plants that grow.
    std::vector<double> late_gross;
    double late_respiration = 0;

    //! Returns the respiration of all leaves.
    Respiration all_respiration() const;

    //! Returns the respiration in lit hours, by which net assimilation is less
    //! than gross assimilation.
    double net_loss() const { return all_respiration().in_light; }

    //! Returns the respiration of day and night and the cost of building
    //! leaves, by which the carbon balance is less than gross assimilation.
    double carbon_loss() const;
};

//! Assimilation of the leaves of one component or row, as in the report of
//! all.
struct ComponentAssimilation {
    Estimate gross;
    Respiration respiration{};
    double building = 0;
};

//! Sums up a report by component.
//! @param groups that the report has, with the numbers of components
std::vector<ComponentAssimilation> by_component(
    const AssimilationReport& report, const std::vector<Group>& groups,
    std::size_t components);

//! The rates of the leaves of a group of a mesh.
struct LeafGroup {
    LeafRates rates{};
    //! Photosynthesis of their component; null: they do not assimilate.
    const Photosynthesis* photosynthesis = nullptr;
    //! Leaf area per ground area that was built, see Component::built.
    std::optional<double> built{};
};

//! Tells how the leaves of each group of a scene assimilate, by their rank.
//! Leaves of a component of which any has no rank are all one leaf.
//! @param groups of the scene
//! @param leaf_area_index of each group
//! @throws Error if leaves that differ have no rank.
std::vector<LeafGroup> leaf_groups(const Scene& scene,
                                   const std::vector<Group>& groups,
                                   const std::vector<double>& leaf_area_index);

//! Reports assimilation, respiration and the building of leaves from tallies
//! of gross assimilation.
//! @param leaves,leaf_area_index of each group of the mesh
AssimilationReport report(std::vector<FluxTally> tallies,
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
    double photons;  //!< in the unit of irradiance of that band [umol J-1]
    //! Leaves of each group of the mesh, or of the one that was cut into
    //! pieces.
    const std::vector<LeafGroup>& leaves;
    const Layers& layers;
    LeafAir* air = nullptr;  //!< that leaves exchange heat and water with
};

//! Finds the gross assimilation of leaves in one field, response by response:
//! the light that a point of a leaf absorbs is diffuse light D, which is taken
//! as even over a piece of a leaf, and where the sun shines on it the beam b,
//! which is the same on all of a triangle:
//!
//!     A = integral of f(D) + sum over first hits of beams of
//!         w [f(D + b) - f(D)] / b
//!
//! where w is the light that a hit absorbs: w / b is sunlit leaf area. f is
//! concave, so noise in D lowers A, by several per cent where few paths meet a
//! piece. So f is expanded to second order about an expected D: the mean light
//! of the same piece in all plants that are alike, joined to its neighbours
//! until that is well known. How a piece differs from it enters as D - c and
//! (D - c)^2, whose estimates have no bias however few paths meet the piece,
//! see PairLight; nor does noise in c matter to second order. Steps of one sun
//! are sums of the same numbers, so that many cost little. The tallies that
//! come back are pseudo-values of a jackknife over randomisations, whose
//! scatter gives the error. What remains is the bias of third order: see
//! tests/benchmark/README.md.
//!
//! @param tallies with leaf light, of independent randomisations of one field;
//! a single one is not corrected
//! @param lit with the scene of pieces.mesh
//! @return tallies of gross assimilation, and then, of leaves that exchange
//! heat and water, of each other LeafFlux
std::vector<std::vector<FluxTally>> assimilate(
    const std::vector<Tally>& tallies, const Pieces& pieces,
    const LitLeaves& lit);

}  // namespace ideotype
