// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "allocation.hpp"
#include "ideotype/light/transport.hpp"

namespace ideotype {

//! The findings of a trial.
struct Findings {
    ByOrigin<Law> laws{};  //!< laws by which variances fall
    //! Rays per unit of the amount of scattered light.
    double rays_per_unit = 0;
    double mean = 0;        //!< light of leaves from all suns
    double first_hits = 0;  //!< first hits of leaves
    bool is_open = false;  //!< tells whether the leaves' light depends on paths
    bool is_whole = true;  //!< tells whether the trial had all suns
};

//! Learns from a simulation of one band.
//! @param is_drawn whether beams are drawn
Findings try_out(const Subject& subject, const Workload& work,
                 int randomisations, const Randomness& randomness,
                 bool is_drawn);

//! The powers with which variances fall with points of nets and lattices that
//! look at a beam. The power of skies and scattered light, which have more
//! dimensions, is 1.
inline constexpr double power_of_nets = 1.1, power_of_lattices = 1.4;

}  // namespace ideotype
