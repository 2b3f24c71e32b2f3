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

//! The surfaces and bands that light is followed in, and its counters.
struct Subject {
    const RayScene& scene;
    const std::vector<Group>& groups;  //!< groups of the scene's mesh
    std::span<const Band> bands;       //!< at least one
    const Layers& layers;  //!< layers in which the light of leaves is counted
    //! The number of leading groups, all of them leaves, whose light is told
    //! place by place in the first band.
    std::size_t pieces = 0;

    //! Returns the light of the first band, whose sources all bands have.
    const Illumination& light() const {
        IDEOTYPE_EXPECT(!bands.empty());
        return bands.front().light.light;
    }
};

//! The work of a simulation: how finely each source is looked at in one
//! randomisation.
struct Workload {
    //! First hits of each source; 0: left out.
    std::vector<std::uint32_t> first_hits;
    //! The most that a path of scattered light carries, by band and source [J
    //! m-2 of ground]; in a band that is not listed it is as much as a first
    //! hit.
    std::vector<std::vector<double>> path_energy{};
};

//! The tallies of a simulation, by band and randomisation.
using BandTallies = std::vector<std::vector<Tally>>;

//! Splits first hits among sources in proportion to energy and effort, at least
//! one each, by largest remainders.
std::vector<std::uint32_t> share_paths(const Illumination& illumination,
                                       std::uint32_t paths);

//! Follows light from above the canopy, through as many periods as it takes,
//! until leaves, stalks and soil have absorbed it or it has left upwards.
//!
//! Each source gets a share of the paths in proportion to its energy and
//! effort, at least one; its paths share equally what enters of it, see
//! Launcher. What the beams of a periodic stand meet first is drawn, see
//! DepthBuffer, or found by rays, whichever costs less by what there is to do:
//! that depends on faces and paths and never on a clock. Surfaces keep exactly
//! their absorptance of what they meet first; what they send on is followed in
//! paths of its own. There light is absorbed, reflected or transmitted
//! (Lambertian); see absorb_and_continue() in the source for the unbiased rule
//! that ends paths. In every randomisation the budget of every source sums to
//! what entered, to rounding: in a periodic stand its energy, in an isolated
//! plot what came through its bounding box.
//!
//! Nothing is neglected around an isolated plot: the soil is infinite and lit,
//! and light that leaves the box comes back by way of it. `soil` is then what
//! soil anywhere absorbs, and `reflected` what goes to the sky, of the light
//! that has been in the box.
//!
//! First hits are found once for all bands, by the energies of the first band;
//! what surfaces scatter of them is followed in each band by itself.
//!
//! @return tallies by band and randomisation
BandTallies simulate(const Subject& subject, const Workload& work,
                     int randomisations, const Randomness& randomness);

//! Follows light with so many first hits; the tolerance is not looked at, nor
//! how many fields there are.
//! @throws Error if there are fewer paths than sources.
BandTallies simulate(const Subject& subject, const Accuracy& accuracy,
                     const Randomness& randomness);

//! Follows light in one band.
//! @return one tally per randomisation
std::vector<Tally> simulate(const RayScene& scene,
                            const std::vector<Group>& groups,
                            const Optics& optics,
                            const Illumination& illumination,
                            const Accuracy& accuracy,
                            const Randomness& randomness,
                            const Layers& layers = {}, std::size_t pieces = 0);

//! Returns a band with this light alone, for light that follows no series.
Band band_of(const Optics& optics, const Illumination& illumination);

}  // namespace ideotype
