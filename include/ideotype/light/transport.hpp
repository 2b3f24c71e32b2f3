// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/random.hpp"
#include "ideotype/light/accuracy.hpp"
#include "ideotype/light/band.hpp"
#include "ideotype/light/layers.hpp"
#include "ideotype/light/ray_scene.hpp"
#include "ideotype/light/tally.hpp"

namespace ideotype {

//! The surfaces and bands in which light is followed, and its counters.
struct Subject {
    const RayScene& scene;
    const std::vector<Group>& groups;  //!< all groups of the scene's mesh
    std::span<const Band> bands;       //!< wavebands, at least one
    const Layers& layers;  //!< layers in which the light of leaves is counted
    //! The number of leading groups, all of them leaves, for which light in the
    //! first band is counted at each place.
    std::size_t pieces = 0;

    //! Returns the light of the first band, which has the sources of all
    //! bands.
    const Illumination& light() const {
        IDEOTYPE_EXPECT(!bands.empty());
        return bands.front().light.light;
    }
};

//! The work of a simulation: the numbers of first hits and paths of each source
//! in one randomisation.
struct Workload {
    //! The number of first hits of each source; 0 leaves the source out.
    std::vector<std::uint32_t> first_hits;
    //! The most that a path of scattered light carries, by band and source [J
    //! m-2 of ground]; by default the energy of a first hit.
    std::vector<std::vector<double>> path_energy{};
};

//! The tallies of a simulation, by band and randomisation.
using BandTallies = std::vector<std::vector<Tally>>;

//! Splits first hits among sources in proportion to energy and effort, at least
//! one each, by the method of largest remainders.
std::vector<std::uint32_t> share_paths(const Illumination& illumination,
                                       std::uint32_t paths);

//! Follows light from above the canopy, through as many periods as it takes,
//! until leaves, stalks and soil have absorbed it or it has left upwards. Each
//! source gets a share of the paths in proportion to its energy and effort, at
//! least one; the paths share its entering light equally, see Launcher. First
//! hits of beams in a periodic stand come from a DepthBuffer or from rays:
//! numbers of faces and paths, never a clock, decide which costs less. At a
//! first hit a surface absorbs exactly its absorptance; separate paths follow
//! the scattered light, which is absorbed, reflected or transmitted
//! (Lambertian); see absorb_and_continue() in the source for the unbiased rule
//! that ends paths. In every randomisation the budget of every source sums, to
//! rounding, to the light that entered: the source's energy in a periodic
//! stand, the light through the bounding box of an isolated plot. neglected
//! around an isolated plot: the soil is infinite and lit, and light that leaves
//! the box may return from the soil. Of the light that has been in the box,
//! `soil` is then the part that soil anywhere absorbs, and `reflected` the part
//! that goes to the sky. First hits are found once for all bands, by the
//! energies of the first band; scattered light is followed in each band
//! separately.
//!
//! @return tallies by band and randomisation
BandTallies simulate(const Subject& subject, const Workload& work,
                     int randomisations, const Randomness& randomness);

//! Follows light with the first hits that the accuracy gives; its tolerance and
//! number of fields are ignored.
//! @throws Error if there are fewer paths than sources.
BandTallies simulate(const Subject& subject, const Accuracy& accuracy,
                     const Randomness& randomness);

}  // namespace ideotype
