// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "season_numbers.hpp"

namespace ideotype {
namespace {

//! Returns growing_season with other settings, for one year and until 10
//! September, before plants are mature.
Campaign growing(std::vector<std::string> settings = {}) {
    settings.insert(settings.end(),
                    {"objective.over=[]", "light.tolerance=0",
                     "light.paths=256", "field.rows=2", "field.plants=2",
                     "field.variation.missing=0", "field.variation.late=0"});
    std::string text =
        read_campaign(std::string(IDEOTYPE_CAMPAIGNS) + "/growing_season.toml")
            .source;
    const std::size_t second = text.find("[[climate]]\nname = \"2012\"");
    text.erase(second, text.find("[[spacing]]") - second);
    const auto replace = [&](const std::string& what, const std::string& by) {
        text.replace(text.find(what), what.size(), by);
    };
    replace("from = 2011-05-01", "from = 2011-05-15");
    replace("to = 2011-09-30", "to = 2011-09-10");
    return read_campaign_text(
        text, std::string(IDEOTYPE_CAMPAIGNS) + "/growing.toml", settings);
}

TEST(GrowingSeason,
     AStageOfFullyGreenPlantsEqualsTheCropWithoutGrowthBitForBit) {
    Campaign grown = growing({"light.stages=1"});
    grown.crop.growth->leaves = 11;
    grown.crop.growth->maturity = 1e4;
    grown.crop.growth->lower_death = grown.crop.growth->upper_death = 1e4;
    // Roots and ears affect only plants that grow.
    grown.crop.growth->root_share = grown.crop.growth->ear_maintenance = 0;
    for (Organ& organ : grown.crop.baseline.organs) organ.senescence = 0;
    Campaign plain = grown;
    plain.spec.climates.front().value.emergence = {0, 1, 1};
    ASSERT_EQ(cases(grown).at(0).stages.size(), 1u);
    ASSERT_TRUE(cases(plain).at(0).stages.empty());
    const auto a = numbers(grown), b = numbers(plain);
    std::size_t compared = 0;
    for (const auto& [name, number] : a) {
        // Organs are paid for when they are built, not in equal daily amounts.
        if (name == "carbon_balance_0" || name.starts_with("carbon_loss") ||
            name.starts_with("dry_mass_by") || !b.contains(name))
            continue;
        EXPECT_EQ(number, b.at(name)) << name;
        ++compared;
    }
    EXPECT_GT(compared, 200u);
    EXPECT_NE(a.at("carbon_balance_0"), b.at("carbon_balance_0"));
    EXPECT_EQ(season_of(grown).randomisations.size(),
              season_of(plain).randomisations.size());
}

TEST(GrowingSeason, WeightsOfStagesSumToOneInEachHour) {
    const Campaign campaign = growing();
    Case chosen = cases(campaign).at(0);
    ASSERT_EQ(chosen.stages.size(), 10u);
    std::map<std::pair<Date, double>, double> seconds;
    double share = 0, before = -1;
    for (const Case& stage_case : chosen.stages) {
        const LightSeries series = light_of(campaign, stage_case);
        EXPECT_TRUE(series.grows);
        EXPECT_EQ(series.days, 119);
        for (const TimeStep& step : series.steps)
            seconds[{step.date, step.hour}] += step.seconds;
        share += stage_case.stage->share;
        EXPECT_GT(stage_case.stage->day, before);
        before = stage_case.stage->day;
    }
    EXPECT_NEAR(share, 1, 1e-12);
    EXPECT_EQ(seconds.size(), 119u * 24u);
    for (const auto& [hour, sum] : seconds) EXPECT_NEAR(sum, 3600, 1e-6);
}

TEST(GrowingSeason, AmountsAreSumsOverStagesAndFractionsAreOfIncidentLight) {
    const Campaign campaign = growing({"light.stages=4"});
    const auto values = numbers(campaign);
    Case whole = cases(campaign).at(0);
    whole.stages.clear();
    EXPECT_NEAR(values.at("incident_0"),
                light_of(campaign, whole).incident() / 1e6, 1e-9);
    EXPECT_NEAR(values.at("absorbed_fraction_0"),
                values.at("absorbed_par_0") / values.at("incident_0"), 1e-12);
    double leaves = 0;
    for (int i = 0; values.contains(fmt::format("assimilation_by_leaf_{}", i));
         ++i)
        leaves += values.at(fmt::format("assimilation_by_leaf_{}", i));
    EXPECT_NEAR(values.at("light_use_efficiency_0"),
                12.011 * leaves / values.at("absorbed_par_0"), 1e-9);
    double days = 0;
    for (std::size_t d = 0; d < 119; ++d)
        days += values.at("assimilation_by_day_" + std::to_string(d));
    EXPECT_NEAR(days / 119, values.at("gross_assimilation_0"), 1e-9);
    EXPECT_GT(values.at("carbon_after_silking_0"), 0);
    EXPECT_LT(values.at("carbon_after_silking_0"),
              values.at("gross_assimilation_0"));
    EXPECT_GT(values.at("dead_area_index_by_stage_3"), 0.5);
    EXPECT_LT(values.at("lai_by_stage_0"), 0.01);
}

TEST(GrowingSeason, RatiosAreThoseOfSumsOverStages) {
    const Campaign campaign = growing({"light.stages=4", "water={}"});
    const auto values = numbers(campaign);
    EXPECT_NEAR(
        values.at("water_use_efficiency_0"),
        12.011 * values.at("net_assimilation_0") / values.at("transpiration_0"),
        1e-9);
    EXPECT_NEAR(values.at("absorbed_par_per_leaf_area_0"),
                values.at("absorbed_par_0") / values.at("lai_0"), 1e-9);
    EXPECT_NEAR(values.at("net_assimilation_per_leaf_area_0"),
                values.at("net_assimilation_0") / values.at("lai_0"), 1e-9);
}

TEST(GrowingSeason, DryMatterAccountsForAllCarbonThatIsNotRespired) {
    const auto values = numbers(growing({"light.stages=4"}));
    const double growth =
        values.at("gross_assimilation_0") - values.at("respiration_0");
    EXPECT_NEAR(values.at("dry_matter_0"), 119 * .201 * growth, 1e-9);
    // The carbon of structures is included.
    const auto sum_of = [&](const char* name) {
        double sum = 0;
        for (int i = 0; values.contains(fmt::format("{}_{}", name, i)); ++i)
            sum += values.at(fmt::format("{}_{}", name, i));
        return sum;
    };
    EXPECT_GT(sum_of("dry_mass_by_organ"), 0.2 * values.at("dry_matter_0"));
    EXPECT_LT(sum_of("dry_mass_by_organ"), 0.6 * values.at("dry_matter_0"));
    // Young plants lack organs; each organ counts from the stage at which it
    // appears.
    EXPECT_NEAR(sum_of("assimilation_by_organ"),
                values.at("gross_assimilation_0"), 1e-9);
    EXPECT_NEAR(
        sum_of("carbon_loss_by_organ"),
        values.at("gross_assimilation_0") - values.at("carbon_balance_0"),
        1e-9);
}

TEST(GrowingSeason, RootsAndEarsRespireWithoutEffectOnGrossAssimilation) {
    Campaign campaign = growing({"light.stages=4"});
    Growth& growth = *campaign.crop.growth;
    const double root_share = growth.root_share,
                 ear_maintenance = growth.ear_maintenance;
    EXPECT_GT(root_share, 0);
    EXPECT_GT(ear_maintenance, 0);
    growth.root_share = growth.ear_maintenance = 0;
    const auto none = numbers(campaign);
    growth.root_share = root_share;
    const auto roots = numbers(campaign);
    growth.root_share = 0;
    growth.ear_maintenance = ear_maintenance;
    const auto ears = numbers(campaign);
    const auto more = [&](const auto& other, const char* name) {
        return other.at(name) - none.at(name);
    };
    for (const auto* with : {&roots, &ears}) {
        EXPECT_EQ(more(*with, "gross_assimilation_0"), 0);
        EXPECT_GT(more(*with, "respiration_0"), 0);
        EXPECT_LT(more(*with, "carbon_after_silking_0"), 0);
    }
    // Of these organs only roots cost carbon for construction.
    EXPECT_LT(more(roots, "carbon_balance_0"),
              -1.1 * more(roots, "respiration_0"));
    EXPECT_NEAR(more(ears, "carbon_balance_0"), -more(ears, "respiration_0"),
                1e-9);
    EXPECT_NEAR(more(ears, "carbon_after_silking_0"),
                -more(ears, "respiration_0"), 1e-9);
    const double share =
        more(ears, "respiration_0") / none.at("carbon_after_silking_0");
    EXPECT_GT(share, 0.05);
    EXPECT_LT(share, 0.3);
}

//! The respiration of ears agrees with that of an ear mass integrated hour by
//! hour from assimilation.
TEST(GrowingSeason, EarsRespireLikeAMassIntegratedHourByHour) {
    const Campaign campaign = growing();
    const Growth& growth = *campaign.crop.growth;
    Case chosen = cases(campaign).at(0);
    double expected = 0, light = 0;
    for (const Case& stage_case : chosen.stages)
        for (const TimeStep& step : light_of(campaign, stage_case).steps) {
            const double part =
                step.seconds * (step.par.beam + step.par.diffuse);
            expected += part * stage_case.stage->ear_shares.at(0);
            light += part;
        }
    EXPECT_EQ(chosen.stages.front().stage->ear_shares.at(0), 0);
    chosen.stages.clear();
    double time = 0, mass = 0, respired = 0;
    for (const TimeStep& step : light_of(campaign, chosen).steps) {
        const double warmth =
            daily_thermal_time(growth, std::array{*step.temperature}) *
            step.seconds / 86400;
        const double now = time + warmth / 2;
        time += warmth;
        if (now <= silking_time(growth)) continue;
        // 1 kg of CH2O yields 0.67 kg of dry matter.
        const double lost = mass * .67 * growth.ear_maintenance *
                            maintenance_factor(growth, now) *
                            std::exp2((*step.temperature - 25) / 10) *
                            step.seconds / 86400;
        respired += lost;
        mass += step.seconds * (step.par.beam + step.par.diffuse) - lost;
    }
    EXPECT_NEAR(expected, respired, 0.002 * respired);
    EXPECT_GT(respired, 0.02 * light);
}

//! Each leaf is built and paid for once, so that the costs correspond to all
//! leaf area that ever existed.
TEST(GrowingSeason, ConstructionOfLeavesIsChargedOnce) {
    const Campaign campaign = growing();
    const Plant plant =
        complete_plant(*campaign.crop.growth, campaign.crop.baseline);
    const double area =
        plant_area(build_plant(plant, campaign.spec.plant.tessellation)).leaves;
    double built = 0;
    const Case chosen = cases(campaign).at(0);
    for (const Case& stage_case : chosen.stages) {
        const Scene scene = scene_of(campaign, stage_case);
        for (const double leaf : scene.components.front().built) built += leaf;
    }
    EXPECT_NEAR(built, area, 1e-9);
}

TEST(GrowingSeason, StripsThatEmergeLaterGainLessCarbon) {
    const Campaign campaign = read_campaign_text(
        growing().source +
            "[[component]]\nname = \"relay\"\nrows = [3, 4]\nlater = 40\n"
            "crop = \"crops/maize_hybrid.toml\"\n",
        std::string(IDEOTYPE_CAMPAIGNS) + "/relay.toml",
        {"objective.over=[]", "light.tolerance=0", "light.paths=256",
         "light.stages=4", "field.rows=4"});
    const Case chosen = cases(campaign).at(0);
    EXPECT_LT(chosen.stages[0].stage->ages[1], 0);
    EXPECT_GT(chosen.stages[3].stage->ages[1], 100);
    const auto values = numbers(campaign);
    EXPECT_LT(values.at("carbon_balance_by_component_1"),
              0.8 * values.at("carbon_balance_by_component_0"));
    // The component has not yet assimilated the carbon that its stalk costs.
    EXPECT_LT(values.at("carbon_balance_by_component_1"), 0);
    EXPECT_GT(values.at("net_assimilation_by_component_1"), 0);
}

//! Returns the first leaf of a component in a scene of a campaign.
const LeafRates& first_leaf(const Scene& scene, std::size_t component) {
    return scene.components.at(component).photosynthesis->rates.front();
}

double gross_in_full_light(const LeafRates& leaf) {
    const std::array light{2000.};
    double rate = 0;
    gross(response(leaf, {}), light, &rate);
    return rate;
}

TEST(GrowingSeason, LeavesOfEachStageHaveTheCapacityOfTheirAge) {
    const std::string relay =
        "[[component]]\nname = \"relay\"\nrows = [3, 4]\nlater = 15\n"
        "crop = \"crops/maize_hybrid.toml\"\n";
    for (const char* model : {"hyperbola", "collatz", "farquhar"}) {
        const Campaign ageing = read_campaign_text(
            growing().source + relay,
            std::string(IDEOTYPE_CAMPAIGNS) + "/relay.toml",
            {"objective.over=[]", "light.paths=256", "field.rows=4",
             fmt::format("photosynthesis.model=\"{}\"", model)});
        Campaign young = ageing;
        young.crop.growth->ageing =
            young.components[0].crop.growth->ageing = {1};
        const Case chosen = cases(ageing).at(0);
        for (const Case& stage_case : chosen.stages) {
            const Scene scene = scene_of(ageing, stage_case);
            const Scene like = scene_of(young, stage_case);
            for (const std::size_t c : {0u, 1u}) {
                const double factor = capacity_factor(
                    *growth_of(ageing, c), stage_case.stage->ages[c]);
                const LeafRates expected = scaled(first_leaf(like, c), factor);
                EXPECT_EQ(gross_in_full_light(first_leaf(scene, c)),
                          gross_in_full_light(expected))
                    << model << ' ' << stage_case.stage->at;
                EXPECT_EQ(dark_respiration(first_leaf(scene, c), 30),
                          dark_respiration(expected, 30));
            }
        }
        // At the last stage this crop is older than the plants of the relay
        // crop.
        const Scene last = scene_of(ageing, chosen.stages.back());
        EXPECT_LT(gross_in_full_light(first_leaf(last, 0)),
                  0.99 * gross_in_full_light(first_leaf(last, 1)))
            << model;
    }
}

TEST(GrowingSeason, StagesFollowTheDeclineOfCapacity) {
    Campaign campaign = growing({"light.stages=8"});
    const double last = maturity_time(*campaign.crop.growth);
    const auto times = [&] {
        std::vector<double> values;
        for (const StageTime& each : stage_times(campaign, 1 / 7.5, last))
            values.push_back(each.at);
        return values;
    };
    //! Returns the largest error of capacity if it is interpolated linearly
    //! between stages.
    const auto error = [&](const std::vector<double>& stages) {
        const Growth& growth = *campaign.crop.growth;
        double largest = 0;
        for (std::size_t k = 1; k < stages.size(); ++k)
            for (const double share : {0.25, 0.5, 0.75})
                largest = std::max(
                    largest,
                    std::abs(
                        capacity_factor(growth, std::lerp(stages[k - 1],
                                                          stages[k], share)) -
                        std::lerp(capacity_factor(growth, stages[k - 1]),
                                  capacity_factor(growth, stages[k]), share)));
        return largest;
    };
    const std::vector<double> aware = times();
    const Growth ageing = *campaign.crop.growth;
    campaign.crop.growth->ageing = {1};
    const std::vector<double> unaware = times();
    campaign.crop.growth = ageing;
    EXPECT_LT(error(aware), 0.07);
    EXPECT_GT(error(unaware), error(aware));
}

TEST(GrowingSeason, AgeingLowersCarbonButNotLight) {
    for (const char* model : {"hyperbola", "collatz", "farquhar"}) {
        Campaign campaign =
            growing({"light.stages=4",
                     fmt::format("photosynthesis.model=\"{}\"", model)});
        campaign.crop.growth->ageing = {1};
        const auto young = numbers(campaign);
        // Leaves without capacity cause no error.
        campaign.crop.growth->maturity = 400;
        campaign.crop.growth->ageing = {1, 0};
        const auto old = numbers(campaign);
        EXPECT_LT(old.at("gross_assimilation_0"),
                  0.9 * young.at("gross_assimilation_0"));
        EXPECT_LT(old.at("respiration_0"), young.at("respiration_0"));
        for (const auto& [name, value] : old)
            EXPECT_TRUE(std::isfinite(value)) << model << ' ' << name;
    }
}

TEST(GrowingSeason, PlantsThatDoNotGrowHaveTheCapacityOfTheirStage) {
    Campaign plain = growing();
    plain.spec.climates.front().value.emergence = {0, 1, 1};
    for (Organ& organ : plain.crop.baseline.organs) organ.senescence = 0;
    const Case chosen = cases(plain).at(0);
    ASSERT_TRUE(chosen.stages.empty());
    const auto rate = [&] {
        return gross_in_full_light(first_leaf(scene_of(plain, chosen), 0));
    };
    const auto at_silking = numbers(plain);
    const double full = rate();
    plain.spec.plant.stage = 1.75;
    EXPECT_LT(rate(), 0.75 * full);
    const auto aged = numbers(plain);
    EXPECT_LT(aged.at("gross_assimilation_0"),
              0.95 * at_silking.at("gross_assimilation_0"));
    for (const char* light : {"absorbed_par_0", "lai_0", "fapar_0"})
        EXPECT_EQ(aged.at(light), at_silking.at(light)) << light;
    plain.crop.growth->ageing = plain.crop.growth->maintenance = {1};
    EXPECT_EQ(rate(), full);
    EXPECT_EQ(numbers(plain), at_silking);
}

TEST(GrowingSeason, AStageOfPlantsThatGrowIsAnError) {
    EXPECT_THROW(growing({"plant.stage=1.5"}), InputError);
    const Campaign hybrid =
        read_campaign(IDEOTYPE_CAMPAIGNS "/ames_quick.toml",
                      {"plant.baseline=\"crops/maize_hybrid.toml\"",
                       "plant.bounds=\"traits\"", "plant.stage=1.5"});
    EXPECT_EQ(hybrid.spec.plant.stage, 1.5);
    EXPECT_EQ(parse_campaign(hybrid.resolved, "again.toml").spec.plant.stage,
              1.5);
    EXPECT_TRUE(hybrid.warnings.empty());
    // The capacity of leaves that do not age is constant over all stages.
    const Campaign line = read_campaign(IDEOTYPE_CAMPAIGNS "/ames_quick.toml",
                                        {"plant.stage=1.5"});
    ASSERT_EQ(line.warnings.size(), 1u);
    EXPECT_TRUE(line.warnings[0].what.starts_with("plant.stage is 1.5 (no "));
}

TEST(GrowingSeason, AClimateThatPlantsCannotGrowInIsAnError) {
    const auto message = [](const std::vector<std::string>& settings) {
        try {
            growing(settings);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_NE(message({"plant.baseline=\"crops/maize.toml\""})
                  .find("the crop file has no growth parameters"),
              std::string::npos);
    Campaign campaign = growing();
    EXPECT_NE(std::find_if(campaign.warnings.begin(), campaign.warnings.end(),
                           [](const Problem& warning) {
                               return warning.what.find("are not mature") !=
                                      std::string::npos;
                           }),
              campaign.warnings.end());
    // Here the numbers of photons equal those of global light, and the values
    // of wind are far smaller.
    for (const auto& [column, warnings] :
         {std::pair("ppfd_umol", 1u), std::pair("wind_m_s", 2u)}) {
        std::string text = campaign.source;
        text.insert(
            text.find("temperature = "),
            "ppfd = [\"" + std::string(column) + "\", \"umol/m2/s\"]\n");
        EXPECT_EQ(
            read_campaign_text(
                text, std::string(IDEOTYPE_CAMPAIGNS) + "/photons.toml",
                {"objective.over=[]", "light.tolerance=0", "light.paths=256"})
                .warnings.size(),
            warnings + growing().warnings.size() - 1)
            << column;
    }
    // Reading the resolved campaign yields the same resolved text.
    EXPECT_EQ(parse_campaign(campaign.resolved, "resolved.toml").resolved,
              campaign.resolved);
}

}  // namespace
}  // namespace ideotype
