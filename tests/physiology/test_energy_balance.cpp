// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "any_leaf.hpp"
#include "ideotype/physiology/temperature.hpp"

namespace ideotype {
namespace {

//! Reads cases computed by independent code, see data/physiology/README.md.
std::vector<Case> cases() {
    std::ifstream file(IDEOTYPE_TEST_DATA "/physiology/energy_given.json");
    const nlohmann::json all = nlohmann::json::parse(file);
    std::vector<Case> result;
    for (const auto& each : all.at("cases")) {
        nlohmann::json p = all.at("defaults");
        const nlohmann::json& in = each.at("input");
        if (in.contains("parameters")) p.update(in.at("parameters"));
        const bool is_medlyn = p.at("stomata") == "medlyn";
        result.push_back(
            {each.at("name"),
             {CollatzLeaf{p.at("vmax"), p.at("alpha"), p.at("theta"),
                          p.at("beta"), p.at("k"), p.at("rd")},
              is_medlyn
                  ? Stomata{Stomata::Model::medlyn, p.at("g0"), p.at("g1")}
                  : Stomata{Stomata::Model::ball_berry, p.at("b0"), p.at("b1")},
              p.at("emissivity"), p.at("ratio")},
             {in.at("ppfd"), in.at("nir"), in.at("longwave"), in.at("air"),
              in.at("rh"), in.at("co2"), in.at("pressure"), in.at("wind"),
              in.at("width")},
             each.at("expected")});
    }
    return result;
}

TEST(EnergyBalance, HasTheValuesOfOtherCode) {
    const std::vector<Case> all = cases();
    ASSERT_EQ(all.size(), 40U);
    for (const Case& each : all) {
        SCOPED_TRACE(each.name);
        const EnergyBalance found = energy_balance(each.leaf, each.around);
        const auto expected = [&](const char* name) -> double {
            return each.expected.at(name);
        };
        EXPECT_NEAR(found.temperature, expected("leaf"), 1e-7);
        EXPECT_NEAR(found.net, expected("net"), 1e-6);
        EXPECT_NEAR(found.conductance, expected("gs"), 1e-7);
        EXPECT_NEAR(found.ci, expected("ci"), 1e-4);
        EXPECT_NEAR(found.transpiration, expected("transpiration"), 1e-6);
        EXPECT_NEAR(found.latent, expected("latent"), 1e-5);
        EXPECT_NEAR(found.sensible, expected("sensible"), 1e-5);
        EXPECT_NEAR(found.net_radiation, expected("net_radiation"), 1e-5);
        EXPECT_NEAR(found.boundary_heat, expected("boundary_heat"), 1e-8);
        EXPECT_EQ(found.roots, 1);
    }
}

//! An independent implementation of the equations stated in the header.
struct Fluxes {
    Fluxes(const ThermalLeaf& leaf, const LeafSurroundings& in, double t)
        : apart(t - in.temperature) {
        const double d = .72 * in.width;
        const double kelvin = in.temperature + 273.15;
        const double still = 2.15e-5 * in.pressure / 8.314462618e-3 / kelvin;
        heat = std::cbrt(std::pow(1.4 * .135 * std::sqrt(in.wind / d), 3) +
                         std::pow(.05, 3) * std::pow(std::abs(apart) / d, .75) +
                         std::pow(still / d, 3));
        const double r = leaf.ratio;
        boundary = 1.09 * heat;
        if (!std::isinf(r)) boundary *= (1 + r) * (1 + r) / (1 + r * r);
        vapour = in.humidity * saturated_vapour(in.temperature);
        const double deficit = saturated_vapour(t) - vapour;
        per_conductance = .0180153 * (2.501e6 - 2361 * in.temperature) *
                          deficit / in.pressure;
        dry = in.ppfd / 4.57 + in.nir + in.longwave -
              2 * leaf.emissivity * 5.670374419e-8 * std::pow(t + 273.15, 4) -
              2 * 29.3 * heat * apart;
    }

    //! Returns absorbed minus lost energy [W m-2].
    double left(double gs) const {
        return dry - per_conductance * (per_conductance < 0
                                            ? 2 * 1.09 * heat
                                            : gs * boundary / (gs + boundary));
    }

    double apart, heat, boundary, vapour, per_conductance, dry;
};

double net_of(const Case& each, double temperature, double ci) {
    return std::visit(
        [&](const auto& rates) {
            const double dark = dark_respiration(rates, temperature);
            if constexpr (std::is_same_v<std::decay_t<decltype(rates)>,
                                         CollatzLeaf>)
                return collatz_at(rates, temperature, ci)
                           .gross(each.around.ppfd) -
                       dark;
            else
                return farquhar_at(rates, temperature, ci)
                           .gross(each.around.ppfd) -
                       dark;
        },
        each.leaf.rates);
}

//! Returns the stomatal conductance that the stomatal model of a case predicts.
double wanted(const Case& each, const EnergyBalance& found) {
    const Fluxes at(each.leaf, each.around, found.temperature);
    const double per_co2 = std::max(found.net, 0.) /
                           (each.around.co2 - 1.37 * found.net / at.boundary);
    const double es = saturated_vapour(found.temperature);
    const double surface = (at.boundary * at.vapour + found.conductance * es) /
                           (at.boundary + found.conductance);
    const Stomata& stomata = each.leaf.stomata;
    return stomata.intercept +
           per_co2 * (stomata.model == Stomata::Model::medlyn
                          ? 1.6 * (1 + stomata.slope / std::sqrt(std::max(
                                                           es - surface, .05)))
                          : stomata.slope * std::min(surface / es, 1.));
}

TEST(EnergyBalance, ClosesForAnyLeaf) {
    AnyLeaf any;
    int several = 0;
    for (int i = 0; i < 10000; ++i) {
        SCOPED_TRACE(i);
        const Case each = any.next();
        const EnergyBalance found = energy_balance(each.leaf, each.around);
        const Fluxes at(each.leaf, each.around, found.temperature);
        ASSERT_NEAR(at.left(found.conductance), 0, 1e-6);
        ASSERT_NEAR(net_of(each, found.temperature, found.ci), found.net, 1e-8);
        ASSERT_NEAR(wanted(each, found), found.conductance,
                    1e-7 * (1 + found.conductance));
        const double inside = each.around.co2 - 1.37 * found.net / at.boundary -
                              1.6 * found.net / found.conductance;
        if (found.conductance > 1e-4) {
            ASSERT_NEAR(found.ci, inside, 1e-6 * each.around.co2);
        }
        ASSERT_TRUE(std::isfinite(found.ci));
        ASSERT_EQ(found.roots % 2, 1);
        several += found.roots > 1;
    }
    std::printf("several balances: %d of 10000\n", several);
    EXPECT_GT(several, 100);
    EXPECT_LT(several, 300);
}

// At a given temperature, leaves with the most open stomata lose the most
// energy. If an excess remains even then, no stomatal conductance balances the
// energy.
TEST(EnergyBalance, IsTheCoolest) {
    AnyLeaf any;
    for (int i = 0; i < 1000; ++i) {
        SCOPED_TRACE(i);
        const Case each = any.next();
        const double found = energy_balance(each.leaf, each.around).temperature;
        const double range = std::max(25 + found - each.around.temperature, 1.);
        for (double part = 1e-5; part < 1; part *= 1.2) {
            const double t = found - part * range;
            const Fluxes at(each.leaf, each.around, t);
            const LeafBalance open = balance(
                each.leaf.rates, each.leaf.stomata,
                {each.around.co2, at.vapour, at.boundary}, each.around.ppfd, t);
            ASSERT_GT(at.left(open.conductance), 0) << t << " < " << found;
        }
    }
}

// Enzymes fail above 45 deg C, so that a leaf in strong light and calm air has
// two stable states, cool and hot.
TEST(EnergyBalance, OfCalmStrongLightIsCool) {
    LeafSurroundings around{2000, 300, 840, 30, .5, 410, 99, .03, .08};
    const EnergyBalance several = energy_balance({}, around);
    EXPECT_EQ(several.roots, 3);
    EXPECT_LT(several.temperature, 40);
    EXPECT_GT(several.net, 30);
    around.wind = 2;
    EXPECT_EQ(energy_balance({}, around).roots, 1);
}

// With the model of Ball and Berry in dry, calm air, closed stomata are exposed
// to dry air and therefore stay closed.
TEST(EnergyBalance, OfOneTemperatureMayHaveThreeByBallAndBerry) {
    int several = 0;
    for (double humidity = .05; humidity < 1; humidity += .05)
        for (double boundary = .05; boundary < 2; boundary *= 1.3) {
            const double vapour = humidity * saturated_vapour(30);
            const SurfaceAir air{400, vapour, boundary};
            const LeafBalance leaf = balance(
                {}, {Stomata::Model::ball_berry, .017, 4.53}, air, 1500, 30);
            EXPECT_EQ(balance({}, {}, air, 1500, 30).roots, 1);
            several += leaf.roots == 3;
            EXPECT_LE(leaf.roots, humidity < .35 && boundary < 1 ? 3 : 1);
        }
    EXPECT_GT(several, 0);
}

TEST(EnergyBalance, FollowsTheAir) {
    const LeafSurroundings noon{1361, 162.5, 839.073, 28.4, .55,
                                410,  99,    1.5,     .08};
    const EnergyBalance before = energy_balance({}, noon);
    const auto with = [&](double LeafSurroundings::*member, double value) {
        LeafSurroundings other = noon;
        other.*member = value;
        return energy_balance({}, other);
    };
    const EnergyBalance co2 = with(&LeafSurroundings::co2, 550);
    EXPECT_LT(co2.conductance, before.conductance);
    EXPECT_LT(co2.transpiration, before.transpiration);
    EXPECT_GT(co2.temperature, before.temperature);
    EXPECT_GT(co2.net, before.net);
    EXPECT_GT(before.temperature, noon.temperature);
    EXPECT_LT(with(&LeafSurroundings::wind, 5).temperature, before.temperature);
    EXPECT_GT(with(&LeafSurroundings::width, .12).temperature,
              before.temperature);
    const EnergyBalance humid = with(&LeafSurroundings::humidity, .8);
    EXPECT_LT(humid.transpiration, before.transpiration);
    EXPECT_GT(humid.temperature, before.temperature);
    const EnergyBalance dim = with(&LeafSurroundings::ppfd, 400);
    EXPECT_LT(dim.net, before.net);
    EXPECT_LT(dim.conductance, before.conductance);
    EXPECT_LT(dim.temperature, before.temperature);
}

}  // namespace
}  // namespace ideotype
