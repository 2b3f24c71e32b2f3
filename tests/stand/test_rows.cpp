// SPDX-License-Identifier: Apache-2.0
// Tests the rows of fields with several components.
#include <cmath>

#include "mixtures.hpp"

namespace ideotype {
namespace {

using RowsOfMixtures = Mixtures;

TEST_F(RowsOfMixtures, StripsHaveTheStatedRowsAndPlants) {
    const Campaign campaign = read_campaign(IDEOTYPE_CAMPAIGNS "/strip.toml");
    const Scene scene = scene_of(campaign, cases(campaign).front());
    EXPECT_NEAR(scene.cell.period_x, 2.2, 1e-12);
    ASSERT_EQ(scene.components.size(), 2u);
    EXPECT_EQ(scene.components[0].plants(), 8u);
    EXPECT_EQ(scene.components[1].plants(), 18u);
    EXPECT_EQ(scene.components[1].jitter, 180);
    const std::vector<double> rows{.3, .7, 1.3, 1.6, 1.9};
    for (std::size_t r = 0; r < rows.size(); ++r)
        EXPECT_NEAR(scene.cell.rows[r], rows[r], 1e-12) << r;
    EXPECT_NEAR(scene.components[1].ground_per_plant * 18,
                scene.cell.ground_area, 1e-12);
    EXPECT_EQ(draw_places(scene, {})[1].front().x, scene.cell.rows[2]);
}

//! Expects that a quantity, summed over rows and weighted by their ground,
//! equals its sum over components.
void expect_rows_sum(const CanopyReport& report, const std::string& figure,
                     const std::vector<Randomised>& components) {
    const auto rows = measure_profile(figure + "_by_row", report);
    const auto strips = measure_profile(figure + "_of_strip", report);
    ASSERT_EQ(rows.size(), report.rows.size());
    for (std::size_t c = 0; c < components.size(); ++c) {
        double sum = 0, ground = 0;
        for (std::size_t row = 0; row < rows.size(); ++row) {
            if (report.rows[row].component != c) continue;
            const double share = report.rows[row].ground / report.ground_area;
            sum += share * rows[row].estimate.mean;
            ground += share;
        }
        EXPECT_NEAR(sum, components[c].estimate.mean, 1e-9) << figure << c;
        EXPECT_NEAR(strips[c].estimate.mean * ground, sum, 1e-9) << figure << c;
        EXPECT_GT(strips[c].estimate.standard_error, 0);
        EXPECT_LT(strips[c].estimate.standard_error,
                  .2 * std::abs(strips[c].estimate.mean));
    }
}

const std::vector<std::string> strip{
    "spacing=[{row=0.44, plant=0.15, row_direction=0}]",
    "field={rows=5, plants=4, jitter=10, row_pattern=[0.4, 0.6, 0.3, 0.3, "
    "0.6]}",
    "component=[{name=\"soybean\", crop=\"crops/soybean.toml\", plants=6, "
    "jitter=180, rows=[3, 4, 5]}]"};

//! A soybean row between two soybean rows is shaded least by maize; each maize
//! row has soybean on one side.
TEST_F(RowsOfMixtures, AreReportedPerNearestGround) {
    const CanopyReport report = evaluated(strip);
    ASSERT_EQ(report.rows.size(), 5u);
    const std::vector<double> widths{.5, .5, .45, .3, .45};
    for (std::size_t row = 0; row < 5; ++row) {
        EXPECT_NEAR(report.rows[row].width, widths[row], 1e-9) << row;
        EXPECT_EQ(report.rows[row].component, row < 2 ? 0u : 1u) << row;
    }
    for (const char* name :
         {"gross_assimilation", "net_assimilation", "carbon_balance"})
        expect_rows_sum(report, name, measure_parts(name, report));
    expect_rows_sum(report, "absorbed_light",
                    measure_parts("absorbed_par", report));
    const auto lai = measure_profile("lai_by_row", report);
    EXPECT_NEAR(lai[3].estimate.mean, 1.5 * lai[2].estimate.mean,
                .05 * lai[3].estimate.mean);
    const auto net = measure_profile("net_assimilation_by_row", report);
    EXPECT_GT(net[0].estimate.mean, 4 * net[2].estimate.mean);
    EXPECT_GT(net[3].estimate.mean, net[2].estimate.mean);
    EXPECT_GT(net[3].estimate.mean, net[4].estimate.mean);
}

TEST_F(RowsOfMixtures, AreReportedWithoutAssimilationToo) {
    std::vector<std::string> settings = strip;
    settings.push_back(nir);
    CanopyRequest request = requested(settings);
    const CanopyReport with = evaluate(request, device);
    for (Component& each : request.scene.components)
        each.photosynthesis.reset();
    const CanopyReport without = evaluate(request, device);
    EXPECT_FALSE(without.assimilation);
    ASSERT_EQ(without.rows.size(), 5u);
    for (std::size_t row = 0; row < 5; ++row) {
        EXPECT_NEAR(without.rows[row].lai, with.rows[row].lai, 1e-9);
        for (std::size_t b = 0; b < 2; ++b)
            expect_equal(without.bands[b].rows[row], with.bands[b].rows[row],
                         "light of rows");
    }
    EXPECT_EQ(measure_profile("absorbed_light_by_row", without).size(), 10u);
}

//! Rows of equal plants give equal results, even if each row is a component.
TEST_F(RowsOfMixtures, RowsOfOneCropAssimilateTheSame) {
    std::vector<std::string> settings = alike;
    settings.push_back(weed);
    const CanopyReport report = evaluated(settings);
    ASSERT_EQ(report.rows.size(), 4u);
    const auto net = measure_profile("net_assimilation_by_row", report);
    const double mean = number("net_assimilation", report).mean;
    for (const Randomised& row : net)
        EXPECT_NEAR(row.estimate.mean / mean, 1, .1);
    EXPECT_TRUE(evaluated(alike).rows.empty());
    settings.back() =
        "component=[{name=\"weed\", crop=\"crops/maize.toml\", mixed=8}]";
    EXPECT_TRUE(evaluated(settings).rows.empty());
}

}  // namespace
}  // namespace ideotype
