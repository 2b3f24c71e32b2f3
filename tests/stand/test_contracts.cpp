// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "contracts.hpp"
#include "stand/across_scenarios.hpp"
#include "stand/stand.hpp"

namespace ideotype {

namespace {

struct Quick {
    explicit Quick(const std::string& name)
        : campaign(read_campaign(std::string(IDEOTYPE_CAMPAIGNS) + "/" + name)),
          chosen(cases(campaign).at(0)),
          scene(scene_of(campaign, evaluated_cases(chosen).at(0))) {}

    void request(const Case& in, const Plants& plants) const {
        request_of({}, campaign, in, scene, plants);
    }

    Campaign campaign;
    Case chosen;
    Scene scene;
};

}  // namespace

TEST(Contracts, OfStandsAreNoticed) {
    const Quick day("ames_quick.toml"), season("growing_season.toml");
    const Plant& plant = day.campaign.crop.baseline;
    const Case grown = scenarios(season.chosen).at(0);
    Case idle = grown.stages.at(0);
    idle.stage->share = 0;
    expect_noticed({
        {"!plants.empty() && plants.size() <= scene.components.size()",
         [&] { day.request(day.chosen, {}); }},
        {"!plants.empty() && plants.size() <= scene.components.size()",
         [&] {
             day.request(day.chosen, {plant, plant});
         }},
        {"stage.share > 0",
         [&] { season.request(idle, {season.campaign.crop.baseline}); }},
        {"ground_per_plant > 0", [] { lai_of_line({}, 0); }},
        {"!campaign.sole.empty()",
         [&] { land_equivalent_ratio(day.campaign, {}); }},
        {"each.size() == std::reduce(stages_.begin(), stages_.end())",
         [&] { AcrossScenarios(day.campaign, day.chosen).combine({}); }},
        {"each.size() == times_.size()",
         [&] { OverStages(season.campaign, grown).combine({}); }},
    });
}

}  // namespace ideotype
