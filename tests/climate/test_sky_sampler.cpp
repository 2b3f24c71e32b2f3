// SPDX-License-Identifier: Apache-2.0
// Skies are sampled in proportion to radiance times cos z. This is tested at
// single points, in the statistics of random directions and in their means.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ideotype/climate/sky_sampler.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/random.hpp"
#include "ideotype/core/units.hpp"

namespace ideotype {

namespace {

using std::numbers::pi;

SkyRadiance make_clear_sky(double zenith, double azimuth = 200) {
    return {SkyModel::clear, {zenith, azimuth}};
}

std::vector<SkyRadiance> skies() {
    return {{SkyModel::uniform, {}}, {SkyModel::overcast, {}},
            make_clear_sky(0),       make_clear_sky(1),
            make_clear_sky(26.2),    make_clear_sky(60),
            make_clear_sky(86.4),    make_clear_sky(90)};
}

std::string describe(const SkyRadiance& sky) {
    if (sky.model == SkyModel::uniform) return "uniform";
    if (sky.model == SkyModel::overcast) return "overcast";
    return "clear, sun at " + std::to_string(sky.sun.zenith);
}

constexpr std::size_t rings = 20, sectors = 40;

//! Finds the bin of a direction; bins are of equal size in zenith angle and
//! azimuth.
std::size_t find_bin(const glm::dvec3& travel) {
    const double turn = (std::atan2(travel.y, travel.x) + pi) / (2 * pi);
    const auto index = [](double x, std::size_t count) {
        return std::min(
            static_cast<std::size_t>(x * static_cast<double>(count)),
            count - 1);
    };
    const double zenith = std::acos(-travel.z);
    return index(zenith / (pi / 2), rings) * sectors + index(turn, sectors);
}

//! Integrals over a sky, weighted by cos z and computed by the midpoint rule.
struct SkyIntegrals {
    std::vector<double> bins = std::vector<double>(rings * sectors);
    double irradiance = 0;
    double cosine = 0;     //!< mean of cos z
    glm::dvec3 travel{0};  //!< mean direction
};

SkyIntegrals integrate(const SkyRadiance& sky, std::size_t fineness) {
    SkyIntegrals sum;
    const std::size_t m = rings * fineness, n = sectors * fineness;
    const double dz = pi / 2 / static_cast<double>(m);
    const double da = 2 * pi / static_cast<double>(n);
    for (std::size_t i = 0; i < m; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            const double zenith = (static_cast<double>(i) + .5) * dz;
            const double azimuth = (static_cast<double>(j) + .5) * da - pi;
            const double z = std::cos(zenith), s = std::sin(zenith);
            const glm::dvec3 d{s * std::cos(azimuth), s * std::sin(azimuth),
                               -z};
            const double part = relative_radiance(sky, d) * z * s * dz * da;
            sum.bins[find_bin(d)] += part;
            sum.irradiance += part;
            sum.cosine += part * z;
            sum.travel += part * d;
        }
    sum.cosine /= sum.irradiance;
    sum.travel /= sum.irradiance;
    return sum;
}

//! Returns the probability that a chi-square variable with k degrees of freedom
//! is at least this large (Wilson and Hilferty 1931,
//! doi:10.1073/pnas.17.12.684).
double p_value(double chi_square, double k) {
    const double spread = 2 / (9 * k);
    const double z =
        (std::cbrt(chi_square / k) - (1 - spread)) / std::sqrt(spread);
    return std::erfc(z / std::sqrt(2)) / 2;
}

//! Returns the p-value of random directions sampled from one sky under the
//! hypothesis that they were sampled from another.
double compare(const SkyRadiance& sampled, const SkyRadiance& hypothesis,
               std::uint32_t slot) {
    constexpr int count = 400000;
    const SkySampler sampler(sampled);
    RandomStream random(2025, Purpose::scramble, 0, slot);
    std::vector<double> counts(rings * sectors);
    for (int i = 0; i < count; ++i) {
        const double u = random.uniform();
        counts[find_bin(sampler.sample(u, random.uniform()))] += 1;
    }
    const SkyIntegrals sky = integrate(hypothesis, 10);
    double chi_square = 0;
    for (std::size_t b = 0; b < counts.size(); ++b) {
        const double expected = count * sky.bins[b] / sky.irradiance;
        EXPECT_GT(expected, 5) << "too few directions in a bin";
        chi_square +=
            (counts[b] - expected) * (counts[b] - expected) / expected;
    }
    return p_value(chi_square, static_cast<double>(counts.size() - 1));
}

}  // namespace

TEST(RelativeRadiance, RadianceFollowsTheStandards) {
    const glm::dvec3 zenith{0, 0, -1}, horizon{1, 0, 0};
    const glm::dvec3 half{std::sqrt(.75), 0, -.5};
    EXPECT_EQ(relative_radiance({SkyModel::uniform, {}}, half), 1);
    EXPECT_DOUBLE_EQ(relative_radiance({SkyModel::overcast, {}}, zenith), 1);
    EXPECT_DOUBLE_EQ(relative_radiance({SkyModel::overcast, {}}, horizon),
                     1. / 3);
    // Light comes from the west, 60 deg from the zenith. First the sun is at
    // this point, then in the zenith.
    EXPECT_NEAR(relative_radiance(make_clear_sky(60, 270), half),
                11.36 * (1 - std::exp(-.64)), 1e-6);
    EXPECT_NEAR(relative_radiance(make_clear_sky(0), half),
                (.91 + 10 * std::exp(-pi) + .45 / 4) * (1 - std::exp(-.64)),
                1e-12);
    for (const SkyRadiance& sky : skies())
        EXPECT_EQ(relative_radiance(sky, {0, 0, 1}), 0);
}

TEST(SkySampler, HorizontalIrradianceAgreesWithIntegration) {
    EXPECT_DOUBLE_EQ(SkySampler(skies()[0]).horizontal_irradiance(), pi);
    EXPECT_DOUBLE_EQ(SkySampler(skies()[1]).horizontal_irradiance(),
                     7 * pi / 9);
    for (const SkyRadiance& sky : skies()) {
        const double integral = integrate(sky, 20).irradiance;
        EXPECT_NEAR(SkySampler(sky).horizontal_irradiance() / integral, 1, 2e-5)
            << describe(sky);
    }
    // Expected: a finer discretisation of the same scheme.
    EXPECT_NEAR(SkySampler(make_clear_sky(50)).horizontal_irradiance(),
                2.702100010077, 1e-10);
}

TEST(SkySampler, DensityIsRadianceTimesCosineEverywhere) {
    // In horizontal projection, the Jacobian of the map from the unit square is
    // the inverse of the sampling density; the factor cos z cancels.
    for (const SkyRadiance& sky : skies()) {
        const bool is_clear = sky.model == SkyModel::clear;
        const SkySampler sampler(sky);
        constexpr int n = 100;
        constexpr double h = 1e-6;
        double mean_error = 0;
        for (int i = 0; i < n * n; ++i) {
            const double u = (i / n + .5) / n, v = (i % n + .5) / n;
            const glm::dvec3 east = sampler.sample(u + h, v);
            const glm::dvec3 west = sampler.sample(u - h, v);
            const glm::dvec3 north = sampler.sample(u, v + h);
            const glm::dvec3 south = sampler.sample(u, v - h);
            const double area =
                std::abs((east.x - west.x) * (north.y - south.y) -
                         (east.y - west.y) * (north.x - south.x)) /
                (4 * h * h);
            const double radiance =
                relative_radiance(sky, sampler.sample(u, v));
            const double error =
                std::abs(area * radiance / sampler.horizontal_irradiance() - 1);
            EXPECT_LT(error, is_clear ? 1e-4 : 1e-7)
                << describe(sky) << " at " << u << ", " << v;
            mean_error += error / (n * n);
        }
        EXPECT_LT(mean_error, is_clear ? 1e-6 : 1e-8) << describe(sky);
    }
}

TEST(SkySampler, RandomDirectionsPassTheChiSquareTest) {
    const std::vector<SkyRadiance> sampled = skies();
    for (std::uint32_t i = 0; i < sampled.size(); ++i)
        EXPECT_GT(compare(sampled[i], sampled[i], i),
                  0.01 / static_cast<double>(sampled.size()))
            << describe(sampled[i]);
}

TEST(SkySampler, ChiSquareTestDistinguishesSkies) {
    const std::vector<SkyRadiance> sampled = skies();
    EXPECT_LT(compare(sampled[0], sampled[1], 0), 1e-6);
    EXPECT_LT(compare(sampled[1], sampled[0], 0), 1e-6);
    EXPECT_LT(compare(make_clear_sky(60, 200), make_clear_sky(60, 202), 0),
              1e-6);
    EXPECT_LT(compare(make_clear_sky(60), make_clear_sky(62), 0), 1e-6);
}

TEST(SkySampler, EvenPointsReproduceTheMeanOfTheSky) {
    constexpr int m = 1024, n = 128, points = m * n;
    for (const SkyRadiance& sky : skies()) {
        const SkySampler sampler(sky);
        const SkyIntegrals expected = integrate(sky, 20);
        glm::dvec3 mean(0);
        for (int i = 0; i < points; ++i) {
            const glm::dvec3 d =
                sampler.sample((i / n + .5) / m, (i % n + .5) / n);
            EXPECT_NEAR(std::hypot(d.x, d.y, d.z), 1, 1e-14);
            mean += d / (1. * points);
        }
        EXPECT_NEAR(mean.x, expected.travel.x, 1e-4) << describe(sky);
        EXPECT_NEAR(mean.y, expected.travel.y, 1e-4) << describe(sky);
        EXPECT_NEAR(-mean.z, expected.cosine, 1e-4) << describe(sky);
    }
    EXPECT_NEAR(integrate({SkyModel::uniform, {}}, 20).cosine, 2. / 3, 1e-5);
    EXPECT_NEAR(integrate({SkyModel::overcast, {}}, 20).cosine, 5. / 7, 1e-5);
}

TEST(SkySampler, LightNeverTravelsUpwards) {
    std::vector<SkyRadiance> sampled = skies();
    for (const double zenith : {1e-9, 45., 89.999999, 90 - 1e-13})
        sampled.push_back(make_clear_sky(zenith));
    const double last = 1 - 0x1p-53;
    for (const SkyRadiance& sky : sampled) {
        const SkySampler sampler(sky);
        for (const double u : {0., 0x1p-53, 0x1p-32, .3, .5, 1 - 0x1p-32, last})
            for (const double v : {0., 0x1p-32, .25, .5, .75, last}) {
                const glm::dvec3 d = sampler.sample(u, v);
                EXPECT_NEAR(std::hypot(d.x, d.y, d.z), 1, 1e-7)
                    << describe(sky) << " at " << u << ", " << v;
                EXPECT_LE(d.z, 0) << describe(sky) << " at " << u << ", " << v;
            }
    }
}

TEST(SkySampler, ClearSkyWithoutSunIsRefused) {
    EXPECT_THROW(SkySampler(make_clear_sky(90.01)), Error);
    EXPECT_THROW(SkySampler(make_clear_sky(-1)), Error);
    EXPECT_THROW(SkySampler(make_clear_sky(std::nan(""))), Error);
}

}  // namespace ideotype
