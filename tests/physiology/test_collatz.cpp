// SPDX-License-Identifier: Apache-2.0
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "derivatives.hpp"
#include "ideotype/physiology/collatz.hpp"
#include "ideotype/physiology/energy_balance.hpp"
#include "ideotype/physiology/temperature.hpp"

namespace ideotype {
namespace {

//! Reads values computed by independent code, see data/physiology/README.md.
nlohmann::json values() {
    std::ifstream file(IDEOTYPE_TEST_DATA "/physiology/collatz.json");
    return nlohmann::json::parse(file);
}

constexpr Stomata biocro{Stomata::Model::ball_berry, .08, 3};

TEST(Collatz, HasTheValuesOfFixedCo2) {
    const nlohmann::json all = values().at("fixed_ci");
    ASSERT_EQ(all.size(), 20U);
    for (const auto& each : all) {
        const double temperature = each.at("T");
        const double ci =
            ci_of_deficit(vapour_deficit(temperature, each.at("vpd_rh")));
        EXPECT_NEAR(ci, each.at("ci"), 1e-9);
        const Colimitation f = collatz_at({}, temperature, ci);
        EXPECT_NEAR(f.gross(each.at("Q")), each.at("gross"), 1e-9);
        EXPECT_NEAR(dark_respiration(CollatzLeaf{}, temperature), each.at("Rd"),
                    1e-9);
    }
}

TEST(Collatz, HasTheValuesOfBallAndBerry) {
    const nlohmann::json all = values().at("ball_berry");
    ASSERT_EQ(all.size(), 30U);
    for (const auto& each : all) {
        const double temperature = each.at("T");
        const SurfaceAir air{
            each.at("ca"),
            each.at("rh").get<double>() * saturated_vapour(temperature), 1.2};
        const LeafBalance leaf =
            balance({}, biocro, air, each.at("Q"), temperature);
        EXPECT_NEAR(leaf.net, each.at("A"), 1e-9);
        EXPECT_NEAR(leaf.ci, each.at("ci"), 1e-7);
        EXPECT_NEAR(leaf.conductance, each.at("gs"), 1e-10);
    }
}

TEST(Collatz, IsConcaveFromItsQuantumYield) {
    for (const double temperature : {5., 15., 25., 40.})
        expect_concave(collatz_at({}, temperature, 160));
}

TEST(Collatz, OfALeafWithStomataIsConcave) {
    for (const double humidity : {.3, .7, 1.}) {
        double before = 1, last = 0;
        for (double light = 10; light < 2500; light += 10) {
            const SurfaceAir air{400, humidity * saturated_vapour(25), 1.2};
            const double gross = balance({}, biocro, air, light, 25).net +
                                 dark_respiration(CollatzLeaf{}, 25);
            EXPECT_LT(gross - last, before + 1e-8);
            before = gross - last;
            last = gross;
        }
    }
}

TEST(Collatz, HasNoCo2InVeryDryAir) {
    EXPECT_EQ(ci_of_deficit(10), 0);
    EXPECT_DOUBLE_EQ(ci_of_deficit(0), .84 * 400);
    EXPECT_EQ(collatz_at({}, 25, 0).gross(1000), 0);
    EXPECT_EQ(collatz_at({}, 25, 0).slope(1000), 0);
}

TEST(Collatz, ExpandsToItsDerivatives) {
    expect_derivatives(collatz_at({}, 25, 160));
}

}  // namespace
}  // namespace ideotype
