// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "ideotype/core/random.hpp"
#include "ideotype/light/accuracy.hpp"
#include "ideotype/light/illumination.hpp"
#include "ideotype/light/layers.hpp"
#include "ideotype/light/optics.hpp"
#include "ideotype/light/scene.hpp"
#include "ideotype/light/tally.hpp"

namespace ideotype {

//! How finely each source is looked at in one randomisation.
struct Workload {
    std::vector<std::uint32_t> first_hits;  //!< of each source; 0: left out
    //! Of each source, what a path of scattered light carries at most
    //! [J m-2 of ground]; empty: as much as a first hit.
    std::vector<double> path_energy{};
};

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
//! The tolerance is not looked at, nor how many fields there are.
//!
//! @param groups what each group of the scene's mesh is made of
//! @param layers in which the light that leaves absorb is counted
//! @return one tally per randomisation
//! @throws Error if there are fewer paths than sources.
std::vector<Tally> simulate(
    const Scene& scene, const std::vector<Group>& groups, const Optics& optics,
    const Illumination& illumination, const Accuracy& accuracy,
    const Randomness& randomness, const Layers& layers = {},
    Detail detail = Detail::sums);

//! The same with a workload.
std::vector<Tally> simulate(
    const Scene& scene, const std::vector<Group>& groups, const Optics& optics,
    const Illumination& illumination, const Workload& work, int randomisations,
    const Randomness& randomness, const Layers& layers = {},
    Detail detail = Detail::sums);

}  // namespace ideotype
