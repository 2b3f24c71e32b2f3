// SPDX-License-Identifier: Apache-2.0
// Stands of plants that respond to density, or to the light on young leaves.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "season_numbers.hpp"
#include "stand/light_cue.hpp"

namespace ideotype {
namespace {

constexpr double reference = 8;

//! Returns the quickstart's field with plants of exact positions.
Campaign still(const std::string& file, std::vector<std::string> settings) {
    settings.insert(settings.end(),
                    {"light.tolerance=0", "light.paths=256", "field.rows=2",
                     "field.plants=2", "field.variation.missing=0",
                     "field.variation.late=0", "field.variation.position=0"});
    return read_campaign(std::string(IDEOTYPE_CAMPAIGNS) + "/" + file,
                         settings);
}

void set_plasticity(Plant& plant, Cue cue) {
    plant.plasticity = {};
    plant.plasticity.reference = reference;
    plant.plasticity.cue = cue;
    plant.plasticity.responses = {{{"leaf.width"}, {}, {-.3}, {}}};
}

std::vector<std::string> at(double density) {
    constexpr double row = 0.76;
    return {fmt::format("spacing.row={}", row),
            fmt::format("spacing.plant={}", 1 / (row * density))};
}

TEST(PlasticStand, RespondsToTheDensityOfItsCase) {
    for (const double density : {4., reference, 16.}) {
        Campaign campaign = still("quickstart.toml", at(density));
        const Plant rigid = campaign.crop.baseline;
        set_plasticity(campaign.crop.baseline, Cue::density);
        const Case chosen = cases(campaign).at(0);
        const CanopyRequest request =
            request_of({{256, 4}, {1}}, campaign, chosen,
                       scene_of(campaign, chosen), {campaign.crop.baseline});
        const Component& component = request.scene.components.at(0);
        const double d = density / reference;
        EXPECT_NEAR(component.plant->leaves[3].width,
                    rigid.leaves[3].width * std::pow(d, -.3), 1e-9);
        EXPECT_EQ(component.at_reference->leaves[3].width,
                  rigid.leaves[3].width)
            << "measured lines are compared with the plant of the genome";
    }
}

TEST(PlasticStand, LeafAreaOfAConstraintIsThatAtTheDensityOfTheCase) {
    Campaign campaign = still("quickstart.toml", at(16));
    const auto lai = [&] {
        const auto all = numbers(campaign);
        return all.at("lai_0");
    };
    const double rigid = lai();
    set_plasticity(campaign.crop.baseline, Cue::density);
    EXPECT_NEAR(lai() / rigid, std::pow(2, -.3), .01);
}

//! Returns a growing season with plants that respond to light.
Campaign growing(double density) {
    Campaign campaign =
        still("growing_season.toml",
              {"spacing.row=0.76", fmt::format("spacing.density={}", density),
               "objective.over=[]", "light.stages=6", "field.rows=4",
               "field.plants=4"});
    set_plasticity(campaign.crop.baseline, Cue::light);
    return campaign;
}

//! Returns the width of each leaf at the last stage, relative to that of the
//! baseline.
std::vector<double> last_widths(const Campaign& campaign) {
    const std::vector<Case> stages = evaluated_cases(cases(campaign).at(0));
    const Device device(Device::supported_isas().back());
    LightCue cue(campaign, stages);
    EXPECT_TRUE(cue.is_any());
    cue.prepare(device);
    LightCue::Response response(cue);
    std::vector<double> widths;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        CanopyRequest request =
            request_of({{1024, 8, 0, 8}, {1}}, campaign, stages[i],
                       scene_of(campaign, stages[i]), {campaign.crop.baseline});
        response.set_plants(i, {campaign.crop.baseline}, request.scene);
        response.observe(i, request.scene, evaluate(request, device));
        const Plant& plant = *request.scene.components[0].full_grown;
        widths.clear();
        for (std::size_t leaf = 0; leaf < plant.leaves.size(); ++leaf)
            widths.push_back(plant.leaves[leaf].width /
                             campaign.crop.baseline.leaves[leaf].width);
    }
    return widths;
}

TEST(PlasticStand, LightOnYoungLeavesActsAsTheDensityWithTheSameLight) {
    const std::vector<double> at_reference = last_widths(growing(reference)),
                              dense = last_widths(growing(14)),
                              sparse = last_widths(growing(5));
    const std::size_t leaves = at_reference.size();
    for (std::size_t leaf = leaves / 2; leaf < leaves; ++leaf) {
        EXPECT_NEAR(at_reference[leaf], 1, .05) << leaf;
        EXPECT_NEAR(dense[leaf], std::pow(14 / reference, -.3), .06) << leaf;
        EXPECT_NEAR(sparse[leaf], std::pow(5 / reference, -.3), .06) << leaf;
    }
}

TEST(PlasticStand, ShadeOfPanelsActsAsDensity) {
    Campaign campaign = growing(reference);
    const std::vector<double> open = last_widths(campaign);
    PanelRows half_of_the_sky;
    half_of_the_sky.height = 4;
    half_of_the_sky.width = 1.5;
    campaign.spec.panels = {{half_of_the_sky}};
    const std::vector<double> below = last_widths(campaign);
    for (std::size_t leaf = open.size() / 2; leaf < open.size(); ++leaf)
        EXPECT_LT(below[leaf], open[leaf] - .05) << leaf;
}

TEST(PlasticStand, LightIsNoCueForPlantsThatDoNotGrow) {
    Campaign campaign = still("quickstart.toml", at(16));
    set_plasticity(campaign.crop.baseline, Cue::light);
    const auto by_light = numbers(campaign);
    campaign.crop.baseline.plasticity.cue = Cue::density;
    EXPECT_EQ(by_light, numbers(campaign));
}

}  // namespace
}  // namespace ideotype
