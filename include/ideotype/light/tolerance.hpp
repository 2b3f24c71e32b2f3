// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/light/transport.hpp"

namespace ideotype {

//! The result of a simulation with just enough paths for a tolerance.
struct Simulation {
    BandTallies tallies;
    int paths = 0;  //!< first hits per randomisation
    //! Whether the limit of paths left the tolerance unmet.
    bool is_capped = false;
    Workload work{};  //!< work that the tolerance asked for
};

//! The fewest paths per randomisation that an evaluation takes.
inline constexpr int fewest_paths = 32;

//! The fewest hits of diffuse light per piece of leaf, in all randomisations of
//! a field. With fewer hits, products of light, which assimilation needs, would
//! scatter more than the light itself.
inline constexpr double hits_of_piece = 1.5;

//! Simulates with as few paths as the tolerance needs, at most the given
//! number. The tolerance bounds the expected standard error, and the standard
//! error of the result may exceed it by its own uncertainty. Trials with random
//! independent numbers and ever more paths decide the number of paths. No
//! trial is part of the result, and the result does not decide when to stop: an
//! error that is too small by chance would then be reported more often (Stein
//! 1945, doi:10.1214/aoms/1177731088). Trials also estimate the variances of
//! beams, skies and scattered light, among which first hits and paths are
//! shared at the least cost. With equal work two scenes share all random
//! numbers, and the result is that of simulate() with this work. With pieces
//! there is more work, especially for diffuse light: the relative error of a
//! concave response of leaves shall be near the tolerance too, and each group
//! of the mesh shall be met more than once. With several bands, each bounded
//! band has trials, and the most demanding band decides the number of first
//! hits. Scattered light of unbounded bands gets about as many paths as that of
//! the first bounded band.
Simulation simulate_to_tolerance(const Subject& subject,
                                 const Accuracy& accuracy,
                                 const Randomness& randomness);

}  // namespace ideotype
