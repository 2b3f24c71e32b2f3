// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "ideotype/core/random.hpp"
#include "search/quadratic/response_surface.hpp"
#include "search/quadratic/surface_arm.hpp"

namespace ideotype {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

//! Draws uniform numbers from -1 to 1.
MatrixXd draw(RandomStream& stream, Index rows, Index columns) {
    MatrixXd drawn(rows, columns);
    for (Index k = 0; k < columns; ++k)
        for (Index i = 0; i < rows; ++i) drawn(i, k) = stream.uniform(-1, 1);
    return drawn;
}

const VectorXd slopes{{1.5, -0.2, 0, 0.7}};
const VectorXd curvatures{{-3, -1, 2, 0}};

//! Makes generations of a quadratic with noise; each has its own offset.
std::vector<SurfaceRows> make_rows(std::size_t generations, Index size,
                                   double noise) {
    RandomStream stream(7, Purpose::jitter);
    std::vector<SurfaceRows> all;
    for (std::size_t g = 0; g < generations; ++g) {
        const MatrixXd points = draw(stream, slopes.size(), size);
        VectorXd values(size);
        for (Index i = 0; i < size; ++i)
            values[i] = ResponseSurface{slopes, curvatures}.at(points.col(i)) +
                        100 * static_cast<double>(g) +
                        noise * stream.normal()[0];
        all.push_back({points, values, 1});
    }
    return all;
}

TEST(ResponseSurface, AQuadraticIsRecoveredDespiteTheOffsetsOfGenerations) {
    const ResponseSurface surface = fit_surface(make_rows(3, 12, 0));
    EXPECT_LT((surface.slopes - slopes).cwiseAbs().maxCoeff(), 1e-4);
    EXPECT_LT((surface.curvatures - curvatures).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(ResponseSurface, CoefficientsOfNoiseShrink) {
    RandomStream stream(5, Purpose::jitter);
    double squares = 0, least_squares = 0;
    for (int k = 0; k < 20; ++k) {
        const MatrixXd points = draw(stream, 3, 24);
        VectorXd noise(24);
        for (double& value : noise) value = stream.normal()[0];
        squares += fit_surface({{points, noise, 1}}).slopes.squaredNorm();
        MatrixXd terms(24, 7);
        terms << points.transpose(), points.transpose().cwiseAbs2() / 2,
            VectorXd::Ones(24);
        least_squares +=
            terms.colPivHouseholderQr().solve(noise).head(3).squaredNorm();
    }
    EXPECT_LT(squares, least_squares / 3);
}

TEST(ResponseSurface, RowsWithMoreWeightDetermineTheFit) {
    std::vector<SurfaceRows> rows = make_rows(2, 40, 0);
    rows[0].values *= -1;
    rows[0].weight = 1e-9;
    EXPECT_LT((fit_surface(rows).slopes - slopes).norm(), 1e-3);
    rows[0].weight = 1e9;
    EXPECT_LT((fit_surface(rows).slopes + slopes).norm(), 1e-3);
}

TEST(ResponseSurface, AFlatObjectiveHasNoSlopes) {
    RandomStream stream(5, Purpose::jitter);
    const ResponseSurface surface =
        fit_surface({{draw(stream, 3, 8), VectorXd::Constant(8, 5), 1}});
    EXPECT_EQ(surface.slopes, VectorXd::Zero(3));
    EXPECT_EQ(surface.maximise(1), VectorXd::Zero(3));
}

TEST(ResponseSurface, MaximumIsInsideOrOnTheBall) {
    const ResponseSurface concave{VectorXd{{1, -1}}, VectorXd{{-2, -4}}};
    EXPECT_LT((concave.maximise(1) - VectorXd{{0.5, -0.25}}).norm(), 1e-12);
    EXPECT_NEAR(concave.maximise(0.1).norm(), 0.1, 1e-8);
    const ResponseSurface saddle{VectorXd{{0.1, -1}}, VectorXd{{2, -4}}};
    EXPECT_NEAR(saddle.maximise(3).norm(), 3, 1e-7);
}

TEST(ResponseSurface, MaximumIsTheBestPointOfAFineGrid) {
    RandomStream stream(3, Purpose::jitter);
    for (int k = 0; k < 20; ++k) {
        const ResponseSurface surface{draw(stream, 2, 1), draw(stream, 2, 1)};
        const VectorXd best = surface.maximise(1);
        EXPECT_LE(best.norm(), 1 + 1e-9);
        for (double x = -1; x <= 1; x += 0.05)
            for (double y = -1; y <= 1; y += 0.05)
                if (x * x + y * y <= 1) {
                    EXPECT_GE(surface.at(best) + 1e-7,
                              surface.at(VectorXd{{x, y}}));
                }
    }
}

using Function = std::function<double(const Genome&)>;

GeneSpace make_genes(std::size_t count) {
    return GeneSpace(count, {"x", "1", -5, 5, false, true});
}

double sphere(const Genome& x) {
    double sum = 0;
    for (const double value : x) sum += value * value;
    return sum;
}

double ellipsoid(const Genome& x) {
    double sum = 0;
    const auto last = static_cast<double>(x.size() - 1);
    for (std::size_t i = 0; i < x.size(); ++i)
        sum += std::pow(100, static_cast<double>(i) / last) * x[i] * x[i];
    return sum;
}

//! A search by surfaces for the minimum, from the point (3, ..., 3).
class SurfaceArms : public ::testing::Test {
  protected:
    static constexpr std::size_t dimension = 10;
    const Genome start = Genome(dimension, 3);
    SurfaceArm arm{UnboundedGenes(make_genes(dimension)), start, 8};

    Population evaluate(const Function& f, std::uint32_t generation) const {
        Population rows;
        for (std::uint32_t slot = 0; slot < arm.size(); ++slot) {
            const Candidate candidate =
                arm.candidate(1, generation, slot, start);
            rows.push_back(
                {candidate, Status::done, {{f(candidate.genome), 0}}, 0});
        }
        return rows;
    }
    void run(const Function& f, std::uint32_t generations) {
        for (std::uint32_t g = 0; g < generations; ++g)
            arm.learn(evaluate(f, g), Sense::minimise, 1, g);
    }
    Genome centre() const { return arm.centre(start).genome; }
};

TEST_F(SurfaceArms, AGenerationConsistsOfCentresAndOppositePairs) {
    EXPECT_EQ(arm.size(), 17U);
    arm = {UnboundedGenes(make_genes(dimension)), Genome(dimension, 0), 8};
    run([](const Genome& x) { return x[0] * x[0] - x[1]; }, 1);
    ASSERT_EQ(arm.size(), 18U);
    const auto genome = [&](std::uint32_t slot) {
        return arm.candidate(1, 1, slot, start).genome;
    };
    EXPECT_EQ(genome(0), centre());
    EXPECT_GT(centre()[1], 0.1);
    int count = 0;
    for (std::size_t i = 0; i < dimension; ++i) {
        EXPECT_NEAR(genome(1)[i], 0, 1e-12) << "the previous centre";
        for (std::uint32_t slot = 2; slot < 18; slot += 2) {
            const double a = genome(slot)[i], b = genome(slot + 1)[i];
            const double middle = centre()[i];
            // Points near and beyond a bound are reflected.
            constexpr double usual = 2;
            if (std::max(std::abs(a - middle), std::abs(b - middle)) > usual)
                continue;
            EXPECT_NEAR(a + b, 2 * middle, 1e-9);
            ++count;
        }
    }
    EXPECT_GT(count, 40) << "of 80";
}

TEST_F(SurfaceArms, SphereIsReducedAHundredfoldInTenGenerations) {
    run(sphere, 10);
    EXPECT_LT(sphere(centre()), sphere(start) / 100);
}

TEST_F(SurfaceArms, EllipsoidIsReducedTenfoldInTenGenerations) {
    run(ellipsoid, 10);
    EXPECT_LT(ellipsoid(centre()), ellipsoid(start) / 10);
}

TEST_F(SurfaceArms, ValuesThatAGenerationSharesHaveNoEffect) {
    SurfaceArm other = arm;
    for (std::uint32_t g = 0; g < 6; ++g) {
        Population rows = evaluate(sphere, g);
        arm.learn(rows, Sense::minimise, 1, g);
        for (Individual& row : rows) row.objectives[0].mean += 50. * (g % 2);
        other.learn(rows, Sense::minimise, 1, g);
        EXPECT_LT((arm.mean() - other.mean()).norm(), 1e-6);
    }
}

TEST_F(SurfaceArms, OptimumIsApproachedUnderNoise) {
    RandomStream noise(5, Purpose::jitter);
    // The standard deviation is a third of the value at the start.
    const double deviation = sphere(start) / 3;
    run(
        [&](const Genome& x) {
            return sphere(x) + deviation * noise.normal()[0];
        },
        20);
    EXPECT_LT(sphere(centre()), sphere(start) / 3);
}

TEST_F(SurfaceArms, FailedRowsAreIgnored) {
    for (std::uint32_t g = 0; g < 12; ++g) {
        Population rows = evaluate(sphere, g);
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (g % 4 == 0 || (i + g) % 3 == 0) {
                rows[i].status = Status::failed;
                rows[i].objectives[0].mean =
                    std::numeric_limits<double>::quiet_NaN();
            }
        const Genome before = centre();
        arm.learn(rows, Sense::minimise, 1, g);
        if (g == 0) {
            EXPECT_EQ(centre(), before);
        }
        EXPECT_TRUE(arm.mean().allFinite() && arm.deviations().allFinite());
    }
    EXPECT_LT(sphere(centre()), sphere(start) / 10);
}

TEST_F(SurfaceArms, CentreStaysOnAFlatObjectiveAndTheRegionShrinks) {
    const VectorXd deviations = arm.deviations();
    run([](const Genome&) { return 4; }, 10);
    for (const double x : centre()) EXPECT_DOUBLE_EQ(x, 3);
    EXPECT_LT(arm.deviations()[0], deviations[0] / 2);
    EXPECT_GT(arm.deviations()[0], 0);
}

TEST_F(SurfaceArms, RegionShrinksIfPredictionsFail) {
    const double first = arm.deviations()[0];
    for (std::uint32_t g = 0; g < 4; ++g) {
        Population rows = evaluate(sphere, g);
        // The new centre is worse than the previous one.
        if (g > 0) rows[0].objectives[0].mean = 1e3;
        arm.learn(rows, Sense::minimise, 1, g);
    }
    EXPECT_NEAR(arm.deviations()[0], first * std::pow(0.85, 3), 1e-12);
}

TEST_F(SurfaceArms, RegionGrowsAgainOnceStepsReachItsEdge) {
    const double first = arm.deviations()[0];
    for (std::uint32_t g = 0; g < 4; ++g) {
        Population rows =
            evaluate([](const Genome& x) { return x[0] + x[1] - x[2]; }, g);
        if (g == 1) rows[0].objectives[0].mean = 1e3;
        arm.learn(rows, Sense::minimise, 1, g);
        if (g == 1) {
            EXPECT_LT(arm.deviations()[0], first);
        }
    }
    EXPECT_DOUBLE_EQ(arm.deviations()[0], first);
}

}  // namespace
}  // namespace ideotype
