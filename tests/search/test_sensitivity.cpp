// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "ideotype/core/random.hpp"
#include "ideotype/search/sensitivity_indices.hpp"

namespace ideotype {
namespace {

using Function = std::function<double(const Genome&)>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

//! Three angles, and a fourth number that is of no account.
SearchSpace angles() {
    const double pi = std::numbers::pi;
    SearchSpace space;
    for (const char* name : {"a", "b", "c", "none"}) {
        space.genes.push_back({name, "1", -pi, pi, false, true, name});
        space.baseline.push_back(0);
    }
    return space;
}

//! Ishigami and Homma (1990), with variances that are known.
double ishigami(const Genome& x) {
    return std::sin(x[0]) + 7 * std::pow(std::sin(x[1]), 2) +
           0.1 * std::pow(x[2], 4) * std::sin(x[0]);
}

constexpr double first_ishigami[] = {0.31390519114781146, 0.4424111447900409, 0,
                                     0};
constexpr double total_ishigami[] = {0.5575888552099591, 0.4424111447900409,
                                     0.24368366406214768, 0};

//! Independent normal numbers with this standard deviation.
double noise(double spread, std::uint32_t row) {
    RandomStream stream(5, Purpose::mutation, 0, row);
    return spread * std::sqrt(-2 * std::log(1 - stream.uniform())) *
           std::cos(2 * std::numbers::pi * stream.uniform());
}

std::vector<Estimate> evaluated(const SensitivityDesign& design,
                                const Function& function, double spread = 0,
                                double told = 0) {
    std::vector<Estimate> rows;
    for (std::uint32_t i = 0; i < design.samples(); ++i)
        for (std::size_t k = 0; k < design.rows_per_sample(); ++k) {
            const auto row = static_cast<std::uint32_t>(rows.size());
            rows.push_back(
                {function(design.row(i, k)) + noise(spread, row), told});
        }
    return rows;
}

SensitivityDesign sobol_of(int samples, std::uint64_t seed = 1) {
    return {{.samples = samples}, angles(), seed};
}

TEST(Sensitivity, IndicesAreTheKnownOnesWithinTheirErrors) {
    const SensitivityDesign design = sobol_of(4096);
    const auto found = analyse(design, evaluated(design, ishigami));
    EXPECT_EQ(found.samples, 4096U);
    EXPECT_NEAR(found.mean, 3.5, 0.05);
    EXPECT_NEAR(found.standard_deviation, std::sqrt(13.844587940719254), 0.05);
    for (std::size_t i = 0; i < 4; ++i) {
        const auto& [first, first_error] = found.indices[0][i];
        const auto& [total, total_error] = found.indices[1][i];
        EXPECT_NEAR(first, first_ishigami[i], 3 * first_error + 1e-12) << i;
        EXPECT_NEAR(total, total_ishigami[i], 3 * total_error + 1e-12) << i;
        EXPECT_LT(first_error, 0.03);
        EXPECT_LT(total_error, 0.03);
    }
}

TEST(Sensitivity, KnownNoiseIsTakenOffAndBiasesWhatIsNotTold) {
    // Half as much noise as there is signal.
    const SensitivityDesign design = sobol_of(16384);
    constexpr double spread = 2.6;
    const auto told =
        analyse(design, evaluated(design, ishigami, spread, spread));
    const auto untold = analyse(design, evaluated(design, ishigami, spread, 0));
    EXPECT_NEAR(told.noise, spread, 1e-9);
    EXPECT_NEAR(told.standard_deviation, std::sqrt(13.844587940719254), 0.1);
    for (std::size_t i = 0; i < 4; ++i) {
        const auto& [first, first_error] = told.indices[0][i];
        const auto& [total, total_error] = told.indices[1][i];
        EXPECT_NEAR(first, first_ishigami[i], 3 * first_error) << i;
        EXPECT_NEAR(total, total_ishigami[i], 3 * total_error) << i;
        EXPECT_LT(total_error, 0.02);
        const auto& [biased, biased_error] = untold.indices[1][i];
        const double expected =
            (total_ishigami[i] * 13.8446 + spread * spread) /
            (13.8446 + spread * spread);
        EXPECT_NEAR(biased, expected, 3 * biased_error) << i;
        EXPECT_GT(biased, total_ishigami[i] + 5 * biased_error) << i;
    }
}

TEST(Sensitivity, NoiseOfElementaryEffectsIsTakenOffTheirSpread) {
    const SensitivityDesign design(
        {.method = SensitivityMethod::morris, .samples = 8192, .levels = 8},
        angles(), 1);
    constexpr double spread = 1;
    const auto exact = analyse(design, evaluated(design, ishigami));
    const auto told =
        analyse(design, evaluated(design, ishigami, spread, spread));
    const auto untold = analyse(design, evaluated(design, ishigami, spread, 0));
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(told.indices[0][i].mean, exact.indices[0][i].mean,
                    4 * told.indices[0][i].standard_error);
        EXPECT_NEAR(told.indices[2][i].mean, exact.indices[2][i].mean,
                    4 * told.indices[2][i].standard_error + 0.1);
    }
    // Nothing but noise.
    const double alone = std::numbers::sqrt2 * spread / design.step_size();
    EXPECT_EQ(exact.indices[1][3].mean, 0);
    EXPECT_NEAR(untold.indices[2][3].mean, alone, 0.05);
    EXPECT_NEAR(told.indices[1][3].mean, told.indices[3][3].mean, 0.02);
}

TEST(Sensitivity, SamplesThatLackARowAreLeftOut) {
    const SensitivityDesign design = sobol_of(64), half = sobol_of(32);
    auto rows = evaluated(design, ishigami);
    for (std::size_t i = 32; i < 64; ++i)
        rows[i * design.rows_per_sample() + i % 6] = {nan, nan};
    const auto found = analyse(design, rows);
    const auto expected = analyse(half, evaluated(half, ishigami));
    EXPECT_EQ(found.samples, 32U);
    EXPECT_EQ(found.mean, expected.mean);
    for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_EQ(found.indices[k][i].mean, expected.indices[k][i].mean);
    const auto none =
        analyse(design, std::vector<Estimate>(rows.size(), {nan, nan}));
    EXPECT_EQ(none.samples, 0U);
    EXPECT_TRUE(std::isnan(none.indices[0][0].mean));
}

TEST(Sensitivity, ConstantsDependOnNothing) {
    const SensitivityDesign design = sobol_of(64);
    const auto found =
        analyse(design, evaluated(design, [](const Genome&) { return 0.1; }));
    EXPECT_TRUE(std::isnan(found.indices[0][0].mean));
    EXPECT_NEAR(found.standard_deviation, 0, 1e-12);
}

TEST(Sensitivity, GroupsChangeTogetherAndFixedGenesStay) {
    SearchSpace space = angles();
    space.genes[0].trait = space.genes[2].trait = "both";
    space.genes[1].is_free = false;
    space.baseline[1] = 0.5;
    for (const auto method :
         {SensitivityMethod::sobol, SensitivityMethod::morris}) {
        const SensitivityDesign design({.method = method, .samples = 64}, space,
                                       1);
        ASSERT_EQ(design.factors().size(), 2U);
        EXPECT_EQ(design.factors()[0].name, "both");
        EXPECT_EQ(design.factors()[0].genes, (std::vector<std::size_t>{0, 2}));
        for (std::uint32_t i = 0; i < design.samples(); ++i)
            for (std::size_t k = 0; k < 2; ++k) {
                const Genome a = design.row(i, k), b = design.row(i, k + 1);
                EXPECT_EQ(b[1], 0.5);
                EXPECT_EQ(a[0] == b[0], a[2] == b[2]);
                const bool is_one = (a[0] == b[0]) != (a[3] == b[3]);
                EXPECT_TRUE(is_one || method == SensitivityMethod::sobol);
            }
    }
}

TEST(Sensitivity, IndicesOfGroupsAreThoseOfTheirGenesTogether) {
    SearchSpace space = angles();
    space.genes[0].trait = space.genes[2].trait = "both";
    const SensitivityDesign design({.samples = 4096}, space, 1);
    const auto found = analyse(design, evaluated(design, ishigami));
    const auto& [first, error] = found.indices[0][0];
    EXPECT_NEAR(first, 1 - first_ishigami[1], 3 * error);
    EXPECT_NEAR(found.indices[1][0].mean, 1 - first_ishigami[1],
                3 * found.indices[1][0].standard_error);
    EXPECT_LT(error, 0.03);
}

TEST(Sensitivity, PathsStepOnAGridAndTwoEndsOfACircleAreOneLevel) {
    SearchSpace space = angles();
    space.genes[1].is_circular = true;
    const SensitivityDesign design(
        {.method = SensitivityMethod::morris, .samples = 200}, space, 1);
    std::set<double> plain, circular;
    for (std::uint32_t i = 0; i < design.samples(); ++i)
        for (std::size_t k = 0; k < design.rows_per_sample(); ++k) {
            const Genome x = design.row(i, k);
            plain.insert(std::round(1e9 * x[0]));
            circular.insert(std::round(1e9 * x[1]));
        }
    EXPECT_EQ(plain.size(), 4U);
    EXPECT_EQ(circular.size(), 4U);
    EXPECT_NEAR(*plain.rbegin(), 1e9 * std::numbers::pi, 2);
    EXPECT_NEAR(*circular.rbegin(), 1e9 * std::numbers::pi / 2, 2);
}

TEST(Sensitivity, TheSearchProposesTheRowsOfTheDesign) {
    const SensitivitySettings settings{.samples = 20};
    SensitivitySearch search(settings, angles(), 3);
    const SensitivityDesign design(settings, angles(), 3);
    std::size_t rows = 0;
    for (std::uint32_t g = 0; g < 2; ++g) {
        EXPECT_LE(static_cast<int>(search.size(g)),
                  generation_size(settings, angles().genes));
        for (std::uint32_t slot = 0; slot < search.size(g); ++slot, ++rows) {
            EXPECT_EQ(search.needs(g, slot), 0U);
            EXPECT_EQ(
                search.propose(g, slot).genome,
                design.row(static_cast<std::uint32_t>(rows / 6), rows % 6));
        }
    }
    EXPECT_EQ(generations_of(settings), 2);
    EXPECT_EQ(rows, 120U);
    EXPECT_TRUE(search.best(5).empty());
}

}  // namespace
}  // namespace ideotype
