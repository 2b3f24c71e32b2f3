// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "run/evaluator.hpp"

namespace ideotype {
namespace {

class Ames : public ::testing::Test {
  protected:
    const Campaign campaign =
        read_campaign(std::string(IDEOTYPE_CAMPAIGNS) + "/ames_quick.toml");
    const Cases campaign_cases = cases(campaign);
    const Genome baseline = baseline_genome(campaign);
    CanopyEvaluator evaluator{campaign, Device::supported_isas().back()};

    const OutcomeSchema schema =
        outcome_schema(campaign, campaign_cases[0], campaign.sampling);

    double quantity(const Outcome& outcome, const std::string& name) const {
        return find(schema, outcome, name).value().mean;
    }
};

TEST_F(Ames, TheBaselineAbsorbsAsMuchAsASparseReference) {
    Task task;
    task.is_final = true;
    const Outcome outcome = evaluator.evaluate(task, baseline);
    // In a stand similar to B73, leaves and stalks absorb about 0.93 of the
    // light.
    const double leaves = quantity(outcome, "absorbed_fraction");
    const double stalks = quantity(outcome, "stalk_fraction");
    EXPECT_NEAR(leaves + stalks, .93, .015);
    EXPECT_NEAR(quantity(outcome, "lai"), 3.44, .03);
    // Expected value: pvlib, as in tests/climate/test_day.cpp.
    EXPECT_NEAR(quantity(outcome, "incident"), 12.07745, 1e-4 * 12.07745);
    EXPECT_LT(outcome.objectives[0].standard_error,
              .002 * outcome.objectives[0].mean);
}

TEST_F(Ames, FractionsSumToOneAndLeavesToTheTotal) {
    const Outcome outcome = evaluator.evaluate({}, baseline);
    EXPECT_NEAR(quantity(outcome, "absorbed_fraction") +
                    quantity(outcome, "stalk_fraction") +
                    quantity(outcome, "soil_fraction") +
                    quantity(outcome, "reflected_fraction"),
                1, 1e-12);
    EXPECT_LT(quantity(outcome, "balance_error"), 1e-12);
    double sum = 0;
    const std::size_t first = schema.measured.offset("absorbed_by_leaf");
    for (std::size_t leaf = 0; leaf < 10; ++leaf)
        sum += outcome.quantities[first + leaf].mean;
    EXPECT_NEAR(sum / outcome.objectives[0].mean, 1, 1e-12);
}

TEST_F(Ames, ExtinctionFollowsFromTheLightTransmittedByAllOrgans) {
    const Outcome outcome = evaluator.evaluate({}, baseline);
    const Estimate fapar = find(schema, outcome, "fapar").value();
    EXPECT_NEAR(fapar.mean,
                quantity(outcome, "absorbed_fraction") +
                    quantity(outcome, "stalk_fraction"),
                1e-12);
    const Estimate k = find(schema, outcome, "extinction_coefficient").value();
    const double lai = quantity(outcome, "lai");
    EXPECT_NEAR(std::exp(-k.mean * lai), 1 - fapar.mean, 1e-12);
    // The delta method must agree with finite differences.
    const auto at = [&](double f) { return -std::log(1 - f) / lai; };
    EXPECT_NEAR((at(fapar.mean + 1e-6) - at(fapar.mean - 1e-6)) / 2e-6 *
                    fapar.standard_error / k.standard_error,
                1, 1e-6);
    Campaign plot = campaign;
    plot.spec.field.boundary = Boundary::isolated;
    EXPECT_FALSE(outcome_schema(plot, campaign_cases[0], plot.sampling)
                     .measured.has("extinction_coefficient"));
}

TEST_F(Ames, CandidatesOfAGenerationHaveCommonRandomNumbers) {
    Task first, second, later;
    second.slot = 17;
    later.generation = 1;
    const double a = evaluator.evaluate(first, baseline).objectives[0].mean;
    EXPECT_EQ(evaluator.evaluate(second, baseline).objectives[0].mean, a);
    EXPECT_NE(evaluator.evaluate(later, baseline).objectives[0].mean, a);
}

TEST_F(Ames, TheElitePlantAbsorbsMoreThanTheBaseline) {
    const Device device(Device::supported_isas().back());
    const auto absorbed = [&](const Plant& plant) {
        return evaluate(
                   request_of(sampling_of(Task{}, campaign, campaign_cases[0]),
                              campaign, campaign_cases[0],
                              scene_of(campaign, campaign_cases[0]), {plant}),
                   device)
            .par()
            .light.day.leaves;
    };
    const Estimate b = absorbed(campaign.crop.baseline);
    const Estimate e = absorbed(
        read_crop(std::string(IDEOTYPE_CAMPAIGNS) + "/plants/elite.toml")
            .baseline);
    EXPECT_GT(e.mean - b.mean,
              4 * std::hypot(b.standard_error, e.standard_error));
}

TEST_F(Ames, AToleranceIsMetAndTheRowStatesItsPaths) {
    Campaign exact = campaign;
    exact.sampling = {1 << 14, 16, 2e-3};
    CanopyEvaluator to_tolerance(exact, Device::supported_isas().back());
    const Outcome met = to_tolerance.evaluate({}, baseline);
    // The standard error from 16 randomisations is accurate to about 20 %, and
    // so are the trials that choose the number of paths.
    EXPECT_LE(met.objectives[0].standard_error,
              3.5e-3 * met.objectives[0].mean);
    EXPECT_GT(quantity(met, "paths"), 16 * 64);
    EXPECT_LT(quantity(met, "paths"), 16 * (1 << 14));
    EXPECT_EQ(quantity(met, "capped"), 0);

    exact.sampling.paths = 64;
    CanopyEvaluator hurried(exact, Device::supported_isas().back());
    const Outcome capped = hurried.evaluate({}, baseline);
    EXPECT_EQ(capped.status, Status::done);
    EXPECT_EQ(quantity(capped, "paths"), 16 * 64);
    EXPECT_EQ(quantity(capped, "capped"), 1);
}

TEST_F(Ames, ObjectivesAreTheMeansOfTheirRandomisations) {
    Task final;
    final.is_final = true;
    for (const Task& task : {Task{}, final}) {
        const Outcome outcome = evaluator.evaluate(task, baseline);
        ASSERT_EQ(outcome.randomisations.size(),
                  evaluator.schema(task).randomisations);
        const Estimate mean = estimate(outcome.randomisations);
        EXPECT_NEAR(mean.mean / outcome.objectives[0].mean, 1, 1e-12);
        EXPECT_NEAR(mean.standard_error / outcome.objectives[0].standard_error,
                    1, 1e-9);
    }
}

TEST_F(Ames, CommonRandomNumbersReduceTheErrorOfDifferences) {
    Genome other = baseline;
    other[0] *= 1.02;
    Task task;
    task.is_final = true;  // so that both use the same number of paths
    const Outcome a = evaluator.evaluate(task, baseline);
    const Outcome b = evaluator.evaluate(task, other);
    const double independent = std::hypot(a.objectives[0].standard_error,
                                          b.objectives[0].standard_error);
    EXPECT_GT(difference(a, b).standard_error, 0);
    EXPECT_LT(difference(a, b).standard_error, .5 * independent);
    EXPECT_EQ(difference(a, b).mean,
              b.objectives[0].mean - a.objectives[0].mean);
}

TEST_F(Ames, ViolationsDoNotAffectTheObjective) {
    const Outcome feasible = evaluator.evaluate({}, baseline);
    EXPECT_EQ(feasible.violation, 0);

    Campaign strict = campaign;
    strict.spec.constraints.lai = {1, 2};
    CanopyEvaluator strict_evaluator(strict, Device::supported_isas().back());
    const Outcome outcome = strict_evaluator.evaluate({}, baseline);
    EXPECT_EQ(outcome.objectives[0].mean, feasible.objectives[0].mean);
    EXPECT_NEAR(outcome.violation, (3.435 - 2) / 2, .01);
}

TEST_F(Ames, LightPerLeafAreaIsLightPerGroundAreaOverLai) {
    Campaign thrifty = campaign;
    thrifty.spec.objective.maximised = {"absorbed_par_per_leaf_area"};
    CanopyEvaluator other(thrifty, Device::supported_isas().back());
    const Outcome a = evaluator.evaluate({}, baseline);
    const Outcome b = other.evaluate({}, baseline);
    EXPECT_NEAR(b.objectives[0].mean * quantity(b, "lai"), a.objectives[0].mean,
                1e-9);
    EXPECT_EQ(outcome_schema(thrifty, campaign_cases[0], {}).objectives[0].name,
              "absorbed_par_per_leaf_area");
}

TEST_F(Ames, AssimilationIsReportedInMolInGramsAndPerLeafArea) {
    Campaign net = campaign;
    net.spec.objective.maximised = {"net_assimilation"};
    net.photosynthesis = Photosynthesis{};
    CanopyEvaluator other(net, Device::supported_isas().back());
    const Outcome outcome = other.evaluate({}, baseline);
    ASSERT_EQ(outcome.status, Status::done) << outcome.message;
    const OutcomeSchema changed_schema =
        outcome_schema(net, campaign_cases[0], net.sampling);
    const auto value = [&](const char* name) {
        return find(changed_schema, outcome, name).value();
    };
    constexpr double grams_of_co2 = 44.0095;
    for (const std::string kind : {"gross", "net"}) {
        const Estimate mol = value((kind + "_assimilation").c_str());
        const Estimate grams = value((kind + "_co2").c_str());
        EXPECT_GT(mol.mean, 0.5);
        EXPECT_NEAR(grams.mean / mol.mean, grams_of_co2, 1e-9);
        EXPECT_NEAR(grams.standard_error / mol.standard_error, grams_of_co2,
                    1e-9);
    }
    EXPECT_LT(value("net_co2").mean, value("gross_co2").mean);
    EXPECT_NEAR(
        value("net_assimilation_per_leaf_area").mean * value("lai").mean,
        value("net_assimilation").mean, 1e-12);
}

TEST_F(Ames, AnIsolatedPlotAbsorbsMoreLightThanItsGroundReceives) {
    Campaign alone = campaign;
    alone.spec.field.boundary = Boundary::isolated;
    alone.spec.field.border_rows = 1;
    CanopyEvaluator plot(alone, Device::supported_isas().back());
    const Outcome outcome = plot.evaluate({}, baseline);
    ASSERT_EQ(outcome.status, Status::done) << outcome.message;
    const OutcomeSchema changed_schema =
        outcome_schema(alone, campaign_cases[0], alone.sampling);
    EXPECT_GT(find(changed_schema, outcome, "absorbed_fraction")->mean, 1);
    EXPECT_LT(find(changed_schema, outcome, "balance_error")->mean, 1e-12);
}

TEST(Canopy, InThePolarNightAllQuantitiesAreZero) {
    Campaign campaign =
        read_campaign(std::string(IDEOTYPE_CAMPAIGNS) + "/ames_quick.toml");
    for (const double pole : {90., -90.}) {
        Case night = cases(campaign)[0];
        night.site.latitude = pole;
        night.day.dates = {{2025, pole > 0 ? 12 : 6, 21}};
        const Scene scene = scene_of(campaign, night);
        ASSERT_TRUE(scene.light().series.steps.empty());
        const Device device(Device::supported_isas().back());
        const Plant& baseline = campaign.crop.baseline;
        const Outcome outcome = checked_outcome(
            outcome_schema(campaign, night, campaign.sampling),
            to_outcome(campaign, night, baseline,
                       evaluate(request_of(sampling_of(Task{}, campaign, night),
                                           campaign, night, scene, {baseline}),
                                device)));
        EXPECT_EQ(outcome.status, Status::done) << outcome.message;
        EXPECT_EQ(outcome.objectives[0].mean, 0);
        EXPECT_EQ(outcome.objectives[0].standard_error, 0);
    }
}

class Study : public ::testing::Test {
  protected:
    static Campaign study(std::vector<std::string> settings = {}) {
        settings.push_back(
            "sensitivity.keys=[{key=\"optics.soil_albedo\", range=[0, 1]}, "
            "{key=\"spacing.row\", range=[0.5, 0.9]}]");
        return read_study(std::string(IDEOTYPE_CAMPAIGNS) + "/ames_quick.toml",
                          settings);
    }

    const Campaign campaign = study();
    CanopyEvaluator evaluator{campaign, Device::supported_isas().back()};
    Genome genome = baseline_genome(campaign);

    Outcome evaluated(CanopyEvaluator& by, std::uint32_t generation,
                      std::uint32_t slot, double albedo, double row) const {
        Genome of_row = genome;
        of_row.push_back(albedo);
        of_row.push_back(row);
        Task task;
        task.generation = generation;
        task.slot = slot;
        return by.evaluate(task, of_row);
    }
};

TEST_F(Study, KeysOfARowActLikeThoseOfACampaign) {
    const Campaign other = read_study(
        std::string(IDEOTYPE_CAMPAIGNS) + "/ames_quick.toml",
        {"optics.soil_albedo=0.4", "spacing.row=0.6", "spacing.name=762x152"});
    CanopyEvaluator of_other(other, Device::supported_isas().back());
    Task task;
    task.slot = 3;
    const Outcome is = evaluated(evaluator, 0, 3, 0.4, 0.6);
    const Outcome was = of_other.evaluate(task, genome);
    EXPECT_EQ(is.objectives[0].mean, was.objectives[0].mean);
    EXPECT_NE(is.objectives[0].mean,
              evaluated(evaluator, 0, 3, 0.1, 0.6).objectives[0].mean);
    EXPECT_NE(is.objectives[0].mean,
              evaluated(evaluator, 0, 3, 0.4, 0.7).objectives[0].mean);
}

//! Noise can be subtracted by means of standard errors only if these include
//! all noise: that of the light and, if a row has several fields, that of the
//! fields. Carbon losses of fields vary more if plants have more leaves.
TEST_F(Study, RowsHaveIndependentNoiseOfKnownSize) {
    for (const std::vector<std::string>& fields :
         {std::vector<std::string>{},
          {"light.fields=4", "light.tolerance=0.002", "field.rows=1",
           "field.plants=2", "field.variation={length=0.3, width=0.3}"},
          {"light.fields=4", "light.tolerance=0.005", "field.rows=2",
           "field.plants=2", "field.variation={missing=0.3}",
           "objective={maximise=\"carbon_balance\"}"},
          {"light.fields=4", "light.tolerance=0.005", "field.rows=4",
           "field.plants=4", "field.variation={missing=0.1}",
           "objective={maximise=\"net_assimilation_per_leaf_area\"}"},
          {"light.fields=4", "light.tolerance=0.005", "field.rows=2",
           "field.plants=2", "field.variation={missing=0.2}",
           "objective={maximise=\"extinction_coefficient\"}"},
          {"light.fields=4", "light.tolerance=0.008", "field.rows=2",
           "field.plants=2", "field.variation={missing=0.045, late=0.04}",
           "objective={maximise=\"net_assimilation\"}"},
          {"light.fields=4", "light.tolerance=0.008", "field.rows=2",
           "field.plants=2", "field.variation={missing=0.045, late=0.04}",
           "photosynthesis.leaf_days=400",
           "objective={maximise=\"carbon_balance\"}"}}) {
        const Campaign chosen = study(fields);
        CanopyEvaluator of_chosen(chosen, Device::supported_isas().back());
        std::vector<double> values;
        double squares = 0;
        constexpr std::uint32_t count = 60;
        for (std::uint32_t i = 0; i < count; ++i) {
            const Outcome row =
                evaluated(of_chosen, i / 20, i % 20, 0.1, 0.762);
            values.push_back(row.objectives[0].mean);
            squares += std::pow(row.objectives[0].standard_error, 2) / count;
        }
        const double variance =
            count * std::pow(estimate(values).standard_error, 2);
        // The tolerance combines the standard errors of a chi-squared variable
        // with 59 degrees of freedom and of the sum of 60 variables with 3.
        EXPECT_NEAR(variance / squares, 1,
                    3.5 * std::sqrt(2.0 / (count - 1) + 2.0 / (3 * count)))
            << fields.size();
        EXPECT_LT(std::sqrt(squares), 0.06 * values[0]);
    }
}

//! Keys of growth change the days of the season, and keys of leaves the layers
//! up to the highest leaf; rows have the same quantities nevertheless.
TEST(StudiesOfASeason, KeysOfGrowthAndOfLeavesHaveTheQuantitiesOfTheBaseline) {
    const Campaign season = read_study(
        std::string(IDEOTYPE_CAMPAIGNS) + "/growing_season.toml",
        {"objective={maximise=\"grain_yield\"}", "light.tolerance=0",
         "light.paths=64", "light.stages=4", "field.rows=1", "field.plants=1",
         "sensitivity.traits=false",
         ("sensitivity.keys=["
          "{key=\"plant.baseline.growth.maturity\", range=[700, 970]},"
          "{key=\"plant.baseline.grain.kernels\", range=[200, 600]},"
          "{key=\"plant.baseline.plasticity.reference\", range=[2, 20]}]")});
    CanopyEvaluator evaluator(season, Device::supported_isas().back());
    const Task task;
    const OutcomeSchema& schema = evaluator.schema(task);
    EXPECT_FALSE(schema.measured.has("grain_by_day"));
    const auto yield = [&](double maturity, double kernels, double reference) {
        Genome genome = baseline_genome(season);
        genome.insert(genome.end(), {maturity, kernels, reference});
        const Outcome outcome = evaluator.evaluate(task, genome);
        EXPECT_TRUE(has_form(schema, outcome));
        return outcome.objectives.at(0).mean;
    };
    const double usual = yield(970, 490, 7.5);
    EXPECT_GT(usual, yield(700, 490, 7.5));
    EXPECT_GT(usual, yield(970, 200, 7.5));
    EXPECT_NE(usual, yield(970, 490, 20));
    // Quantities by day stay if no key changes the season.
    const Campaign same = read_study(
        std::string(IDEOTYPE_CAMPAIGNS) + "/growing_season.toml",
        {"objective={maximise=\"grain_yield\"}",
         "sensitivity.keys=[{key=\"photosynthesis.rd\", range=[0.4, 1.2]}]"});
    EXPECT_TRUE(search_schema(same, cases(same)[0], same.sampling)
                    .measured.has("grain_by_day"));
}

//! Otherwise a stage of one row would have the fields of a stage of another
//! row, and the noise of rows would not be independent.
TEST(StudiesOfASeason, StagesOfDifferentRowsHaveDifferentRandomNumbers) {
    const Campaign season =
        read_study(std::string(IDEOTYPE_CAMPAIGNS) + "/growing_season.toml",
                   {"light.stages=5", "light.fields=4",
                    "light.randomisations=8", "sensitivity.samples=16"});
    const Case chosen = cases(season).at(0);
    std::set<std::uint32_t> randomisations;
    std::size_t count = 0;
    for (const Case& stage : chosen.scenarios.at(0).stages) {
        const Scene scene = scene_of(season, stage);
        Task task;
        for (task.slot = 0; task.slot < 20; ++task.slot) {
            const CanopyRequest request =
                request_of(sampling_of(task, season, stage), season, stage,
                           scene, {season.crop.baseline});
            for (int k = 0; k < request.accuracy.randomisations; ++k, ++count)
                randomisations.insert(request.randomness.first_randomisation +
                                      static_cast<std::uint32_t>(k));
        }
    }
    EXPECT_EQ(count, 20u * 5 * 8);
    EXPECT_EQ(randomisations.size(), count);
}

TEST_F(Study, KeysThatContradictEachOtherFailTheRow) {
    const Campaign dark = read_study(
        std::string(IDEOTYPE_CAMPAIGNS) + "/ames_quick.toml",
        {"sensitivity.keys=[{key=\"optics.leaf_reflectance\", range=[0, 0.9]},"
         "{key=\"optics.leaf_transmittance\", range=[0, 0.9]}]"});
    Genome of_row = genome;
    of_row.insert(of_row.end(), {0.8, 0.8});
    EXPECT_THROW(at_keys(dark, of_row), InputError);
}

}  // namespace
}  // namespace ideotype
