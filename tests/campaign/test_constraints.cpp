#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "sample_campaign.hpp"

namespace ideotype {
namespace {

const std::vector<LeafTraits> plant{
    {.6, .06, 60, 0}, {.8, .08, 40, 0}, {.5, .05, 50, 0}};

TEST(Constraints, UsuallyForbidNothing) {
    EXPECT_EQ(violation({}, plant, 0), 0);
    EXPECT_EQ(violation({}, plant, 12), 0);
}

TEST(Constraints, LeafAreaMayBeBoundedOnBothSides) {
    Constraints constraints;
    constraints.lai = {3, 4};
    EXPECT_EQ(violation(constraints, plant, 3.5), 0);
    EXPECT_NEAR(violation(constraints, plant, 2.4), .2, 1e-12);
    EXPECT_NEAR(violation(constraints, plant, 5), .25, 1e-12);
}

TEST(Constraints, StepsBetweenNeighbouringLeavesMayBeLimited) {
    Constraints constraints;
    constraints.length_step = .2;
    EXPECT_NEAR(violation(constraints, plant, 3), .5, 1e-12);
    constraints.length_step = .31;
    EXPECT_EQ(violation(constraints, plant, 3), 0);
    constraints.width_step = .025;
    EXPECT_NEAR(violation(constraints, plant, 3), .2, 1e-12);
    constraints.width_step = 0;
    constraints.insertion_angle_step = 10;
    EXPECT_NEAR(violation(constraints, plant, 3), 1, 1e-12);
}

TEST(Constraints, ErectTopsMayBeAskedFor) {
    Constraints constraints;
    constraints.erect_top = true;
    EXPECT_NEAR(violation(constraints, plant, 3), 10. / 90, 1e-12);
    EXPECT_EQ(violation(constraints, {plant[0], plant[1]}, 3), 0);
}

TEST(Constraints, WhatContradictsItselfIsRefused) {
    EXPECT_THROW(sample("", "[field]\nborder_rows = 1\n"), InputError);
    EXPECT_THROW(
        sample("", "[field]\nboundary = \"isolated\"\nborder_rows = 3\n"),
        InputError);
    EXPECT_THROW(sample("", "[constraints]\nlai = [4, 3]\n"), InputError);
    EXPECT_THROW(sample("", "[constraints]\nlai = [-1, 0]\n"), InputError);
}

TEST(Constraints, ATolerancesRandomisationsAndScheduleMustMakeSense) {
    const std::string tolerance = "[light]\ntolerance = 0.005\n";
    EXPECT_EQ(sample("", tolerance).sampling.tolerance, .005);
    EXPECT_THROW(sample("", tolerance + "randomisations = 7\n"), InputError);
    EXPECT_THROW(sample("", tolerance + "first_tolerance = 0.004\n"),
                 InputError);
    EXPECT_THROW(sample("", "[light]\npaths = 64\nfirst_tolerance = 0.01\n"),
                 InputError);
    EXPECT_EQ(
        sample("", tolerance + "first_tolerance = 0.01\n").first_tolerance,
        .01);
}

}  // namespace
}  // namespace ideotype
