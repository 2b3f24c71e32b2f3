// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/light/transport.hpp"

namespace ideotype {

//! The result of a simulation with just enough paths to meet a tolerance.
struct Simulation {
    BandTallies tallies;
    int paths = 0;  //!< first hits per randomisation
    //! Whether the path limit was reached before the tolerance.
    bool is_capped = false;
    Workload work{};  //!< work that the tolerance requires
};

//! The smallest number of paths per randomisation of an evaluation.
inline constexpr int fewest_paths = 32;

//! The smallest mean number of hits of diffuse light per piece of leaf, over
//! all randomisations of a field. With fewer hits, the products of light that
//! assimilation uses would scatter more than the light itself.
inline constexpr double hits_of_piece = 1.5;

//! The work that a tolerance requires, before it is done.
struct Demand {
    Workload work{};  //!< without first hits: as many as the accuracy specifies
    //! Expected number of rays of bounded bands, in all randomisations;
    //! infinite if it is unknown, since there was no trial.
    double rays = 0;
    //! Whether the path limit was reached before the tolerance, by band.
    std::vector<bool> is_capped{};
};

//! Returns the work that simulate_to_tolerance() does.
Demand find_demand(const Subject& subject, const Accuracy& accuracy,
                   const Randomness& randomness);

//! Does this work.
Simulation simulate(const Subject& subject, Demand demand,
                    const Accuracy& accuracy, const Randomness& randomness);

//! Simulates with as few paths as the tolerance requires, at most the given
//! number. The tolerance applies to the expected standard error; the standard
//! error of the result may exceed it by its uncertainty.
//!
//! The number of paths is determined by trials of increasing size, with
//! independent random numbers. Trials are not part of the result, and the
//! result does not decide when to stop: otherwise errors that are too small by
//! chance would be reported more often (Stein 1945,
//! doi:10.1214/aoms/1177731088). Trials also estimate the variances due to
//! beams, skies and scattered light, among which first hits and paths are then
//! allocated at the lowest cost. Two scenes with equal work share all random
//! numbers, and the result is that of simulate() with this work.
//!
//! If light is tallied by piece, more work is done, especially for diffuse
//! light. The relative error of a concave leaf response should be near the
//! tolerance too, and each group of the mesh should be hit more than once.
//!
//! If there are several bands, each bounded band has trials, and the most
//! demanding band determines the number of first hits. In unbounded bands,
//! scattered light gets about as many paths as in the first bounded band.
Simulation simulate_to_tolerance(const Subject& subject,
                                 const Accuracy& accuracy,
                                 const Randomness& randomness);

}  // namespace ideotype
