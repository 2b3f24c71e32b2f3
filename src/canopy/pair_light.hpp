// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/light/illumination.hpp"
#include "ideotype/light/ray_scene.hpp"
#include "leaf_places.hpp"

namespace ideotype {

//! The terms of a function of diffuse light, expanded to second order about the
//! expected light: differences of the light of a sun and a sky, and their
//! products, summed over pieces or hits; or the weights of these terms.
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

//! The diffuse light of a sky.
struct SkyLight {
    SkyLight(const std::vector<Tally>& tallies, int source,
             const LeafPlaces& places, const ExpectedLight& expectation);

    double in(std::size_t r, std::size_t piece) const {
        return by_piece[r * light.sum.size() + piece];
    }

    int source;  //!< number of the source; -1: none
    DiffuseLight light;
    std::vector<double> expected;  //!< light by place, per area of leaf [J m-2]
    std::vector<double> by_piece;  //!< light [randomisation][piece]
    std::vector<double> by_place;  //!< light [randomisation][place]
    std::vector<double> squares;   //!< sums over randomisations, by piece
};

//! The weights of moments in a result, such as the assimilation of all leaves,
//! summed over the steps that share a sun and a sky.
struct Weights {
    std::vector<Moments> places;  //!< weights of PairLight::moments()
    std::vector<Moments> bins;    //!< weights of PairLight::bins()
};

//! The weights in a result of the light of a sky in a randomisation, and of the
//! square of that light, by piece; summed over the suns that share the sky.
struct SkyWeights {
    explicit SkyWeights(std::size_t pieces) : light(pieces), square(pieces) {}

    std::vector<double> light, square;
};

//! The light of a sun and a sky that several time steps share, over all
//! randomisations. The sums of each step are computed from it. Noise does not
//! bias products: each is averaged over pairs of different randomisations (a
//! U-statistic, Hoeffding 1948, doi:10.1214/aoms/1177730196).
class PairLight {
  public:
    //! Hits of beams at one place that have about the same cosine: the beam on
    //! the leaf over the beam on level ground that the leaf's more absorbing
    //! face would need to absorb as much.
    struct Bin {
        std::uint32_t place = 0;
        double cosine = 0;
        Moments moments{};
    };

    //! @param beam number of the beam's source; -1: none
    PairLight(const std::vector<Tally>& tallies, const LitLeaves& lit,
              const LeafPlaces& places, const ExpectedLight& expectation,
              int beam, const SkyLight& sky);

    const std::vector<double>& expected() const { return expected_; }
    const std::vector<Moments>& moments() const { return moments_; }

    //! Returns the bins in the order of places.
    const std::vector<Bin>& bins() const { return bins_; }

    //! Adds the differences of the weighted sum of all moments, as
    //! pseudo-values of a jackknife (Quenouille 1956,
    //! doi:10.1093/biomet/43.3-4.353; Tukey 1958, doi:10.1214/aoms/1177706647),
    //! to [randomisation][place]. Differences of products are scaled so that
    //! their scatter is right. Differences that all randomisations share are
    //! left out, as is the light of the sky: its weights are added to `of_sky`.
    //! @return sums by randomisation, with the light of the sky to first order
    std::vector<double> scatter(
        const Weights& weights, SkyWeights& of_sky,
        std::vector<std::vector<double>>& differences) const;

  private:
    struct Hit {
        std::uint32_t piece;
        double cosine;
        double energy = 0, with_sun = 0, with_sky = 0;  //!< sums of products
        std::uint32_t bin = 0;
    };

    //! Returns the product of the means of x and y without bias, from the sums
    //! of x, y and x y; from one randomisation, the product of the sums.
    double product(double x, double y, double sum) const {
        return n_ > 1 ? (x * y - sum) / (n_ * (n_ - 1)) : x * y;
    }
    void compare();
    void find_hits(const LitLeaves& lit, const Source& source);
    void sort_hits();
    void add(const Hit& hit, Bin& bin) const;
    std::vector<Moments> weights_of_pieces(const Weights& weights,
                                           SkyWeights& of_sky) const;

    //! Returns the weight of a beam's energy in a randomisation.
    //! @param sun diffuse light of the sun on the piece in this randomisation
    double weight_of_beam(const Hit& hit, const Weights& weights, std::size_t r,
                          double sun) const;

    const std::vector<Tally>& tallies_;
    double n_;
    const LeafPlaces& places_;
    int beam_;
    const SkyLight& sky_;
    DiffuseLight sun_;
    std::vector<double> expected_;  //!< expected light of the sun
    std::vector<Moments> moments_;  //!< moments by place, times leaf area index
    std::vector<Moments> differ_;   //!< differences by piece
    std::vector<std::uint32_t> hit_;  //!< number of hit by triangle, from 1
    std::vector<Hit> hits_;
    std::vector<Bin> bins_;
};

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
