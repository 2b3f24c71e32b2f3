// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ideotype/light/tolerance.hpp"

namespace ideotype {

//! Simulates light in one band and a single layer with a workload.
inline std::vector<Tally> simulate(const RayScene& scene,
                                   const std::vector<Group>& groups,
                                   const Optics& optics,
                                   const Illumination& light,
                                   const Workload& work, int randomisations,
                                   const Randomness& randomness) {
    const Band band = band_of(optics, light);
    const Layers layers;
    return simulate({scene, groups, {&band, 1}, layers}, work, randomisations,
                    randomness)
        .front();
}

//! Simulates light in one band and a single layer to a tolerance.
inline Simulation simulate_to_tolerance(const RayScene& scene,
                                        const std::vector<Group>& groups,
                                        const Optics& optics,
                                        const Illumination& light,
                                        const Accuracy& accuracy,
                                        const Randomness& randomness) {
    const Band band = band_of(optics, light);
    const Layers layers;
    return simulate_to_tolerance({scene, groups, {&band, 1}, layers}, accuracy,
                                 randomness);
}

}  // namespace ideotype
