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

SkyLight::SkyLight(const std::vector<Tally>& tallies, int number,
                   const LeafPlaces& places, const ExpectedLight& expectation)
    : source(number),
      light(tallies, number, places.pieces()),
      expected(expectation.of(light)),
      by_piece(tallies.size() * places.pieces()),
      by_place(tallies.size() * places.count()),
      squares(places.pieces()) {
    for (std::size_t r = 0; r < tallies.size(); ++r)
        for (const auto& [v, energy] : light.parts[r]) {
            by_piece[r * places.pieces() + v] = energy;
            by_place[r * places.count() + places.of[v]] += energy;
            squares[v] += energy * energy;
        }
}

PairLight::PairLight(const std::vector<Tally>& tallies, const LitLeaves& lit,
                     const LeafPlaces& places, const ExpectedLight& expectation,
                     int beam, const SkyLight& sky)
    : tallies_(tallies),
      n_(static_cast<double>(tallies.size())),
      places_(places),
      beam_(beam),
      sky_(sky),
      sun_(tallies, beam, places.pieces()),
      expected_(expectation.of(sun_)),
      moments_(places.count()),
      differ_(places.pieces()) {
    compare();
    if (beam < 0) return;
    find_hits(lit, lit.par.light.light.sources[static_cast<std::size_t>(beam)]);
    sort_hits();
}

//! Compares the diffuse light of each piece with the expected diffuse light.
void PairLight::compare() {
    std::vector<double> squares(places_.pieces()), products(places_.pieces());
    // Sums P of products in each randomisation, which are subtracted in (2).
    for (std::size_t r = 0; r < tallies_.size(); ++r)
        for (const auto& [v, energy] : sun_.parts[r]) {
            squares[v] += energy * energy;
            products[v] += energy * sky_.in(r, v);
        }
    for (std::size_t p = 0; p < places_.count(); ++p)
        moments_[p].one = places_.index[p];
    for (std::size_t v = 0; v < places_.pieces(); ++v) {
        const double per = places_.per_index[v];
        if (!(per > 0)) continue;
        const double sun = expected_[places_.of[v]];
        const double sky = sky_.expected[places_.of[v]];
        const double from_sun = sun_.sum[v], from_sky = sky_.light.sum[v];
        Moments& d = differ_[v];
        // Equations (3) to (5), each for the sun and for the sky.
        d.sun = per * from_sun / n_ - sun;
        d.sky = per * from_sky / n_ - sky;
        d.sun2 = per * per * product(from_sun, from_sun, squares[v]) -
                 sun * (2 * d.sun + sun);
        d.sun_sky = per * per * product(from_sun, from_sky, products[v]) -
                    sun * (d.sky + sky) - sky * d.sun;
        d.sky2 = per * per * product(from_sky, from_sky, sky_.squares[v]) -
                 sky * (2 * d.sky + sky);
        moments_[places_.of[v]].add(d, 1 / per);
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
void PairLight::sort_hits() {
    // Sort hits by place (counting sort).
    std::vector<std::size_t> end(places_.count() + 1);
    for (const Hit& hit : hits_) ++end[places_.of[hit.piece] + 1];
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<Hit*> order(hits_.size());
    for (Hit& hit : hits_) order[end[places_.of[hit.piece]]++] = &hit;
    // Each place has few bins, so a linear search is sufficient.
    std::vector<std::uint32_t> steps;  // bin numbers of the current place
    std::size_t i = 0;
    for (std::uint32_t p = 0; p < places_.count(); ++p) {
        const std::size_t first = bins_.size();
        steps.clear();
        for (; i < end[p]; ++i) {
            const auto found = std::find(steps.begin(), steps.end(),
                                         step_of(order[i]->cosine));
            order[i]->bin = static_cast<std::uint32_t>(
                first + static_cast<std::size_t>(found - steps.begin()));
            if (found == steps.end()) {
                steps.push_back(step_of(order[i]->cosine));
                bins_.push_back({p});
            }
            add(*order[i], bins_[order[i]->bin]);
        }
    }
    for (Bin& bin : bins_) {
        IDEOTYPE_ENSURE(bin.moments.one > 0);
        bin.cosine /= bin.moments.one;
    }
}

void PairLight::add(const Hit& hit, Bin& bin) const {
    const std::size_t v = hit.piece;
    const double per = places_.per_index[v];
    const double energy = hit.energy / n_;
    Moments moments = differ_[v];
    moments.one = 1;
    // Equation (6): the pieces hit by a beam may differ in diffuse light.
    moments.sun =
        per * product(hit.energy, sun_.sum[v], hit.with_sun) / energy -
        expected_[bin.place];
    moments.sky =
        per * product(hit.energy, sky_.light.sum[v], hit.with_sky) / energy -
        sky_.expected[bin.place];
    bin.moments.add(moments, energy);
    bin.cosine += energy * hit.cosine;
}

//! The factor of products in (9).
constexpr double of_products = std::numbers::sqrt2 / 2;

//! Returns the weights of light in a randomisation, and of squares and
//! products, from the weights of differences in the mean of the moments. The
//! light of single hits is not included.
std::vector<Moments> PairLight::weights_of_pieces(const Weights& weights,
                                                  SkyWeights& of_sky) const {
    // For each piece: the weights of its moments, its place and its ray hits.
    std::vector<Moments> of_pieces(places_.pieces());
    for (std::size_t v = 0; v < places_.pieces(); ++v)
        if (places_.per_index[v] > 0)
            of_pieces[v].add(weights.places[places_.of[v]],
                             1 / places_.per_index[v]);
    for (const Hit& hit : hits_) {
        Moments of_bin = weights.bins[hit.bin];
        // The part B x_r / (n - 2) of (7); weight_of_beam() adds the other
        // parts.
        of_bin.sun *= n_ / (n_ - 2);
        of_bin.sky *= n_ / (n_ - 2);
        of_pieces[hit.piece].add(of_bin, hit.energy / n_);
    }
    for (std::size_t v = 0; v < places_.pieces(); ++v) {
        const double per = places_.per_index[v];
        const double sun = expected_[places_.of[v]];
        const double sky = sky_.expected[places_.of[v]];
        Moments& w = of_pieces[v];
        // Equation (8): the weights of light.
        w.sun = per * (w.sun - 2 * sun * w.sun2 - sky * w.sun_sky);
        w.sky = per * (w.sky - 2 * sky * w.sky2 - sun * w.sun_sky);
        // Equation (7): the parts that are linear in the light of the
        // randomisation are added to the weights of light.
        for (double* of_product : {&w.sun2, &w.sun_sky, &w.sky2})
            *of_product *= per * per / (n_ - 2);
        w.sun += 2 * w.sun2 * sun_.sum[v] + w.sun_sky * sky_.light.sum[v];
        w.sky += 2 * w.sky2 * sky_.light.sum[v] + w.sun_sky * sun_.sum[v];
        // Equation (9).
        const Moments& first_order = weights.places[places_.of[v]];
        w.sun = first_order.sun + of_products * (w.sun - first_order.sun);
        w.sky = first_order.sky + of_products * (w.sky - first_order.sky);
        for (double* of_product : {&w.sun2, &w.sun_sky, &w.sky2})
            *of_product *= of_products;
        of_sky.light[v] += w.sky;
        of_sky.square[v] -= 2 * w.sky2;
    }
    return of_pieces;
}

std::vector<double> PairLight::scatter(
    const Weights& weights, SkyWeights& of_sky,
    std::vector<std::vector<double>>& differences) const {
    IDEOTYPE_EXPECT(tallies_.size() > 2);
    IDEOTYPE_EXPECT(weights.places.size() == places_.count() &&
                    weights.bins.size() == bins_.size() &&
                    differences.size() == tallies_.size());
    const std::vector<Moments> of_pieces = weights_of_pieces(weights, of_sky);
    std::vector<double> sums(tallies_.size()), sun(places_.pieces());
    for (std::size_t r = 0; r < tallies_.size(); ++r) {
        const auto add = [&](std::size_t v, double amount) {
            differences[r][places_.of[v]] += amount;
            sums[r] += amount;
        };
        // Diffuse light of the sun: linear parts, and -2 x_r y_r from (7).
        for (const auto& [v, x] : sun_.parts[r]) {
            sun[v] = x;
            const Moments& w = of_pieces[v];
            add(v, x * (w.sun - 2 * (w.sun2 * x + w.sun_sky * sky_.in(r, v))));
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
            sums[r] +=
                weights.places[p].sky * sky_.by_place[r * places_.count() + p];
    }
    return sums;
}

double PairLight::weight_of_beam(const Hit& hit, const Weights& weights,
                                 std::size_t r, double sun) const {
    const std::size_t v = hit.piece;
    const Bin& bin = bins_[hit.bin];
    const Moments& of_bin = weights.bins[hit.bin];
    const double per = places_.per_index[v] / (n_ - 2);
    const double sun_differs =
        per * (sun_.sum[v] - 2 * sun) - expected_[bin.place];
    const double sky_differs = per * (sky_.light.sum[v] - 2 * sky_.in(r, v)) -
                               sky_.expected[bin.place];
    return of_bin.one +
           of_products * (of_bin.sun * sun_differs + of_bin.sky * sky_differs);
}

}  // namespace ideotype
