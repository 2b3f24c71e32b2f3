// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ideotype/canopy/pieces.hpp"
#include "ideotype/core/estimate.hpp"
#include "ideotype/light/illumination.hpp"
#include "ideotype/light/layers.hpp"
#include "ideotype/light/optics.hpp"
#include "ideotype/light/scene.hpp"
#include "ideotype/light/tally.hpp"
#include "ideotype/physiology/photosynthesis.hpp"

namespace ideotype {

inline constexpr double mol_per_umol = 1e-6;

//! Gross assimilation of CO2 per ground area in one randomisation.
struct AssimilationTally {
    std::vector<double> groups;  //!< of the mesh that was cut [mol m-2]
    std::vector<double> layers;  //!< by the heights of pieces [mol m-2]
    std::vector<double> steps;   //!< of all leaves [umol m-2 s-1]

    double gross() const;  //!< of all leaves [mol m-2]
};

//! CO2 that leaves lose by respiration in the dark [mol m-2 day-1].
struct Respiration {
    double in_light = 0;  //!< at the times with any light
    double at_night = 0;
};

//! Assimilation of the leaves of a canopy on a mean day [mol m-2 of ground
//! day-1], or in a second, as the light is.
struct AssimilationReport {
    //! By randomisation: independent, see assimilate().
    std::vector<AssimilationTally> tallies;
    Estimate gross;
    std::vector<Estimate> groups;  //!< gross, of each group of the mesh
    std::vector<Estimate> layers;  //!< gross, lowest layer first
    //! Gross on a mean day, of LightSeries::hours() [umol m-2 s-1].
    std::vector<Estimate> hours;
    std::vector<Estimate> dates;           //!< gross on each, of several days
    std::vector<Respiration> respiration;  //!< of each group of the mesh
    double building = 0;                   //!< carbon that leaves are built of

    //! Respiration of all leaves.
    Respiration all_respiration() const;

    //! What gross assimilation has to be lowered by for that of the lit hours.
    double net_loss() const { return all_respiration().in_light; }

    //! The same for the carbon balance: of day and night, and of building
    //! leaves.
    double carbon_loss() const;
};

//! @param rates,leaf_area_index of each group of the mesh
AssimilationReport report(std::vector<AssimilationTally> tallies,
                          const std::vector<LeafRates>& rates,
                          const std::vector<double>& leaf_area_index,
                          const SeriesIllumination& light,
                          const Photosynthesis& photosynthesis);

//! The rates of each group of a mesh: of leaves by the number at the end of
//! their names, as in leaf01, where there is one.
//! @param leaf_area_index of each group
//! @throws Error if leaves that differ have no numbers.
std::vector<LeafRates> rates_of_groups(
    const Photosynthesis& photosynthesis, const std::vector<Group>& groups,
    const std::vector<double>& leaf_area_index);

//! Air around leaves in a step.
Air air_of(const TimeStep& step, const Photosynthesis& photosynthesis);

//! Gross assimilation of leaves in one field, response by response: the light
//! that a point of a leaf absorbs is diffuse light D, which is taken as even
//! over a piece of a leaf, and where the sun shines on it the beam b, which is
//! the same on all of a triangle:
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
//! @param scene of pieces.mesh
//! @param rates of each group of the mesh that was cut
std::vector<AssimilationTally> assimilate(
    const std::vector<Tally>& tallies, const Scene& scene, const Pieces& pieces,
    const Optics& optics, const SeriesIllumination& light,
    const Photosynthesis& photosynthesis, const std::vector<LeafRates>& rates,
    const Layers& layers);

}  // namespace ideotype
