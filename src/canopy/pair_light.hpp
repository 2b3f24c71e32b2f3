// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/light/illumination.hpp"
#include "ideotype/light/ray_scene.hpp"
#include "leaf_places.hpp"
#include "moments.hpp"

namespace ideotype {

//! The weights of moments in a result, such as the assimilation of all leaves,
//! summed over the steps with the same sun and sky.
struct Weights {
    MomentArrays places;  //!< weights of PairLight::moments()
    MomentArrays bins;    //!< weights of PairLight::bins()
};

//! The weights of the light of a sky in a result, summed over the suns that
//! share the sky.
struct SkyWeights {
    explicit SkyWeights(const LeafPlaces& places)
        : sky(places.count()),
          sky2(places.count()),
          of_sun(places.count()),
          light(places.pieces()),
          square(places.pieces()) {}

    //! Sums by place: of the weights of K - k, of (K - k)^2, and of (S - s)(K -
    //! k) times the expected light of the sun.
    std::vector<double> sky, sky2, of_sun;
    //! Weights of the light and of its square in one randomisation, by piece,
    //! in addition to those that follow from the sums.
    std::vector<double> light, square;
};

//! The diffuse light of a sky.
class SkyLight {
  public:
    //! @param number index of the source; -1: none
    SkyLight(const std::vector<Tally>& tallies, int number,
             const LeafPlaces& places);

    //! Returns the light of a piece in a randomisation.
    double in(std::size_t r, std::size_t piece) const {
        return by_piece_[r * light.sum.size() + piece];
    }

    //! Returns the light of a place in a randomisation.
    double of_place(std::size_t r, std::size_t place) const {
        return by_place_[r * places_.count() + place];
    }

    //! Adds the weighted sum of those moments of each piece that are
    //! proportional to the light of the sky, or to its square.
    void add_amounts(const SkyWeights& weights,
                     std::vector<double>& of_parts) const;

    //! Adds the deviations of the weighted light, as PairLight::scatter().
    void scatter(const SkyWeights& weights,
                 std::vector<std::vector<double>>& differences) const;

    int source;  //!< index of the source; -1: none
    DiffuseLight light;
    std::vector<double> expected;  //!< light by place, per leaf area [J m-2]
    std::vector<double> squares;   //!< sums over randomisations, by piece
    std::vector<double> moments;   //!< Moments::sky2 by place

  private:
    const LeafPlaces& places_;
    double n_;
    std::vector<double> by_piece_;  //!< light [randomisation][piece]
    std::vector<double> by_place_;  //!< light [randomisation][place]
};

//! The light of a sun and a sky that several time steps share, over all
//! randomisations. The sums of each step are computed from this light. Noise
//! does not bias products: each is averaged over pairs of different
//! randomisations (a U-statistic, Hoeffding 1948, doi:10.1214/aoms/1177730196).
class PairLight {
  public:
    //! Bins of beam hits. A bin contains the hits at one place with about the
    //! same cosine. The beam irradiance of level ground times this cosine is
    //! the irradiance at which the leaf's more absorbing face would absorb as
    //! much as the leaf does.
    struct Bins {
        std::vector<std::uint32_t> place;
        std::vector<double> cosine;
        //! Absorbed photons per beam irradiance [umol J-1].
        std::vector<double> photons;
        MomentArrays moments;

        std::size_t size() const { return place.size(); }
    };

    //! @param beam index of the beam's source; -1: none
    PairLight(const std::vector<Tally>& tallies, const LitLeaves& lit,
              const LeafPlaces& places, int beam, const SkyLight& sky);

    const std::vector<double>& expected() const { return expected_; }
    const MomentArrays& moments() const { return moments_; }

    //! Returns the bins, ordered by place.
    const Bins& bins() const { return bins_; }

    //! Adds the weighted sums of moments, but for the parts that
    //! SkyLight::add_amounts() adds: of pieces, and what the leaves of a place
    //! have in proportion to their area.
    void add_amounts(const Weights& weights, std::vector<double>& of_places,
                     std::vector<double>& of_parts) const;

    //! Adds the weights of the sky's light by place.
    void add_sky(const Weights& weights, SkyWeights& of_sky) const;

    //! Adds the deviations of the weighted sum of all moments to
    //! [randomisation][part], as jackknife pseudo-values (Quenouille 1956,
    //! doi:10.1093/biomet/43.3-4.353; Tukey 1958, doi:10.1214/aoms/1177706647).
    //! Deviations of products are scaled so that their scatter is correct.
    //! Deviations common to all randomisations are omitted. The light of the
    //! sky is also omitted; its weights by piece are added to `of_sky`.
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

    void compare();
    void find_hits(const LitLeaves& lit, const Source& source);
    void sort_hits(double photons);
    Moments moments_of(const Hit& hit) const;

    //! The weights of the sun's light in a randomisation, of its square and of
    //! its product with the sky's light, by piece.
    struct SunWeights {
        explicit SunWeights(std::size_t pieces)
            : light(pieces), square(pieces), product(pieces) {}

        std::vector<double> light, square, product;
    };
    SunWeights weights_of_pieces(const Weights& weights,
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
    MomentArrays moments_;
    //! Sums of squares and of products with the sky, by piece.
    std::vector<double> squares_, products_;
    std::vector<std::uint32_t> hit_;  //!< hit number of each triangle, from 1
    std::vector<Hit> hits_;
    Bins bins_;
};

//! The light on leaves in a step, and the response of leaves to this light at
//! air temperature.
struct StepLight {
    const PairLight& pair;
    Scales scales{};
    Responses shaded{};                     //!< responses by place
    Responses lit{}, gains{};               //!< responses by bin
    std::vector<double> beams{};            //!< beams on leaves, by bin
    std::vector<LeafResponse> responses{};  //!< responses by group of plants
    std::vector<double> of_places{};        //!< gross assimilation by place
};

}  // namespace ideotype
