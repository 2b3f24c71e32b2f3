// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "quantities/declaration.hpp"

namespace ideotype {
namespace {

template <class... Parts>
concept Declares = requires(Parts... parts) {
    Declaration{parts...};
};

// A declaration without a mean over the season does not compile, so that the
// mean is never left to a default.
static_assert(Declares<Quantity, MeanOver, TakeNumber>);
static_assert(!Declares<Quantity, TakeNumber>);
static_assert(!Declares<Quantity, TakeProfile>);

TEST(Quantities, StateTheirMeanOverASeasonByName) {
    EXPECT_EQ(mean_over("net_assimilation"), MeanOver::nothing);
    EXPECT_EQ(mean_over("paths"), MeanOver::nothing);
    EXPECT_EQ(mean_over("lai"), MeanOver::time);
    EXPECT_EQ(mean_over("fapar"), MeanOver::incident_light);
    EXPECT_EQ(mean_over("light_use_efficiency"), MeanOver::absorbed_light);
    EXPECT_EQ(mean_over("water_use_efficiency"), MeanOver::transpired_water);
    EXPECT_EQ(mean_over("hot_hours"), MeanOver::leaf_area);
    EXPECT_EQ(mean_over("net_assimilation_per_leaf_area"), MeanOver::leaf_area);
    EXPECT_EQ(mean_over(extinction), MeanOver::leaf_area_time);
    EXPECT_THROW(mean_over("no_such_quantity"), std::out_of_range);
}

}  // namespace
}  // namespace ideotype
