// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/light/illumination.hpp"
#include "ideotype/light/ray_scene.hpp"
#include "leaf_places.hpp"

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

//! The diffuse light of a sky.
struct SkyLight {
    SkyLight(const std::vector<Tally>& tallies, int source,
             const LeafPlaces& places, const ExpectedLight& expectation);

    double in(std::size_t r, std::size_t piece) const {
        return by_piece[r * light.sum.size() + piece];
    }

    int source;  //!< index of the source; -1: none
    DiffuseLight light;
    std::vector<double> expected;  //!< light by place, per leaf area [J m-2]
    std::vector<double> by_piece;  //!< light [randomisation][piece]
    std::vector<double> by_place;  //!< light [randomisation][place]
    std::vector<double> squares;   //!< sums over randomisations, by piece
};

//! The weights of moments in a result, such as the assimilation of all leaves,
//! summed over the steps with the same sun and sky.
struct Weights {
    std::vector<Moments> places;  //!< weights of PairLight::moments()
    std::vector<Moments> bins;    //!< weights of PairLight::bins()
};

//! The weights of a sky's light and of its square in a result, by piece, for
//! one randomisation. They are summed over the suns that share the sky.
struct SkyWeights {
    explicit SkyWeights(std::size_t pieces) : light(pieces), square(pieces) {}

    std::vector<double> light, square;
};

//! The light of a sun and a sky that several time steps share, over all
//! randomisations. The sums of each step are computed from this light. Noise
//! does not bias products: each is averaged over pairs of different
//! randomisations (a U-statistic, Hoeffding 1948, doi:10.1214/aoms/1177730196).
class PairLight {
  public:
    //! Beam hits at one place with about the same cosine. The beam irradiance
    //! of level ground times this cosine is the irradiance at which the leaf's
    //! more absorbing face would absorb as much as the leaf does.
    struct Bin {
        std::uint32_t place = 0;
        double cosine = 0;
        Moments moments{};
    };

    //! @param beam index of the beam's source; -1: none
    PairLight(const std::vector<Tally>& tallies, const LitLeaves& lit,
              const LeafPlaces& places, const ExpectedLight& expectation,
              int beam, const SkyLight& sky);

    const std::vector<double>& expected() const { return expected_; }
    const std::vector<Moments>& moments() const { return moments_; }

    //! Returns the bins, ordered by place.
    const std::vector<Bin>& bins() const { return bins_; }

    //! Adds the deviations of the weighted sum of all moments to
    //! [randomisation][place], as jackknife pseudo-values (Quenouille 1956,
    //! doi:10.1093/biomet/43.3-4.353; Tukey 1958, doi:10.1214/aoms/1177706647).
    //! Deviations of products are scaled so that their scatter is correct.
    //! Deviations common to all randomisations are omitted. The light of the
    //! sky is also omitted; its weights are added to `of_sky`.
    //! @return sums by randomisation, including the light of the sky to first
    //! order
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

    //! Returns an unbiased product of the means of x and y, from the sums of x,
    //! y and x y. With a single randomisation, returns the product of the sums.
    double product(double x, double y, double sum) const {
        return n_ > 1 ? (x * y - sum) / (n_ * (n_ - 1)) : x * y;
    }
    void compare();
    void find_hits(const LitLeaves& lit, const Source& source);
    void sort_hits();
    void add(const Hit& hit, Bin& bin) const;
    std::vector<Moments> weights_of_pieces(const Weights& weights,
                                           SkyWeights& of_sky) const;

    //! Returns the weight of beam energy in a randomisation.
    //! @param sun diffuse light from the sun on the piece in this randomisation
    double weight_of_beam(const Hit& hit, const Weights& weights, std::size_t r,
                          double sun) const;

    const std::vector<Tally>& tallies_;
    double n_;
    const LeafPlaces& places_;
    int beam_;
    const SkyLight& sky_;
    DiffuseLight sun_;
    std::vector<double> expected_;  //!< expected light of the sun
    //! Moments by place, multiplied by leaf area index.
    std::vector<Moments> moments_;
    std::vector<Moments> differ_;     //!< deviations by piece
    std::vector<std::uint32_t> hit_;  //!< hit number of each triangle, from 1
    std::vector<Hit> hits_;
    std::vector<Bin> bins_;
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
    // With weaker beams, the difference would be mostly rounding error.
    constexpr double least = 0.01;
    if (beam < least)
        return {shaded.slope + beam / 2 * shaded.curvature, shaded.curvature,
                0};
    return {(lit.value - shaded.value) / beam,
            (lit.slope - shaded.slope) / beam,
            (lit.curvature - shaded.curvature) / beam};
}

//! Diffuse light of the sun's and of the sky's source in a step, each divided
//! by the energy of the source.
struct Scales {
    double of_sun, of_sky;

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

//! The light on leaves in a step, and the response of leaves to this light at
//! air temperature.
struct StepLight {
    const PairLight& pair;
    Scales scales{};
    Responses shaded{};                     //!< responses by place
    Responses lit{};                        //!< responses by bin
    std::vector<double> beams{};            //!< beams on leaves, by bin
    std::vector<LeafResponse> responses{};  //!< responses by group of plants
    std::vector<double> of_places{};        //!< gross assimilation by place
};

}  // namespace ideotype
