// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "ideotype/core/random.hpp"
#include "moments.hpp"

namespace ideotype {
namespace {

constexpr std::size_t place_count = 37, bin_count = 101;

//! Places and bins with random light, responses and moments.
struct Step {
    Scales scales{.3, .7};
    Responses shaded, lit, gains;
    std::vector<std::uint32_t> place;
    std::vector<double> of_sun, of_sky, photons, beams;
    MomentArrays moments, weights;
    double beam = 500;

    Step() {
        RandomStream stream(1, Purpose::stream, 0, 0);
        const auto some = [&](std::size_t count, double most) {
            std::vector<double> all(count);
            for (double& x : all) x = stream.uniform(0, most);
            return all;
        };
        shaded.resize(place_count);
        of_sun = some(place_count, 800);
        of_sky = some(place_count, 300);
        shaded.value = some(place_count, 40);
        shaded.slope = some(place_count, .06);
        shaded.curvature = some(place_count, 1e-4);
        lit.resize(bin_count);
        lit.value = some(bin_count, 40);
        lit.slope = some(bin_count, .06);
        lit.curvature = some(bin_count, 1e-4);
        gains.resize(bin_count);
        photons = some(bin_count, 2);
        photons[5] = 0;
        photons[6] = 1e-6;
        beams.resize(bin_count);
        for (std::size_t b = 0; b < bin_count; ++b)
            place.push_back(
                static_cast<std::uint32_t>(b * place_count / bin_count));
        for (std::size_t b = 0; b < bin_count; ++b) {
            const std::vector<double> x = some(6, 3);
            moments.push_back({x[0], x[1], x[2], x[3], x[4], x[5]});
        }
        weights.assign(bin_count);
    }
};

void expect_equal(const Moments& a, const Moments& b) {
    EXPECT_EQ(a.one, b.one);
    EXPECT_EQ(a.sun, b.sun);
    EXPECT_EQ(a.sky, b.sky);
    EXPECT_EQ(a.sun2, b.sun2);
    EXPECT_EQ(a.sun_sky, b.sun_sky);
    EXPECT_EQ(a.sky2, b.sky2);
}

TEST(Moments, LightOfPlacesAndBinsIsThatOfEachAlone) {
    Step step;
    add_light(step.scales, step.of_sun, step.of_sky, step.shaded.light);
    add_beams(step.beam, step.photons, step.place, step.shaded, step.beams,
              step.lit.light);
    for (std::size_t p = 0; p < place_count; ++p)
        EXPECT_EQ(step.shaded.light[p],
                  step.scales.of_sun * step.of_sun[p] +
                      step.scales.of_sky * step.of_sky[p]);
    for (std::size_t b = 0; b < bin_count; ++b) {
        EXPECT_EQ(step.beams[b], step.beam * step.photons[b]);
        EXPECT_EQ(step.lit.light[b],
                  step.shaded.light[step.place[b]] + step.beams[b]);
    }
}

TEST(Moments, GainsOfBinsAreThatOfEachAlone) {
    Step step;
    add_beams(step.beam, step.photons, step.place, step.shaded, step.beams,
              step.lit.light);
    find_gains(step.shaded, step.lit, step.place, step.beams, step.gains);
    for (std::size_t b = 0; b < bin_count; ++b) {
        const Expansion alone =
            gain(step.shaded.at(step.place[b]), step.lit.at(b), step.beams[b]);
        EXPECT_EQ(step.gains.value[b], alone.value);
        EXPECT_EQ(step.gains.slope[b], alone.slope);
        EXPECT_EQ(step.gains.curvature[b], alone.curvature);
    }
    // Without light of the beam the gain is the slope in the shade.
    EXPECT_EQ(step.gains.value[5], step.shaded.slope[step.place[5]]);
}

TEST(Moments, SecondOrderTermsAreAtMostAsLargeAsResponses) {
    Step step;
    step.gains = step.lit;
    step.gains.curvature[3] = 0;
    step.gains.value[4] = 0;
    for (std::size_t b = 7; b < 20; ++b)
        step.moments.sun2[b] = b % 2 ? 5e6 : -5e6;
    bound_curvatures(step.scales, step.moments, step.gains);
    int bounded = 0;
    for (std::size_t b = 0; b < bin_count; ++b) {
        const Moments of = step.moments.at(b);
        const double before = step.scales.second(step.lit.at(b), of),
                     after = step.scales.second(step.gains.at(b), of),
                     most = step.gains.value[b] * of.one;
        if (b == 3 || std::abs(before) <= most) {
            EXPECT_EQ(after, b == 3 ? 0 : before) << b;
        } else {
            ++bounded;
            EXPECT_NEAR(after, std::copysign(most, before), 1e-12 * most) << b;
        }
    }
    EXPECT_GT(bounded, 1);
    EXPECT_LT(bounded, bin_count / 2);
}

TEST(Moments, WeightsAndAmountsAreThatOfEachAlone) {
    Step step;
    step.gains = step.lit;
    MomentArrays own;
    own.assign(bin_count);
    std::vector<double> amounts, again;
    weigh(step.scales, step.gains, 2.5, step.moments, step.weights, &own,
          amounts);
    for (std::size_t b = 0; b < bin_count; ++b) {
        const Moments alone = step.scales.weigh(step.gains.at(b), 2.5);
        EXPECT_EQ(amounts[b], alone.dot(step.moments.at(b)));
        expect_equal(own.at(b), alone);
        expect_equal(step.weights.at(b), alone);
    }
    // A second step adds its weights; its own are not asked for.
    weigh(step.scales, step.gains, 2.5, step.moments, step.weights, nullptr,
          again);
    EXPECT_EQ(again, amounts);
    for (std::size_t b = 0; b < bin_count; ++b) {
        Moments twice = own.at(b);
        twice.add(own.at(b), 1);
        expect_equal(step.weights.at(b), twice);
    }
}

TEST(Moments, WeightsAreAddedWithAFactorEach) {
    Step step;
    std::vector<double> factors(bin_count);
    for (std::size_t b = 0; b < bin_count; ++b)
        factors[b] = static_cast<double>(b) / 7;
    add_weights(step.moments, factors, step.weights);
    for (std::size_t b = 0; b < bin_count; ++b) {
        Moments alone;
        alone.add(step.moments.at(b), factors[b]);
        expect_equal(step.weights.at(b), alone);
    }
}

}  // namespace
}  // namespace ideotype
