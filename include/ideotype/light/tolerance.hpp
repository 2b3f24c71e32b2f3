// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ideotype/light/transport.hpp"

namespace ideotype {

//! The result of a simulation with just enough paths.
struct Simulation {
    BandTallies tallies;
    int paths = 0;           //!< first hits per randomisation
    bool is_capped = false;  //!< more paths would be needed
    Workload work{};         //!< work that the tolerance asked for
};

//! The fewest paths per randomisation that an evaluation takes.
inline constexpr int fewest_paths = 32;

//! Simulates with as little work as the tolerance asks for, at most those
//! given: the tolerance bounds the expected standard error, and the one that is
//! found may exceed it by as much as it is uncertain itself. How many that is
//! comes from trials with random numbers of their own, each with more paths
//! than the one before; none is part of the result, and the result does not
//! decide when to stop: else an error that is too small by chance would be
//! likelier to be reported (Stein 1945, doi:10.1214/aoms/1177731088). They also
//! tell how the scatter is made up of beams, skies and scattered light: each
//! gets first hits or paths so that the whole costs least. With equal work two
//! scenes share all random numbers, and the result is that of simulate() with
//! this work.
//!
//! With pieces there is more work, especially for diffuse light: so much that
//! the relative error of what leaves make of it by a concave response is near
//! the tolerance too, and each group of the mesh is met more than once.
//!
//! In several bands trials are of each that is bounded, and first hits are as
//! many as the most demanding of them needs. Scattered light of other bands
//! gets about as many paths as that of the first bounded one.
Simulation simulate_to_tolerance(const Subject& subject,
                                 const Accuracy& accuracy,
                                 const Randomness& randomness);

}  // namespace ideotype
