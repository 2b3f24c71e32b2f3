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

//! The surfaces, the bands in which light is traced, and the tallies requested.
struct Subject {
    const RayScene& scene;
    const std::vector<Group>& groups;  //!< all groups of the scene's mesh
    std::span<const Band> bands;       //!< wavebands, at least one
    const Layers& layers;  //!< layers in which light on leaves is tallied
    //! The number of leading groups, all of them leaves, for which light in the
    //! first band is tallied by piece.
    std::size_t pieces = 0;

    //! Returns the light of the first band; its sources are those of all bands.
    const Illumination& light() const {
        IDEOTYPE_EXPECT(!bands.empty());
        return bands.front().light.light;
    }
};

//! The work of a simulation: the number of first hits and of paths of each
//! source in one randomisation.
struct Workload {
    //! The number of first hits of each source; 0: the source is omitted.
    std::vector<std::uint32_t> first_hits;
    //! The largest energy of a path of scattered light, by band and source [J
    //! m-2 of ground]; by default the energy of a first hit.
    std::vector<std::vector<double>> path_energy{};
};

//! The tallies of a simulation, by band and randomisation.
using BandTallies = std::vector<std::vector<Tally>>;

//! Distributes first hits over sources in proportion to energy times effort,
//! with at least one each, by the method of largest remainders.
std::vector<std::uint32_t> share_paths(const Illumination& illumination,
                                       std::uint32_t paths);

//! Traces light from above the canopy, through as many periods as necessary,
//! until leaves, stalks and soil have absorbed it or it has left upwards.
//!
//! Each source gets paths in proportion to its energy times effort, at least
//! one. The paths share the light that enters equally, see Launcher. First hits
//! of beams in a periodic stand come from a DepthBuffer or from rays, whichever
//! costs less. This choice depends on the numbers of faces and paths, never on
//! a clock. At a first hit, a surface absorbs exactly its absorptance. Separate
//! paths trace the scattered light, which is absorbed, reflected or transmitted
//! (Lambertian). See absorb_and_continue() in the source for the unbiased rule
//! that ends paths.
//!
//! In every randomisation the budget of every source sums, to rounding, to the
//! light that entered. In a periodic stand that is the source's energy, in an
//! isolated plot the light through its bounding box. Nothing is neglected
//! around an isolated plot: the soil is infinite and illuminated, and light
//! that leaves the box may return from the soil. Of the light that has been in
//! the box, `soil` is then the part absorbed by soil anywhere, and `reflected`
//! the part that leaves to the sky.
//!
//! First hits are computed once for all bands, from the energies of the first
//! band. Scattered light is traced in each band separately.
//!
//! @return tallies by band and randomisation
BandTallies simulate(const Subject& subject, const Workload& work,
                     int randomisations, const Randomness& randomness);

//! Traces light with the number of first hits that the accuracy specifies. The
//! tolerance and the number of fields are ignored.
//! @throws Error if there are fewer paths than sources.
BandTallies simulate(const Subject& subject, const Accuracy& accuracy,
                     const Randomness& randomness);

}  // namespace ideotype
