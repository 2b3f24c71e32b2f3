// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "ideotype/physiology/leaf.hpp"

namespace ideotype {

//! The terms of a function of diffuse light, expanded to second order about the
//! expected light: the deviations of a sun's and a sky's light, and their
//! products. Values are sums over pieces or hits, or the weights of these
//! terms.
struct Moments {
    double one = 0, sun = 0, sky = 0, sun2 = 0, sun_sky = 0, sky2 = 0;

    void add(const Moments& more, double times) {
        one += times * more.one;
        sun += times * more.sun;
        sky += times * more.sky;
        sun2 += times * more.sun2;
        sun_sky += times * more.sun_sky;
        sky2 += times * more.sky2;
    }

    double dot(const Moments& other) const {
        return one * other.one + sun * other.sun + sky * other.sky +
               sun2 * other.sun2 + sun_sky * other.sun_sky + sky2 * other.sky2;
    }
};

//! Moments of many places or bins, each term in an array.
struct MomentArrays {
    std::vector<double> one, sun, sky, sun2, sun_sky, sky2;

    std::size_t size() const { return one.size(); }

    //! Sets a number of moments to 0.
    void assign(std::size_t count) {
        for (auto* part : {&one, &sun, &sky, &sun2, &sun_sky, &sky2})
            part->assign(count, 0);
    }

    Moments at(std::size_t i) const {
        return {one[i], sun[i], sky[i], sun2[i], sun_sky[i], sky2[i]};
    }

    void push_back(const Moments& more) {
        one.push_back(more.one);
        sun.push_back(more.sun);
        sky.push_back(more.sky);
        sun2.push_back(more.sun2);
        sun_sky.push_back(more.sun_sky);
        sky2.push_back(more.sky2);
    }
};

//! The responses of leaves to light at several places, with derivatives.
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

//! Returns [f(D + b) - f(D)] / b, the gain of sunlit leaves, with its
//! derivatives in D. f is the response, D the diffuse light and b the beam.
inline Expansion gain(const Expansion& shaded, const Expansion& lit,
                      double beam) {
    // With weaker beams, the difference would be mostly rounding error. Both
    // cases are computed, so that compilers can vectorise loops.
    constexpr double least = 0.01;
    const bool is_weak = beam < least;
    const double value = (lit.value - shaded.value) / beam;
    const double slope = (lit.slope - shaded.slope) / beam;
    const double curvature = (lit.curvature - shaded.curvature) / beam;
    return {is_weak ? shaded.slope + beam / 2 * shaded.curvature : value,
            is_weak ? shaded.curvature : slope, is_weak ? 0 : curvature};
}

//! Diffuse light of the sun's and of the sky's source in a step, each divided
//! by the energy of the source.
struct Scales {
    double of_sun, of_sky;

    //! Returns the second-order term of the Taylor series of a response.
    double second(const Expansion& at, const Moments& of) const {
        const Moments w = weigh(at, 1);
        return w.sun2 * of.sun2 + w.sun_sky * of.sun_sky + w.sky2 * of.sky2;
    }

    //! Returns the weights of moments in the Taylor series of a response.
    Moments weigh(const Expansion& at, double times) const {
        return {times * at.value,
                times * at.slope * of_sun,
                times * at.slope * of_sky,
                times * at.curvature * of_sun * of_sun / 2,
                times * at.curvature * of_sun * of_sky,
                times * at.curvature * of_sky * of_sky / 2};
    }
};

// Loops over places or bins, compiled for wide vectors.

//! Computes the light of places from the expected light of a sun and a sky.
void add_light(const Scales& scales, const std::vector<double>& of_sun,
               const std::vector<double>& of_sky, std::vector<double>& light);

//! Computes the light of bins: that of the shaded place and of the beam.
//! @param per_beam light of the beam on each bin, divided by `beam`
void add_beams(double beam, const std::vector<double>& per_beam,
               const std::vector<std::uint32_t>& place, const Responses& shaded,
               std::vector<double>& beams, std::vector<double>& light);

//! Computes gain() of each bin.
void find_gains(const Responses& shaded, const Responses& lit,
                const std::vector<std::uint32_t>& place,
                const std::vector<double>& beams, Responses& gains);

//! Reduces curvatures so that the second-order term of each place or bin is at
//! most as large as its response to the expected light. The response is concave
//! and not negative, so the true term is between 0 and minus this response; few
//! paths give rare terms far outside.
void bound_curvatures(const Scales& scales, const MomentArrays& moments,
                      Responses& responses);

//! Computes the amounts of responses: the products of moments with
//! Scales::weigh().
//! @param all sums of weights, to which these are added
//! @param own null, or receives the weights
void weigh(const Scales& scales, const Responses& responses, double times,
           const MomentArrays& moments, MomentArrays& all, MomentArrays* own,
           std::vector<double>& amounts);

//! Adds weights, each multiplied by a factor.
void add_weights(const MomentArrays& more, const std::vector<double>& factors,
                 MomentArrays& all);

}  // namespace ideotype
