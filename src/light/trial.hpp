// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "allocation.hpp"
#include "ideotype/light/transport.hpp"

namespace ideotype {

//! What a trial shows.
struct Findings {
    ByOrigin<Law> laws{};      //!< how variances fall
    double rays_per_unit = 0;  //!< of the amount of scattered light
    double mean = 0;           //!< light of leaves; of all suns
    double first_hits = 0;     //!< of leaves
    bool is_open = false;      //!< whether that depends on paths
    bool is_whole = true;      //!< whether it had all suns
};

//! Learns from a simulation of one band.
//! @param is_drawn whether beams are
Findings try_out(const Subject& subject, const Workload& work,
                 int randomisations, const Randomness& randomness,
                 bool is_drawn);

//! Powers with which variances fall with points of nets and lattices that look
//! at a beam. Skies and scattered light have more dimensions: 1.
inline constexpr double power_of_nets = 1.1, power_of_lattices = 1.4;

}  // namespace ideotype
