// SPDX-License-Identifier: Apache-2.0
// Tests campaigns of several components and wavebands.
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "mixtures.hpp"

namespace ideotype {
namespace {

TEST_F(Mixtures, StandPlantByPlantInANewOrderInEachField) {
    const Campaign campaign = read_campaign(IDEOTYPE_CAMPAIGNS "/mixture.toml",
                                            {"field.variation={length=0.1}"});
    Scene scene = scene_of(campaign, cases(campaign).front());
    const auto places = draw_places(scene, {1, 0});
    ASSERT_EQ(places.size(), 2u);
    std::set<std::pair<double, double>> positions;
    for (const auto& component : places) {
        EXPECT_EQ(component.size(), 8u);
        for (const Place& place : component)
            positions.emplace(place.x, place.y);
    }
    EXPECT_EQ(positions.size(), 16u);
    const auto x_of = [](const std::vector<Place>& component) {
        std::vector<double> x;
        for (const Place& place : component) x.push_back(place.x);
        return x;
    };
    EXPECT_NE(x_of(places[0]), x_of(draw_places(scene, {1, 1})[0]));
    EXPECT_EQ(x_of(places[0]), x_of(draw_places(scene, {1, 0})[0]));
    EXPECT_NEAR(scene.components[0].ground_per_plant, 2 / 8., 1e-12);
}

TEST_F(Mixtures, PlantsDeviateFromTheirPositionsInAMixture) {
    const auto places = [](const std::string& variation) {
        const Campaign campaign =
            read_campaign(IDEOTYPE_CAMPAIGNS "/mixture.toml",
                          {"field.variation={" + variation + "}"});
        return draw_places(scene_of(campaign, cases(campaign).front()), {1, 0});
    };
    const auto drawn = places("position=0.02"), lattice = places("");
    for (std::size_t c = 0; c < 2; ++c) {
        ASSERT_EQ(drawn[c].size(), lattice[c].size());
        for (std::size_t p = 0; p < lattice[c].size(); ++p) {
            EXPECT_EQ(drawn[c][p].row, lattice[c][p].row);
            EXPECT_EQ(drawn[c][p].x, lattice[c][p].x);
            EXPECT_NE(drawn[c][p].y, lattice[c][p].y);
            EXPECT_NEAR(drawn[c][p].y, lattice[c][p].y, .06 + 1e-9);
        }
    }
    // Components have independent deviations.
    EXPECT_NE(drawn[0][0].y - lattice[0][0].y, drawn[1][0].y - lattice[1][0].y);
}

//! A mixture of one kind of plant equals a field of this kind.
TEST_F(Mixtures, PlantByPlantOfOneCropEqualThatCrop) {
    std::vector<std::string> settings = alike;
    const CanopyReport one = evaluated(settings);
    settings.push_back(
        "component=[{name=\"weed\", crop=\"crops/maize.toml\", mixed=8}]");
    const CanopyReport both = evaluated(settings);
    EXPECT_NEAR(both.components[0].lai, both.components[1].lai, 1e-9);
    EXPECT_NEAR(both.lai, one.lai, 1e-9);
    for (const char* name : {"absorbed_par", "net_assimilation"})
        EXPECT_NEAR(number(name, both).mean, number(name, one).mean,
                    .02 * number(name, one).mean);
}

//! Soybean next to maize gets more light in strips of two rows of each crop
//! than in alternate rows, and maize less. In the field experiment of
//! PMC6391028 soybean got more than twice as much at first flowering.
TEST_F(Mixtures, SoybeanGetsMoreLightInStripsThanInAlternateRows) {
    const auto light = [&](const std::string& rows, const std::string& places,
                           const std::string& pattern) {
        const CanopyReport report = evaluated(
            {"spacing=[{row=0.5, plant=0.15, row_direction=0}]",
             "field={rows=" + rows +
                 ", plants=4, jitter=10, row_pattern=" + pattern + "}",
             "component=[{name=\"soybean\", crop=\"crops/soybean.toml\", "
             "plants=6, jitter=180, rows=" +
                 places + "}]"});
        return measure_parts("absorbed_par", report);
    };
    const auto alternate = light("2", "[2]", "[1, 1]");
    const auto strips = light("4", "[3, 4]", "[0.4, 0.6]");
    EXPECT_GT(strips[1].estimate.mean, 1.4 * alternate[1].estimate.mean);
    EXPECT_LT(strips[0].estimate.mean, 0.97 * alternate[0].estimate.mean);
    for (const auto& parts : {alternate, strips})
        EXPECT_LT(parts[1].estimate.standard_error,
                  .05 * parts[1].estimate.mean);
}

TEST_F(Mixtures, PartsOfAnObjectiveAreReportedByRandomisation) {
    std::vector<std::string> settings = alike;
    settings.push_back(weed);
    std::string bands;
    for (const Waveband& each : wavebands)
        bands += "{name=\"" + each.name + "\"},";
    settings.push_back("band=[" + bands + "]");
    const CanopyReport report = evaluated(settings);
    for (const std::string& name : additive_objectives()) {
        const Randomised whole = measure_objective(name, report);
        const std::vector<Randomised> parts = measure_parts(name, report);
        const Randomised both = weighted_sum(parts, {1, 1});
        const Randomised first = weighted_sum(parts, {2, 0});
        EXPECT_NEAR(both.estimate.mean, whole.estimate.mean, 1e-9) << name;
        EXPECT_NEAR(first.estimate.mean, 2 * parts[0].estimate.mean, 1e-9);
        EXPECT_NEAR(first.estimate.standard_error,
                    2 * parts[0].estimate.standard_error, 1e-9)
            << name;
        for (std::size_t r = 0; r < both.by_randomisation.size(); ++r)
            EXPECT_NEAR(both.by_randomisation[r], whole.by_randomisation[r],
                        1e-9)
                << name;
    }
}

//! The genes of a component affect only its plants, and objectives of single
//! components sum to the objective of all.
TEST_F(Mixtures, OfOptimisedCropsReportEachComponent) {
    const Campaign campaign =
        read_campaign(IDEOTYPE_CAMPAIGNS "/intercrop.toml",
                      {"light.paths=1024",
                       "objective.maximise=[\"b73.net_assimilation\", "
                       "\"soybean.net_assimilation\", \"net_assimilation\"]"});
    const Case chosen = cases(campaign).front();
    Stand stand(campaign, chosen);
    const auto outcome = [&](const Plants& plants) {
        return stand.evaluate(plants, sampling_of(Task{}, campaign, chosen),
                              device);
    };
    Genome genome = baseline_genome(campaign);
    const Outcome before = outcome(grow(campaign, genome));
    EXPECT_NEAR(before.objectives[0].mean + before.objectives[1].mean,
                before.objectives[2].mean, 1e-9);
    EXPECT_EQ(before.objectives[0].mean,
              outcome({campaign.crop.baseline}).objectives[0].mean);

    const GeneSpace genes = gene_space(campaign, chosen);
    const auto gene =
        std::ranges::find(genes, "soybean.internode_length", &Gene::name);
    ASSERT_NE(gene, genes.end());
    genome[static_cast<std::size_t>(gene - genes.begin())] = gene->upper;
    const Plants taller = grow(campaign, genome);
    EXPECT_EQ(taller[0].leaves.back().insertion_height,
              campaign.crop.baseline.leaves.back().insertion_height);
    EXPECT_GT(
        taller[1].leaves.back().insertion_height,
        campaign.components[0].crop.baseline.leaves.back().insertion_height);
    EXPECT_GT(outcome(taller).objectives[1].mean, before.objectives[1].mean);
    genome.pop_back();
    EXPECT_THROW(grow(campaign, genome), Error);
}

//! The yields of the sole crops are also uncertain, but all rows share this
//! error.
TEST_F(Mixtures, HaveALandEquivalentRatio) {
    std::vector<std::string> settings = alike;
    settings.push_back(weed);
    settings.push_back("objective.maximise=net_assimilation");
    settings.push_back("objective.sole=[0.8, 1.6]");
    settings.push_back("objective.sole_errors=[0.08, 0.16]");
    const Campaign campaign =
        read_campaign(IDEOTYPE_CAMPAIGNS "/ames_quick.toml", settings);
    const CanopyReport report = evaluated(settings);
    const auto parts = measure_parts("net_assimilation", report);
    const double first = parts[0].estimate.mean / .8,
                 second = parts[1].estimate.mean / 1.6;
    const Estimate paired =
        measure_number(campaign, "net_assimilation", report).estimate;
    EXPECT_NEAR(paired.mean, first + second, 1e-9);
    const Estimate ratio = land_equivalent_ratio(campaign, report);
    EXPECT_EQ(ratio.mean, paired.mean);
    EXPECT_NEAR(std::pow(ratio.standard_error, 2),
                std::pow(paired.standard_error, 2) + std::pow(.1 * first, 2) +
                    std::pow(.1 * second, 2),
                1e-9);
    const OutcomeSchema schema =
        outcome_schema(campaign, cases(campaign).front(), {});
    EXPECT_EQ(schema.objectives.front().unit, "1");
}

//! The leaf area reported for a crop is that of its plants in the evaluated
//! field.
TEST_F(Mixtures, HaveTheLeafAreaOfTheirLines) {
    const CanopyRequest request = requested({weed});
    const CanopyReport report = evaluate(request, device);
    for (std::size_t c = 0; c < 2; ++c) {
        const Component& component = request.scene.components[c];
        EXPECT_NEAR(lai_of_line(component.mesh, component.ground_per_plant),
                    report.components[c].lai, 1e-9);
    }
}

//! Components sum to the total in each scenario and in the mean over scenarios,
//! for maximised and minimised objectives.
TEST_F(Mixtures, WeightObjectivesInAllScenarios) {
    const auto outcome = [&](const std::string& weights) {
        const Campaign campaign = read_campaign(
            IDEOTYPE_CAMPAIGNS "/ames_quick.toml",
            {weed, "light.paths=1024", "objective.over=[\"spacing\"]",
             "spacing=[{row=0.76, plant=0.15}, {row=0.38, plant=0.15}]",
             "objective.maximise=absorbed_par",
             "objective.minimise=net_assimilation", "search.optimizer=nsga2",
             "objective.weights=" + weights});
        const Case chosen = cases(campaign).front();
        Stand stand(campaign, chosen);
        Outcome result =
            stand.evaluate({campaign.crop.baseline},
                           sampling_of(Task{}, campaign, chosen), device);
        EXPECT_TRUE(has_form(stand.schema(false), result));
        return result;
    };
    const Outcome whole = outcome("[]"), both = outcome("[1, 1]"),
                  first = outcome("[1, 0]"), second = outcome("[0, 1]");
    ASSERT_EQ(whole.objectives.size(), 2u);
    const auto expect_sums = [&](const auto& number, std::size_t i) {
        EXPECT_NEAR(number(both, i), number(whole, i), 1e-9) << i;
        EXPECT_NEAR(number(first, i) + number(second, i), number(whole, i),
                    1e-9)
            << i;
        EXPECT_LT(std::abs(number(first, i)), std::abs(number(whole, i))) << i;
    };
    for (std::size_t k = 0; k < 2; ++k)
        expect_sums([](const Outcome& x,
                       std::size_t i) { return x.objectives[i].mean; },
                    k);
    for (std::size_t r = 0; r < whole.randomisations.size(); ++r)
        expect_sums(
            [](const Outcome& x, std::size_t i) { return x.randomisations[i]; },
            r);
    // Two objectives in two scenarios are the last quantities.
    for (std::size_t i = whole.quantities.size() - 4;
         i < whole.quantities.size(); ++i)
        expect_sums([](const Outcome& x,
                       std::size_t n) { return x.quantities[n].mean; },
                    i);
    EXPECT_NEAR(
        both.objectives[1].standard_error / whole.objectives[1].standard_error,
        1, 1e-6);
}

//! Components of equal plants have no advantage over each other; shaded ones
//! have a disadvantage.
TEST_F(Mixtures, ReportTheRelativeAdvantageOfOneComponent) {
    std::vector<std::string> settings = alike;
    settings.push_back(weed);
    const Estimate none = number("invasion", evaluated(settings));
    EXPECT_NEAR(none.mean, 0, 4 * none.standard_error);
    EXPECT_LT(none.standard_error, .02);
    const auto value_of = [&](const std::string& crop) {
        settings.back() = "component=[{name=\"weed\", crop=\"crops/" + crop +
                          ".toml\", mixed=8}]";
        return number("invasion", evaluated(settings));
    };
    const Estimate over_cowpea = value_of("cowpea");
    EXPECT_GT(over_cowpea.mean, 1 + 4 * over_cowpea.standard_error);
}

//! A plant with a carbon gain has an advantage over neighbours with a carbon
//! loss.
TEST_F(Mixtures, ReportAGainOverPlantsWithANegativeBalance) {
    CanopyReport report = evaluated({weed});
    AssimilationReport& assimilation = *report.assimilation;
    const double gross =
        measure_parts("gross_assimilation", report)[1].estimate.mean;
    for (std::size_t g = 0; g < report.groups.size(); ++g)
        if (report.groups[g].id.component == 1)
            assimilation.losses[g].in_light += gross / 5;
    const auto net = measure_parts("net_assimilation", report);
    const double maize = net[0].estimate.mean, other = net[1].estimate.mean;
    ASSERT_GT(maize, 0);
    ASSERT_LT(other, 0);
    const Estimate gain = number("invasion", report);
    EXPECT_NEAR(gain.mean, (maize - other) / -other, .02);
    // A plant that loses twice as much carbon as its neighbours does not
    // invade.
    assimilation.losses.front().in_light += maize - 2 * other;
    EXPECT_NEAR(number("invasion", report).mean, -1, .02);
}

//! If the divisor of a gain is zero, no gain is reported; otherwise every row
//! of a history would fail.
TEST_F(Mixtures, ReportNoGainOverPlantsWithoutCarbon) {
    CanopyReport report = evaluated({weed});
    report.assimilation.reset();
    EXPECT_NE(number("invasion", report).mean, 0);
    for (std::vector<double>& groups :
         report.bands.front().groups_by_randomisation)
        for (std::size_t g = 0; g < groups.size(); ++g)
            if (report.groups[g].id.component == 1) groups[g] = 0;
    EXPECT_EQ(number("invasion", report).mean, 0);
    EXPECT_EQ(number("invasion", report).standard_error, 0);
}

//! Plants of the main crop may be uniform while those of a component vary.
TEST_F(Mixtures, VaryByComponent) {
    const std::string crop = "name=\"weed\", crop=\"crops/maize.toml\", ";
    const CanopyRequest request =
        requested({"component=[{" + crop +
                   "rows=[2, 4], variation={length=0.1, missing=0.25}}]"});
    EXPECT_FALSE(request.scene.components[0].variation.is_any());
    EXPECT_EQ(request.scene.components[1].variation.length, 0.1);
    const Field field = draw_field(request.scene, request.randomness);
    EXPECT_EQ(field.first_plant[1], request.scene.components[0].plants());
    EXPECT_EQ(field.first_plant[2] - field.first_plant[1],
              request.scene.components[1].plants() * 3 / 4);
}

TEST_F(Mixtures, OfOneCropEqualThatCrop) {
    const CanopyReport one = evaluated(alike);
    std::vector<std::string> settings = alike;
    settings.push_back(weed);
    const CanopyReport two = evaluated(settings);
    EXPECT_NEAR(two.lai, one.lai, 1e-9);
    for (const char* name : {"absorbed_par", "fapar", "soil_fraction",
                             "gross_assimilation", "net_assimilation"})
        expect_equal(number(name, two), number(name, one), name);
    ASSERT_EQ(two.components.size(), 2u);
    EXPECT_NEAR(two.components[0].lai, two.components[1].lai, 1e-9);
    const auto parts = by_component(*two.assimilation, two.groups, 2);
    EXPECT_NEAR((parts[0].gross.mean + parts[1].gross.mean) /
                    two.assimilation->gross.sum.mean,
                1, 1e-12);
    EXPECT_NEAR(
        (two.par().part(0).leaves.mean + two.par().part(1).leaves.mean) /
            two.par().light.day.leaves.mean,
        1, 1e-12);
    const double half = two.par().light.day.leaves.mean / 2;
    EXPECT_NEAR(two.par().part(0).leaves.mean / half, 1, .05);
}

TEST_F(Mixtures, DoNotDependOnNames) {
    std::vector<std::string> settings = alike;
    settings.push_back(weed);
    const CanopyReport one = evaluated(settings);
    settings.back().replace(settings.back().find("weed"), 4, "aaaa");
    const CanopyReport other = evaluated(settings);
    EXPECT_EQ(one.par().groups_by_randomisation,
              other.par().groups_by_randomisation);
    EXPECT_EQ(one.assimilation->gross.sum.mean,
              other.assimilation->gross.sum.mean);
}

TEST_F(Mixtures, ReportQuantitiesInTheDeclaredOrder) {
    const Campaign campaign =
        read_campaign(IDEOTYPE_CAMPAIGNS "/ames_quick.toml",
                      {weed, nir, "objective.maximise=net_assimilation"});
    const Case chosen = cases(campaign).front();
    const QuantitySet measured = AcrossScenarios(campaign, chosen).measured();
    const CanopyReport report = evaluated({weed, nir});
    const std::vector<Estimate> numbers = measure(report);
    ASSERT_EQ(numbers.size(), measured.size());
    EXPECT_EQ(measured.axis("component").size(), 2u);
    EXPECT_EQ(measured.axis("band").size(), 2u);
    EXPECT_EQ(measured.axis("leaf").size(), 20u);
    const std::size_t light = measured.offset("absorbed_light");
    // The order of axes is components, then bands.
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) sum += numbers[light + i].mean;
    EXPECT_NEAR(sum / number("absorbed_shortwave", report).mean, 1, 1e-12);
    EXPECT_NEAR((numbers[light].mean + numbers[light + 2].mean) /
                    number("absorbed_par", report).mean,
                1, 1e-12);
    // The light absorbed by each component sums over all instants to its daily
    // light.
    const LightSeries series = light_of(campaign, chosen);
    const std::size_t hours = measured.offset("absorbed_light_by_hour");
    for (std::size_t i = 0; i < 4; ++i) {
        double day = 0;
        for (std::size_t h = 0; h < series.steps.size(); ++h)
            day += series.steps[h].seconds * 1e-6 *
                   numbers[hours + i * series.steps.size() + h].mean;
        EXPECT_NEAR(day / numbers[light + i].mean, 1, 1e-12) << i;
    }
    EXPECT_EQ(numbers[measured.offset("lai_by_component")].mean,
              report.components[0].lai);
}

TEST_F(Mixtures, NearInfraredDoesNotChangePar) {
    const CanopyReport par = evaluated({}), both = evaluated({nir});
    ASSERT_EQ(both.bands.size(), 2u);
    EXPECT_EQ(both.par().budget_by_randomisation,
              par.par().budget_by_randomisation);
    EXPECT_EQ(both.assimilation->gross.sum.mean,
              par.assimilation->gross.sum.mean);
    const BandReport& beyond = both.bands[1];
    EXPECT_NEAR(beyond.light.day.incident / par.par().light.day.incident,
                .55 / .45, 1e-9);
    EXPECT_LT(beyond.light.balance_error, 1e-12);
    // Leaves absorb a sixth of the light that hits them and scatter the rest.
    const double absorbed =
        beyond.light.day.leaves.mean / beyond.light.day.incident;
    EXPECT_GT(absorbed, .2);
    EXPECT_LT(absorbed, .6);
    EXPECT_GT(beyond.light.day.reflected.mean,
              3 * both.par().light.day.reflected.mean);
    EXPECT_LT(beyond.light.day.leaves.standard_error,
              .03 * beyond.light.day.leaves.mean);
}

TEST_F(Mixtures, AToleranceMayBoundNearInfrared) {
    const CanopyReport loose = evaluated({nir});
    const CanopyReport tight = evaluated({nir, "light.band=nir"});
    const auto error = [](const CanopyReport& report) {
        const Estimate& leaves = report.bands[1].light.day.leaves;
        return leaves.standard_error / leaves.mean;
    };
    EXPECT_LT(error(tight), 1.6 * .004);
    EXPECT_LT(error(tight), error(loose));
    expect_equal(tight.bands[1].light.day.leaves,
                 loose.bands[1].light.day.leaves, "nir");
}

}  // namespace
}  // namespace ideotype
