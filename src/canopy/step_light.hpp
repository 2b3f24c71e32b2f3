// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "pair_light.hpp"

namespace ideotype {

//! The response of leaves to light at some places, with its derivatives.
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

//! Returns the gain of leaves in the sun, [f(D + b) - f(D)] / b, with its
//! derivatives in D: f is the response, D the diffuse light and b the beam.
inline Expansion gain(const Expansion& shaded, const Expansion& lit,
                      double beam) {
    // For a weaker beam the difference would be mostly rounding errors.
    constexpr double least = 0.01;
    if (beam < least)
        return {shaded.slope + beam / 2 * shaded.curvature, shaded.curvature,
                0};
    return {(lit.value - shaded.value) / beam,
            (lit.slope - shaded.slope) / beam,
            (lit.curvature - shaded.curvature) / beam};
}

//! The diffuse light of the sun's source and of the sky's source in a step,
//! each over the energy of the source.
struct Scales {
    double of_sun, of_sky;

    //! Returns the weights of moments in a Taylor series of a response.
    Moments weigh(const Expansion& at, double times) const {
        return {times * at.value,
                times * at.slope * of_sun,
                times * at.slope * of_sky,
                times * at.curvature * of_sun * of_sun / 2,
                times * at.curvature * of_sun * of_sky,
                times * at.curvature * of_sky * of_sky / 2};
    }
};

//! The light on leaves in a step, and the response of leaves to it at the
//! temperature of the air.
struct StepLight {
    const PairLight& pair;
    Scales scales{};
    Responses shaded{};                     //!< responses by place
    Responses lit{};                        //!< responses by bin
    std::vector<double> beams{};            //!< beams on leaves, by bin
    std::vector<LeafResponse> responses{};  //!< responses by group of plants
    std::vector<double> of_places{};  //!< amount of gross assimilation by place
};

}  // namespace ideotype
