// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "sample_campaign.hpp"

namespace ideotype {
namespace {

Plant plant_of(const std::vector<Leaf>& leaves) {
    Plant plant;
    plant.leaves = leaves;
    return plant;
}

const Plant plant = plant_of({{.6, .06, 60}, {.8, .08, 40}, {.5, .05, 50}});

std::vector<Trait> leaf_traits() {
    std::vector<Trait> traits;
    for (const std::string name :
         {"length", "width", "insertion_angle", "azimuth"}) {
        traits.emplace_back();
        traits.back().name = name;
        traits.back().measures = {"leaf." + name};
    }
    return traits;
}

double excess(const TraitConstraint& limit, const Plant& of = plant) {
    return violation({{0, 1000}, {limit}}, leaf_traits(), of, 3);
}

TEST(Constraints, AllowEverythingByDefault) {
    EXPECT_EQ(violation({}, leaf_traits(), plant, 0), 0);
    EXPECT_EQ(violation({}, leaf_traits(), plant, 12), 0);
}

TEST(Constraints, LeafAreaMayBeBoundedOnBothSides) {
    const Constraints constraints{{3, 4}, {}};
    const auto violation_at = [&](double lai) {
        return violation(constraints, leaf_traits(), plant, lai);
    };
    EXPECT_EQ(violation_at(3.5), 0);
    EXPECT_NEAR(violation_at(2.4), .2, 1e-12);
    EXPECT_NEAR(violation_at(5), .25, 1e-12);
}

TEST(Constraints, StepsBetweenNeighbouringLeavesMayBeLimited) {
    TraitConstraint limit{"length", .2};
    EXPECT_NEAR(excess(limit), .5, 1e-12);
    limit.step = .31;
    EXPECT_EQ(excess(limit), 0);
    EXPECT_NEAR(excess({"width", .025}), .2, 1e-12);
    EXPECT_NEAR(excess({"insertion_angle", 10}), 1, 1e-12);
}

TEST(Constraints, EachLeafOrOnlyTheHighestMayHaveARange) {
    TraitConstraint limit{"insertion_angle"};
    EXPECT_FALSE(constrains(limit));
    limit.range = {45, 90};
    EXPECT_TRUE(constrains(limit));
    EXPECT_NEAR(excess(limit), 5. / 45, 1e-12);
    limit.highest = 1;
    EXPECT_EQ(excess(limit), 0);
    limit.range = {0, 25};
    EXPECT_NEAR(excess(limit), 1, 1e-12);
    limit.highest = 9;
    EXPECT_NEAR(excess(limit), 35. / 25 + 15. / 25 + 1, 1e-12);
    limit = {"azimuth"};
    limit.range = {0, 0};
    EXPECT_EQ(excess(limit), 0);
}

TEST(Constraints, StepsOfAzimuthsGoAroundTheCircle) {
    const Plant around =
        plant_of({{1, .1, 0, 0, 350}, {1, .1, 0, 0, 10}, {1, .1, 0, 0, 40}});
    EXPECT_EQ(excess({"azimuth", 30}, around), 0);
    EXPECT_NEAR(excess({"azimuth", 20}, around), .5, 1e-12);
}

TEST(Constraints, TheTotalOfATraitMayBeBounded) {
    TraitConstraint limit{"length"};
    limit.total = {1.9, 2};
    EXPECT_NEAR(excess(limit), 0, 1e-12);
    limit.total = {1, 1.52};
    EXPECT_NEAR(excess(limit), .25, 1e-12);
    limit.total = {2, 3};
    EXPECT_NEAR(excess(limit), .05, 1e-12);
}

TEST(Constraints, ErectTopLeavesMayBeRequired) {
    TraitConstraint limit{"insertion_angle"};
    limit.is_falling = true;
    EXPECT_NEAR(excess(limit), 10. / 90, 1e-12);
    EXPECT_EQ(excess(limit, plant_of({plant.leaves[0], plant.leaves[1]})), 0);
}

TEST(Constraints, LeavesMayBeRequiredToBeDistichous) {
    TraitConstraint limit{"azimuth"};
    limit.distichous = 10;
    const auto violation_of = [&](const std::vector<double>& azimuths) {
        std::vector<Leaf> leaves;
        for (const double azimuth : azimuths)
            leaves.push_back({1, .1, 0, 0, azimuth});
        return excess(limit, plant_of(leaves));
    };
    EXPECT_EQ(violation_of({90, 270, 90, 270}), 0);
    // The leaves lie in one plane, at any azimuth.
    for (const double plane : {0., 47., 175., 200., 359.})
        EXPECT_EQ(
            violation_of({plane - 10, plane + 190, plane + 10, plane - 190}), 0)
            << plane;
    // All leaves deviate by 15 deg from their mean plane, which exceeds the
    // limit by half.
    EXPECT_NEAR(violation_of({90, 270, 120, 270}), 2, 1e-9);
    EXPECT_NEAR(violation_of({350, 170, 20, 170}), 2, 1e-9);
    // All leaves point to the same side.
    EXPECT_GT(violation_of({90, 90}), 10);
}

TEST(Constraints, AreDeclaredOnTraitsByName) {
    const Campaign campaign =
        sample("",
               "[constraints]\nlength.step = 0.1\nlength.total = [0.5, 3]\n"
               "[constraints.azimuth]\ndistichous = 20\n");
    ASSERT_EQ(campaign.spec.constraints.traits.size(), 2u);
    EXPECT_EQ(campaign.spec.constraints.traits[0].trait, "length");
    EXPECT_EQ(campaign.spec.constraints.traits[0].total.upper, 3);
    EXPECT_EQ(campaign.spec.constraints.traits[1].distichous, 20);
    EXPECT_EQ(parse_campaign(campaign.resolved, "again").resolved,
              campaign.resolved);
    EXPECT_THROW(sample("", "[constraints.lenght]\nstep = 0.1\n"), InputError);
    EXPECT_THROW(sample("", "[constraints]\nlength.distichous = 20\n"),
                 InputError);
}

TEST(Constraints, ContradictionsAreRefused) {
    EXPECT_THROW(sample("", "[field]\nborder_rows = 1\n"), InputError);
    EXPECT_THROW(
        sample("", "[field]\nboundary = \"isolated\"\nborder_rows = 3\n"),
        InputError);
    EXPECT_THROW(sample("", "[constraints]\nlai = [4, 3]\n"), InputError);
    EXPECT_THROW(sample("", "[constraints]\nlai = [-1, 0]\n"), InputError);
}

TEST(Constraints, ATolerancesRandomisationsMustMakeSense) {
    const std::string tolerance = "[light]\ntolerance = 0.005\n";
    EXPECT_EQ(sample("", tolerance).sampling.tolerance, .005);
    EXPECT_THROW(sample("", tolerance + "randomisations = 7\n"), InputError);
}

}  // namespace
}  // namespace ideotype
