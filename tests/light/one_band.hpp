// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ideotype/light/tolerance.hpp"

namespace ideotype {

//! Returns a band whose light does not belong to a series of instants.
inline Band band_of(const Optics& optics, const Illumination& illumination) {
    Band band;
    band.optics = optics;
    band.light.light = illumination;
    return band;
}

//! Simulates light in one band.
inline std::vector<Tally> simulate(
    const RayScene& scene, const std::vector<Group>& groups,
    const Optics& optics, const Illumination& light, const Accuracy& accuracy,
    const Randomness& randomness, const Layers& layers = {},
    std::size_t pieces = 0) {
    const Band band = band_of(optics, light);
    return simulate({scene, groups, {&band, 1}, layers, pieces}, accuracy,
                    randomness)
        .front();
}

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
