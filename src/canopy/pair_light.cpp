// SPDX-License-Identifier: Apache-2.0
#include "pair_light.hpp"

#include <algorithm>
#include <bit>
#include <numbers>
#include <numeric>

#include "ideotype/core/contract.hpp"
#include "ideotype/light/sunlit.hpp"

namespace ideotype {

// Derivation. In a step, the leaves of a place absorb the diffuse light D = a S
// + b K per leaf area. S and K are the light of the sun's and of the sky's
// source; a and b are `Scales`. With the expected light E = a s + b k (s and k
// are `expected`), the response of leaves is to second order
//
//     f(D) = f(E) + f' [a (S - s) + b (K - k)]
//          + f'' / 2 [a^2 (S - s)^2 + 2 a b (S - s)(K - k) + b^2 (K - k)^2],
//                                                                     (1)
//
// which Scales::weigh() writes as weights of the differences and products in
// `Moments`. In each of n randomisations, light is known as the sums x_r and
// y_r of the paths that hit a piece, per ground area. p = `per_index` is the
// ground area per leaf area, X = sum x_r, Y = sum y_r and P = sum x_r y_r.
// Since different randomisations are independent, the mean product over all
// pairs of them is unbiased:
//
//     <x y> = (X Y - P) / (n (n - 1)). (2)
//
// With x from the sun and y from the sky, the estimates of the terms in (1) are
//
//     S - s           : d = p X / n - s,                              (3)
//     (S - s)^2       : p^2 <x x> - 2 s p X / n + s^2
//                       = p^2 <x x> - s (2 d + s),                    (4)
//     (S - s) (K - k) : p^2 <x y> - s p Y / n - k p X / n + s k
//                       = p^2 <x y> - s (e + k) - k d,
//                         e = p Y / n - k.                            (5)
//
// For a beam of energy b_r on a triangle in randomisation r, the leaf gains
// [f(D + B) - f(D)] / B per unit of energy, see gain(); this is expanded in the
// same way. Its moments are means over hits, weighted by energy; with B = sum
// b_r,
//
//     S - s : p <b x> / (B / n) - s. (6)
//
// The scatter of a sum of such terms is computed from jackknife pseudo-values,
// n T - (n - 1) T_(r), where T_(r) omits randomisation r. For a mean, the part
// that differs between randomisations is x_r; for (2) it is
//
//     (X y_r + Y x_r - 2 x_r y_r) / (n - 2). (7)
//
// Weights of the light follow from (3) to (5). If w, w2 and w11 are the weights
// of S - s, (S - s)^2 and (S - s)(K - k), the weight of x_r is
//
//     p (w - 2 s w2 - k w11) (8)
//
// to first order, plus the weight from (7). A jackknife makes the variance of
// products of noise twice too large (Efron and Stein 1981,
// doi:10.1214/aos/1176345462). The second-order part of a pseudo-value is
// therefore multiplied by sqrt(1/2). (9)
//
// Most pieces have no light from a sun (X = 0). Multiplied by the area 1 / p
// and summed over the pieces of a place, d and e vanish, since s and k are
// means. Of (4) and (5) there remain
//
//     sum p <x x> - s^2 L,    sum p <x y> - s k L,                    (10)
//
// with the leaf area index L of the place, and sums over lit pieces only. The
// terms of (3) to (5) for a single piece are of three kinds: those without X
// and Y are the same for all leaves of a place, those in Y alone are the same
// for all suns but for their weights, so that SkyLight adds them once, and
// those in X are needed for lit pieces only.

namespace {

//! Returns an unbiased product of the means of x and y in n randomisations,
//! from the sums of x, y and x y: equation (2). With a single randomisation,
//! returns the product of the sums.
double product(double x, double y, double sum, double n) {
    return n > 1 ? (x * y - sum) / (n * (n - 1)) : x * y;
}

//! The factor of products in (9).
constexpr double of_products = std::numbers::sqrt2 / 2;

}  // namespace

SkyLight::SkyLight(const std::vector<Tally>& tallies, int number,
                   const LeafPlaces& places)
    : source(number),
      light(tallies, number, places.pieces()),
      expected(places.expected(light)),
      squares(places.pieces()),
      moments(places.count()),
      places_(places),
      n_(static_cast<double>(tallies.size())),
      by_piece_(tallies.size() * places.pieces()),
      by_place_(tallies.size() * places.count()) {
    for (std::size_t r = 0; r < tallies.size(); ++r)
        for (const auto& [v, energy] : light.parts[r]) {
            by_piece_[r * places.pieces() + v] = energy;
            by_place_[r * places.count() + places.of[v]] += energy;
            squares[v] += energy * energy;
        }
    // Equation (10) for the sky.
    for (std::size_t p = 0; p < places.count(); ++p)
        moments[p] = -expected[p] * expected[p] * places.index[p];
    for (const std::uint32_t v : light.lit)
        moments[places.of[v]] +=
            places.per_index[v] *
            product(light.sum[v], light.sum[v], squares[v], n_);
}

void SkyLight::add_amounts(const SkyWeights& weights,
                           std::vector<double>& of_parts) const {
    // The terms in Y of equations (3) to (5).
    for (const std::uint32_t v : light.lit) {
        const std::uint32_t p = places_.of[v];
        const double y = light.sum[v];
        of_parts[places_.part[v]] +=
            y / n_ *
                (weights.sky[p] - 2 * expected[p] * weights.sky2[p] -
                 weights.of_sun[p]) +
            places_.per_index[v] * product(y, y, squares[v], n_) *
                weights.sky2[p];
    }
}

void SkyLight::scatter(const SkyWeights& weights,
                       std::vector<std::vector<double>>& differences) const {
    std::vector<double> linear(places_.pieces()), square(places_.pieces());
    for (const std::uint32_t v : light.lit) {
        const std::uint32_t p = places_.of[v];
        // Equations (7) to (9).
        const double times = of_products * places_.per_index[v] / (n_ - 2);
        linear[v] = weights.light[v] + weights.sky[p] -
                    of_products * (2 * expected[p] * weights.sky2[p] +
                                   weights.of_sun[p]) +
                    2 * times * weights.sky2[p] * light.sum[v];
        square[v] = weights.square[v] - 2 * times * weights.sky2[p];
    }
    for (std::size_t r = 0; r < differences.size(); ++r)
        for (const auto& [v, x] : light.parts[r])
            differences[r][places_.part[v]] += x * (linear[v] + square[v] * x);
}

PairLight::PairLight(const std::vector<Tally>& tallies, const LitLeaves& lit,
                     const LeafPlaces& places, int beam, const SkyLight& sky)
    : tallies_(tallies),
      n_(static_cast<double>(tallies.size())),
      places_(places),
      beam_(beam),
      sky_(sky),
      sun_(tallies, beam, places.pieces()),
      expected_(places.expected(sun_)),
      squares_(places.pieces()),
      products_(places.pieces()) {
    compare();
    if (beam < 0) return;
    find_hits(lit, lit.par.light.light.sources[static_cast<std::size_t>(beam)]);
    sort_hits(lit.photons);
}

//! Compares the diffuse light of places with the expected diffuse light.
void PairLight::compare() {
    // Sums P of products in each randomisation, which are subtracted in (2).
    for (std::size_t r = 0; r < tallies_.size(); ++r)
        for (const auto& [v, energy] : sun_.parts[r]) {
            squares_[v] += energy * energy;
            products_[v] += energy * sky_.in(r, v);
        }
    // Equation (10).
    moments_.assign(places_.count());
    moments_.one = places_.index;
    moments_.sky2 = sky_.moments;
    for (std::size_t p = 0; p < places_.count(); ++p) {
        const double area = expected_[p] * places_.index[p];
        moments_.sun2[p] = -expected_[p] * area;
        moments_.sun_sky[p] = -sky_.expected[p] * area;
    }
    for (const std::uint32_t v : sun_.lit) {
        const double per = places_.per_index[v], x = sun_.sum[v];
        moments_.sun2[places_.of[v]] += per * product(x, x, squares_[v], n_);
        moments_.sun_sky[places_.of[v]] +=
            per * product(x, sky_.light.sum[v], products_[v], n_);
    }
}

//! Sums the energy of beams on each triangle, and the products of this energy
//! with the diffuse light of the triangle's piece, for (6).
void PairLight::find_hits(const LitLeaves& lit, const Source& source) {
    IDEOTYPE_EXPECT(source.direction.has_value());
    const Surfaces& all = lit.scene.surfaces();
    const glm::dvec3 direction = *source.direction;
    hit_.resize(all.normals.size());
    std::vector<double> sun(places_.pieces());
    for (std::size_t r = 0; r < tallies_.size(); ++r) {
        for (const auto& [v, energy] : sun_.parts[r]) sun[v] = energy;
        for (const auto& [t, energy] :
             tallies_[r].leaf_light[static_cast<std::size_t>(beam_)].beam) {
            if (hit_[t] == 0) {
                const std::uint32_t v = all.face_group[t / 2];
                const double relative =
                    beam_absorptance(lit.scene, lit.groups, lit.par.optics, t,
                                     direction) /
                    places_.absorptance[places_.of[v]];
                hits_.push_back(
                    {v, relative * beam_cosine(lit.scene, t, direction)});
                hit_[t] = static_cast<std::uint32_t>(hits_.size());
            }
            Hit& hit = hits_[hit_[t] - 1];
            hit.energy += energy;
            hit.with_sun += energy * sun[hit.piece];
            hit.with_sky += energy * sky_.in(r, hit.piece);
        }
        for (const auto& [v, energy] : sun_.parts[r]) sun[v] = 0;
    }
}

namespace {

//! Returns the bin of a cosine; bins are 1/16 of a power of two wide. Beams in
//! a bin are represented by their mean. Beams below the least cosine have
//! hardly any effect.
std::uint32_t step_of(double cosine) {
    constexpr int dropped_bits = 19;
    constexpr float least = 1 / 64.f;
    return std::bit_cast<std::uint32_t>(
               std::max(static_cast<float>(cosine), least)) >>
           dropped_bits;
}

}  // namespace

//! Collects the hits of each place in bins of similar cosines.
//! @param photons see LitLeaves
void PairLight::sort_hits(double photons) {
    // Sort hits by place (counting sort).
    std::vector<std::size_t> end(places_.count() + 1);
    for (const Hit& hit : hits_) ++end[places_.of[hit.piece] + 1];
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<Hit*> order(hits_.size());
    for (Hit& hit : hits_) order[end[places_.of[hit.piece]]++] = &hit;
    // Each place has few bins, so a linear search is sufficient.
    struct Bin {
        std::uint32_t step;
        double cosine = 0;
        Moments moments{};
    };
    std::vector<Bin> bins;  // bins of the current place
    std::size_t i = 0;
    for (std::uint32_t p = 0; p < places_.count(); ++p) {
        bins.clear();
        for (; i < end[p]; ++i) {
            Hit& hit = *order[i];
            auto found =
                std::ranges::find(bins, step_of(hit.cosine), &Bin::step);
            if (found == bins.end())
                found = bins.insert(found, {step_of(hit.cosine)});
            hit.bin = static_cast<std::uint32_t>(
                bins_.size() + static_cast<std::size_t>(found - bins.begin()));
            const double energy = hit.energy / n_;
            found->moments.add(moments_of(hit), energy);
            found->cosine += energy * hit.cosine;
        }
        for (const Bin& each : bins) {
            IDEOTYPE_ENSURE(each.moments.one > 0);
            bins_.place.push_back(p);
            bins_.cosine.push_back(each.cosine / each.moments.one);
            bins_.photons.push_back(places_.absorptance[p] * photons *
                                    bins_.cosine.back());
            bins_.moments.push_back(each.moments);
        }
    }
}

//! Returns the mean moments of a hit's light, per energy.
Moments PairLight::moments_of(const Hit& hit) const {
    const std::size_t v = hit.piece;
    const double per = places_.per_index[v], energy = hit.energy / n_;
    const double sun = expected_[places_.of[v]],
                 sky = sky_.expected[places_.of[v]];
    const double x = sun_.sum[v], y = sky_.light.sum[v];
    // Equations (3) to (5) of the piece.
    const double d = per * x / n_ - sun, e = per * y / n_ - sky;
    Moments moments{1};
    moments.sun2 =
        per * per * product(x, x, squares_[v], n_) - sun * (2 * d + sun);
    moments.sun_sky =
        per * per * product(x, y, products_[v], n_) - sun * (e + sky) - sky * d;
    moments.sky2 =
        per * per * product(y, y, sky_.squares[v], n_) - sky * (2 * e + sky);
    // Equation (6): the pieces hit by a beam may differ in diffuse light.
    moments.sun = per * product(hit.energy, x, hit.with_sun, n_) / energy - sun;
    moments.sky = per * product(hit.energy, y, hit.with_sky, n_) / energy - sky;
    return moments;
}

void PairLight::add_amounts(const Weights& weights,
                            std::vector<double>& of_places,
                            std::vector<double>& of_parts) const {
    // The terms of equations (3) to (5) without X and Y, then those in X.
    for (std::size_t p = 0; p < places_.count(); ++p) {
        const double s = expected_[p], k = sky_.expected[p];
        of_places[p] +=
            places_.index[p] *
            weights.places.at(p).dot({1, -s, -k, s * s, s * k, k * k});
    }
    for (const std::uint32_t v : sun_.lit) {
        const std::uint32_t p = places_.of[v];
        const Moments w = weights.places.at(p);
        const double per = places_.per_index[v], x = sun_.sum[v];
        of_parts[places_.part[v]] +=
            x / n_ *
                (w.sun - 2 * expected_[p] * w.sun2 -
                 sky_.expected[p] * w.sun_sky) +
            per * (product(x, x, squares_[v], n_) * w.sun2 +
                   product(x, sky_.light.sum[v], products_[v], n_) * w.sun_sky);
    }
    for (const Hit& hit : hits_)
        of_parts[places_.part[hit.piece]] +=
            hit.energy / n_ * weights.bins.at(hit.bin).dot(moments_of(hit));
}

void PairLight::add_sky(const Weights& weights, SkyWeights& of_sky) const {
    for (std::size_t p = 0; p < places_.count(); ++p) {
        of_sky.sky[p] += weights.places.sky[p];
        of_sky.sky2[p] += weights.places.sky2[p];
        of_sky.of_sun[p] += expected_[p] * weights.places.sun_sky[p];
    }
}

//! Returns the weights of the sun's light in a randomisation, and of products,
//! from the weights of differences in the mean of the moments. The light of
//! single hits is not included.
PairLight::SunWeights PairLight::weights_of_pieces(const Weights& weights,
                                                   SkyWeights& of_sky) const {
    SunWeights all(places_.pieces());
    // Parts of equations (7) and (8) due to ray hits.
    for (const Hit& hit : hits_) {
        const std::uint32_t v = hit.piece, p = places_.of[v];
        const double per = places_.per_index[v], x = sun_.sum[v],
                     y = sky_.light.sum[v], s = expected_[p],
                     k = sky_.expected[p];
        const double first = of_products * per * hit.energy / n_;
        const double second = first * per / (n_ - 2);
        const MomentArrays& bins = weights.bins;
        const double sun2 = bins.sun2[hit.bin], sky2 = bins.sky2[hit.bin],
                     sun_sky = bins.sun_sky[hit.bin];
        // The part B x_r / (n - 2) of (7); weight_of_beam() adds the other
        // parts.
        const double more = n_ / (n_ - 2);
        all.light[v] +=
            first * (more * bins.sun[hit.bin] - 2 * s * sun2 - k * sun_sky) +
            second * (2 * sun2 * x + sun_sky * y);
        all.square[v] += second * sun2;
        all.product[v] += second * sun_sky;
        of_sky.light[v] +=
            first * (more * bins.sky[hit.bin] - 2 * k * sky2 - s * sun_sky) +
            second * (2 * sky2 * y + sun_sky * x);
        of_sky.square[v] -= 2 * second * sky2;
    }
    for (const std::uint32_t v : sun_.lit) {
        const std::uint32_t p = places_.of[v];
        const Moments w = weights.places.at(p);
        const double x = sun_.sum[v];
        // The parts of (7) that are linear in the light of the randomisation
        // are added to the weights of light (8).
        const double second = of_products * places_.per_index[v] / (n_ - 2);
        all.light[v] +=
            w.sun -
            of_products *
                (2 * expected_[p] * w.sun2 + sky_.expected[p] * w.sun_sky) +
            second * (2 * w.sun2 * x + w.sun_sky * sky_.light.sum[v]);
        all.square[v] += second * w.sun2;
        all.product[v] += second * w.sun_sky;
        of_sky.light[v] += second * w.sun_sky * x;
    }
    return all;
}

std::vector<double> PairLight::scatter(
    const Weights& weights, SkyWeights& of_sky,
    std::vector<std::vector<double>>& differences) const {
    IDEOTYPE_EXPECT(tallies_.size() > 2);
    IDEOTYPE_EXPECT(weights.places.size() == places_.count() &&
                    weights.bins.size() == bins_.size() &&
                    differences.size() == tallies_.size());
    const SunWeights of_pieces = weights_of_pieces(weights, of_sky);
    std::vector<double> sums(tallies_.size()), sun(places_.pieces());
    for (std::size_t r = 0; r < tallies_.size(); ++r) {
        const auto add = [&](std::size_t v, double amount) {
            differences[r][places_.part[v]] += amount;
            sums[r] += amount;
        };
        // Diffuse light of the sun: linear parts, and -2 x_r y_r from (7).
        for (const auto& [v, x] : sun_.parts[r]) {
            sun[v] = x;
            add(v, x * (of_pieces.light[v] -
                        2 * (of_pieces.square[v] * x +
                             of_pieces.product[v] * sky_.in(r, v))));
        }
        // Beams: their energy, and (X b_r - 2 x_r b_r) from (7).
        if (beam_ >= 0)
            for (const auto& [t, energy] :
                 tallies_[r].leaf_light[static_cast<std::size_t>(beam_)].beam) {
                const Hit& hit = hits_[hit_[t] - 1];
                add(hit.piece,
                    energy * weight_of_beam(hit, weights, r, sun[hit.piece]));
            }
        for (const auto& [v, x] : sun_.parts[r]) sun[v] = 0;
        // Diffuse light of the sky to first order; its products are added once
        // for all suns that share the sky.
        for (std::size_t p = 0; p < places_.count(); ++p)
            sums[r] += weights.places.sky[p] * sky_.of_place(r, p);
    }
    return sums;
}

double PairLight::weight_of_beam(const Hit& hit, const Weights& weights,
                                 std::size_t r, double sun) const {
    const std::size_t v = hit.piece;
    const double per = places_.per_index[v] / (n_ - 2);
    const double sun_differs =
        per * (sun_.sum[v] - 2 * sun) - expected_[places_.of[v]];
    const double sky_differs = per * (sky_.light.sum[v] - 2 * sky_.in(r, v)) -
                               sky_.expected[places_.of[v]];
    return weights.bins.one[hit.bin] +
           of_products * (weights.bins.sun[hit.bin] * sun_differs +
                          weights.bins.sky[hit.bin] * sky_differs);
}

}  // namespace ideotype
