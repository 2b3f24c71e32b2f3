// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "pair_light.hpp"

namespace ideotype {

//! f at some places, with its derivatives.
struct Responses {
    std::vector<double> light, value, slope, curvature;

    void resize(std::size_t places) {
        for (auto* part : {&light, &value, &slope, &curvature})
            part->resize(places);
    }

    void respond(const LeafResponse& response, std::size_t first,
                 std::size_t last) {
        if (first < last)
            expand(response, {&light[first], last - first}, &value[first],
                   &slope[first], &curvature[first]);
    }

    Expansion at(std::size_t i) const {
        return {value[i], slope[i], curvature[i]};
    }
};

//! [f(D + b) - f(D)] / b with its derivatives in D.
inline Expansion gain(const Expansion& shaded, const Expansion& lit,
                      double beam) {
    // The difference of less would be mostly rounding.
    constexpr double least = 0.01;
    if (beam < least)
        return {shaded.slope + beam / 2 * shaded.curvature, shaded.curvature,
                0};
    return {(lit.value - shaded.value) / beam,
            (lit.slope - shaded.slope) / beam,
            (lit.curvature - shaded.curvature) / beam};
}

//! Diffuse light in a step, over the energy of its sources.
struct Scales {
    double of_sun, of_sky;

    //! Returns what moments count for.
    Moments weigh(const Expansion& at, double times) const {
        return {times * at.value,
                times * at.slope * of_sun,
                times * at.slope * of_sky,
                times * at.curvature * of_sun * of_sun / 2,
                times * at.curvature * of_sun * of_sky,
                times * at.curvature * of_sky * of_sky / 2};
    }
};

//! The light on leaves in a step, and what they make of it at the temperature
//! of the air.
struct StepLight {
    const PairLight& pair;
    Scales scales{};
    Responses shaded{};                     //!< of places
    Responses lit{};                        //!< of bins
    std::vector<double> beams{};            //!< on leaves, of bins
    std::vector<LeafResponse> responses{};  //!< of groups of plants
    std::vector<double> of_places{};        //!< assimilation, in its amounts
};

}  // namespace ideotype
