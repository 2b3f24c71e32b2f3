// SPDX-License-Identifier: Apache-2.0
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sample_campaign.hpp"
#include "spec/writer.hpp"

namespace ideotype {
namespace {

const std::string ames = IDEOTYPE_CAMPAIGNS "/ames.toml";

TEST(Settings, ReplaceValuesOfTheFile) {
    const Campaign campaign = read_campaign(
        ames, {"search.optimizer=random", "search.population = 12",
               "traits=[{name = \"turn\", free = [\"azimuth\"]}]",
               "spacing.plant=0.0762", "day.date=2025-06-21", "name=other",
               "constraints.lai=[3.4, 3.5]"});
    EXPECT_EQ(campaign.search.optimizer, OptimizerKind::random);
    EXPECT_EQ(campaign.search.population, 12);
    EXPECT_EQ(campaign.spec.spacings.at(0).value.plant, 0.0762);
    EXPECT_EQ(campaign.spec.spacings.at(0).value.row, 0.762);
    EXPECT_EQ(campaign.spec.days.at(0).name, "0621");
    EXPECT_EQ(campaign.spec.name, "other");
    EXPECT_EQ(campaign.spec.constraints.lai.lower, 3.4);
    EXPECT_EQ(parse_campaign(campaign.resolved, "c").resolved,
              campaign.resolved);
}

TEST(Settings, TheLastValueOfAKeyApplies) {
    EXPECT_EQ(read_campaign(ames, {"seed=4", "seed=5"}).spec.seed, 5U);
}

TEST(Settings, ATableReplacesTheWholeTableOfTheFile) {
    const std::string file = IDEOTYPE_CAMPAIGNS "/agrivoltaic.toml";
    const auto read = [&](const std::vector<std::string>& settings) {
        return read_campaign(file, settings);
    };
    ASSERT_EQ(read({}).spec.constraints.lai.upper, 5);
    ASSERT_TRUE(read({}).spec.field.variation.is_any());
    EXPECT_EQ(read({"constraints={}"}).spec.constraints.lai.upper,
              Constraints{}.lai.upper);
    EXPECT_FALSE(read({"field.variation={}"}).spec.field.variation.is_any());
    EXPECT_EQ(read({"field.variation={}"}).spec.field.plants, 2);

    const FieldForm field = read({"field={rows=8, plants=4}"}).spec.field;
    EXPECT_EQ(field.plants, 4);
    EXPECT_FALSE(field.variation.is_any());
    EXPECT_EQ(field.jitter, FieldForm{}.jitter);

    // This also holds if the list has only one table.
    const Campaign turned = read({"panel=[]", "spacing={row=1, plant=0.2}"});
    EXPECT_EQ(turned.spec.spacings.at(0).value.row_direction,
              Spacing{}.row_direction);
}

TEST(Settings, DisplacementsThatReachTheNeighbourCauseAWarning) {
    const auto read = [](const std::string& position) {
        return read_campaign(ames, {"field.variation.position=" + position});
    };
    const Campaign usual = read("0.035");
    EXPECT_TRUE(usual.spec.field.variation.is_any());
    EXPECT_EQ(parse_campaign(usual.resolved, "c").spec.field.variation.position,
              0.035);
    EXPECT_TRUE(usual.warnings.empty());
    const std::vector<Problem> warnings = read("0.06").warnings;
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_THAT(warnings.front().what,
                testing::HasSubstr("field.variation.position is 0.06 m (plants "
                                   "reach the places of their neighbours, "
                                   "0.1524 m away;"));
    EXPECT_THROW(read("-0.01"), InputError);
    EXPECT_THROW(read("0.4"), InputError);
}

TEST(Settings, OfATableAndItsKeysApplyInOrder) {
    const std::string file = IDEOTYPE_CAMPAIGNS "/agrivoltaic.toml";
    const std::string table = "field={rows=8, plants=4}";
    const std::string key = "field.variation.azimuth=[3, 3, 3]";
    const FieldForm later = read_campaign(file, {table, key}).spec.field;
    EXPECT_EQ(later.plants, 4);
    EXPECT_EQ(later.variation.azimuth, (LeafSpread{3, 3, 3}));
    EXPECT_EQ(later.variation.curvature, PlantVariation{}.curvature);
    const FieldForm earlier = read_campaign(file, {key, table}).spec.field;
    EXPECT_FALSE(earlier.variation.is_any());
    EXPECT_TRUE(read_campaign(file, {key}).spec.field.variation.is_any());
}

TEST(Settings, ATableWithoutAKeyThatIsNeededIsRefusedAtTheSetting) {
    try {
        read_campaign(ames, {"spacing={row=0.5}"});
        FAIL() << "accepted";
    } catch (const InputError& error) {
        ASSERT_EQ(error.problems().size(), 1U) << error.what();
        EXPECT_EQ(error.problems()[0].where.file, "--set spacing={row=0.5}");
    }
}

std::string accuracy_keys(const std::vector<std::string>& settings,
                          const std::string& file = "/ames.toml") {
    std::string text;
    for (const AccuracyKey& key :
         accuracy_keys(read_campaign(IDEOTYPE_CAMPAIGNS + file, settings).spec))
        text += fmt::format("{}={} ", key.path, key.value);
    return text;
}

TEST(Settings, AccuracyKeysAreDeclared) {
    EXPECT_EQ(accuracy_keys({"light.tolerance=0.01", "field.rows=5"}),
              "day.step_minutes=30 field.rows=5 field.plants=4 "
              "plant.cells_along=12 plant.stalk_sides=8 "
              "light.fields=1 light.tolerance=0.01 ");
    // The number of plants of an isolated plot is not a setting of accuracy.
    EXPECT_EQ(accuracy_keys({"light.tolerance=0", "light.paths=512",
                             "field.boundary=isolated", "plant.organs=[]"}),
              "day.step_minutes=30 plant.cells_along=12 light.paths=512 "
              "light.fields=1 ");
    EXPECT_EQ(accuracy_keys({"light.dates=5"}, "/bondville.toml"),
              "field.rows=4 field.plants=4 plant.cells_along=12 "
              "plant.stalk_sides=8 light.fields=1 light.tolerance=0.005 "
              "light.dates=5 ");
}

TEST(Settings, AreCheckedLikeTheFileAllInOnePass) {
    try {
        read_campaign(ames, {"search.optimizer=randum", "site.latitud=3",
                             "seed", "seed=\"a", "a.b.c.d.e.f.g.h.i.j.k=1"});
        FAIL() << "accepted";
    } catch (const InputError& error) {
        const std::string message = error.what();
        for (const char* part :
             {"--set search.optimizer=randum: search.optimizer is \"randum\" "
              "(not one of its values); did you mean 'random'?",
              "--set site.latitud=3: unknown key 'latitud'",
              "--set seed: this is not a key with a value",
              "--set seed=\"a: seed is a text (expected: ",
              "--set a.b.c.d.e.f.g.h.i.j.k=1: this is not a key with a "
              "value"})
            EXPECT_NE(message.find(part), std::string::npos) << part << "\n"
                                                             << message;
    }
}

TEST(Settings, DoNotGuessWhichOfSeveralTablesIsMeant) {
    try {
        read_campaign(IDEOTYPE_CAMPAIGNS "/spacings.toml", {"spacing.row=1"});
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("tables [[spacing]]"),
                  std::string::npos)
            << error.what();
    }
}

TEST(Settings, CmaEsDerivesItsPopulationFromTheGenesByDefault) {
    const std::string cma = "search.optimizer=cma_es";
    EXPECT_EQ(read_campaign(ames, {cma}).search.population, 15);
    EXPECT_EQ(
        read_campaign(ames, {cma, "search.population=30"}).search.population,
        30);
    EXPECT_THROW(read_campaign(ames, {cma, "search.population=3"}), InputError);
    const std::string race = "search.optimizer=auto";
    EXPECT_EQ(read_campaign(ames, {race}).search.population, 37);
    EXPECT_THROW(read_campaign(ames, {race, "search.population=7"}),
                 InputError);
}

TEST(Settings, AStartIsAWholeGenomeWithinItsBounds) {
    const std::string cma = "search.optimizer=cma_es";
    const Campaign usual = read_campaign(ames, {cma});
    std::vector<double> genes = baseline_numbers(usual.crop);
    const auto start = [&] {
        return fmt::format("search.start=[{}]", fmt::join(genes, ", "));
    };
    const Campaign campaign = read_campaign(ames, {cma, start()});
    EXPECT_EQ(campaign.search.start, genes);
    EXPECT_EQ(parse_campaign(campaign.resolved, "resolved").search.start,
              genes);
    EXPECT_THROW(read_campaign(ames, {start()}), InputError);
    genes[0] = 3;
    EXPECT_THROW(read_campaign(ames, {cma, start()}), InputError);
    genes.pop_back();
    EXPECT_THROW(read_campaign(ames, {cma, start()}), InputError);
}

// These keys occur in histories and files of earlier versions.
TEST(Settings, StudiesReplaceTheSearch) {
    const Campaign study = read_study(ames, {"sensitivity.samples=40"});
    ASSERT_TRUE(study.search.design);
    EXPECT_EQ(study.search.design->samples, 40);
    EXPECT_EQ(study.stop.generations, 3);
    EXPECT_EQ(study.resolved.find("[search]"), std::string::npos);
    EXPECT_EQ(parse_campaign(study.resolved, "again").resolved, study.resolved);
    EXPECT_FALSE(read_campaign(ames, {"sensitivity.samples=40"}).search.design);
}

TEST(Settings, AnAtlasNeedsValidAxes) {
    const std::string lai = "[[search.axes]]\nquantity = \"lai\"\n";
    const std::string ok = lai + "range = [2, 6]\n";
    const auto problem = [](const std::string& axes, const char* more = "") {
        return problem_of(sample_text(
            "",
            std::string("[search]\noptimizer = \"atlas\"\n") + more + axes));
    };
    EXPECT_EQ(problem(ok), "");
    for (const auto& [found, text] :
         {std::pair{problem(""), "add [[search.axes]]"},
          std::pair{problem_of(sample_text("", ok)),
                    "use search.optimizer = \"atlas\""},
          std::pair{problem(ok + ok), "has lai twice"},
          std::pair{problem(lai + "range = [6, 2]\n"), "range"},
          std::pair{problem(ok + "cells = 0\n"), "below the range"},
          std::pair{problem(ok + "cells = 500\n[[search.axes]]\nrange = [1, "
                                 "3]\nquantity = \"plant_height\"\n"),
                    "have 5000 cells together (the limit is 1000)"},
          std::pair{problem(ok, "streams = 3\n"), "streams is 3 (an atlas is"},
          std::pair{problem("[[search.axes]]\nquantity = \"plant_hight\"\n"
                            "range = [0, 1]\n"),
                    "did you mean 'plant_height'?"},
          std::pair{problem("[[search.axes]]\nquantity = \"water_use\"\n"
                            "range = [0, 1]\n"),
                    "the axis water_use needs leaves that transpire"}})
        EXPECT_NE(found.find(text), found.npos) << text << '\n' << found;
    const Campaign campaign = parse_campaign(
        sample_text("", "[search]\noptimizer = \"atlas\"\n" + ok +
                            "cells = 7\n[[search.axes]]\nrange = [0, 9]\n"
                            "quantity = \"net_assimilation\"\ncells = 3\n"),
        "c");
    EXPECT_EQ(campaign.final_rule.candidates, 21) << "all leaders";
    EXPECT_TRUE(campaign.photosynthesis);
    EXPECT_EQ(parse_campaign(campaign.resolved, "c").resolved,
              campaign.resolved);
}

TEST(Settings, EndsOfRangesFitTheRestOfTheCampaign) {
    const std::string key =
        "sensitivity.keys=[{key=\"optics.leaf_reflectance\"";
    EXPECT_NO_THROW(read_study(ames, {key + ", range=[0, 0.1]}]"}));
    try {
        read_study(ames, {"optics.leaf_transmittance=0.5",
                          key + ", range=[0, 0.6]}]"});
        FAIL();
    } catch (const InputError& error) {
        ASSERT_EQ(error.problems().size(), 1U);
        EXPECT_NE(
            error.problems()[0].what.find(
                "sensitivity.keys: if optics.leaf_reflectance is 0.6, then "
                "optics.leaf_transmittance is 0.5"),
            std::string::npos)
            << error.what();
    }
}

TEST(Settings, VariedKeysMustBeValidOverTheirRangeAndStartWithin) {
    const std::string panel = "panel=[{height=4, width=1, azimuth=180}]";
    const auto has_message = [&](const std::string& key,
                                 const std::string& range) {
        try {
            const Campaign read =
                read_campaign(ames, {panel, "search.keys=[{key=\"" + key +
                                                "\", range=" + range + "}]"});
            require_breedable(read);
        } catch (const InputError& error) {
            return error.problems().front().what;
        }
        return std::string();
    };
    EXPECT_EQ(has_message("optics.soil_albedo", "[0, 0.3]"), "");
    EXPECT_THAT(has_message("optics.soil_albedo", "[0.2, 0.3]"),
                testing::HasSubstr("is 0.1 in this campaign (outside"));
    EXPECT_EQ(has_message("spacing.density", "[4, 10]"), "");
    EXPECT_THAT(has_message("spacing.density", "[4, 8]"),
                testing::HasSubstr("is 8.61112833337 in this campaign"));
    EXPECT_THAT(has_message("spacing.density", "[4, 200]"),
                testing::HasSubstr("if spacing.density is 200, then"));
    EXPECT_THAT(has_message("panel.azimuth", "[0, 360]"),
                testing::HasSubstr("if panel.azimuth is 137.52, then"));
}

}  // namespace
}  // namespace ideotype
