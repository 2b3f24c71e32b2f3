// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "ideotype/campaign/migration.hpp"
#include "sample_campaign.hpp"
#include "temporary_folder.hpp"

namespace ideotype {

namespace {

std::string replaced(std::string text, const std::string& was,
                     const std::string& is) {
    for (std::size_t at = 0; (at = text.find(was, at)) != std::string::npos;
         at += is.size())
        text.replace(at, was.size(), is);
    return text;
}

//! Without the traits that all plants of version 0.1 had, and their bounds.
std::string without_traits(const std::string& text) {
    const std::size_t first = text.find("\n[[plant.baseline.trait]]");
    const std::size_t last = text.find("\n[optics]");
    return text.substr(0, first) + text.substr(last);
}

//! A resolved text as version 0.1 wrote it.
std::string old_resolved(std::string text) {
    text = without_traits(text);
    for (const auto& [is, was] : {std::pair{"insertion_angle", "inclination"},
                                  {"curvature", "droop"},
                                  {"folding_angle", "fold"},
                                  {"border_rows", "cut"},
                                  {"[search]", "[evolution]"}})
        text = replaced(text, is, was);
    return text;
}

std::string content(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

std::string text_of(const std::string& text) {
    return migrated(text, "old.toml").text;
}

}  // namespace

TEST(Migration, ACampaignOfVersion01BecomesTheSameOfThisVersion) {
    const Campaign campaign =
        sample("", "[[traits]]\nname = \"a\"\nfree = [\"insertion_angle\"]\n",
               "{ length = [0.4, 1.1], width = [0.05, 0.14], "
               "insertion_angle = [10, 80] }");
    const std::string old = old_resolved(campaign.resolved);
    EXPECT_THROW(parse_campaign(old, "old.h5"), InputError);
    const Migration migration = migrated(old, "old.h5");
    EXPECT_EQ(migration.text, without_traits(campaign.resolved));
    EXPECT_EQ(migration.changes.size(), 8u);
    EXPECT_EQ(parse_campaign(migration.text, "old.h5").sha256, campaign.sha256);
    EXPECT_TRUE(migrated(migration.text, "old.h5").changes.empty());
}

TEST(Migration, TheCampaignOfAHistoryOfFormat10IsThatOfItsMigratedFile) {
    const std::string stored =
        content(IDEOTYPE_TEST_DATA "/campaign/resolved_1_0.toml");
    const std::string file = temporary_file("migrated_sample.toml");
    std::ofstream(file) << replaced(
        text_of(content(IDEOTYPE_TEST_DATA "/history/sample.toml")), "../../..",
        IDEOTYPE_TEST_DATA "/../..");
    EXPECT_EQ(parse_campaign(text_of(stored), "old.h5").resolved,
              read_campaign(file).resolved);
}

TEST(Migration, OnlyTheNamesThemselvesChange) {
    const std::string old =
        "# inclination, droop, [evolution]\r\n"
        "name = \"inclination\"  # droop\r\n"
        "\r\n"
        "\t[ evolution ] # evolution\r\n"
        "population=5\r\n"
        "[[traits]]\r\n"
        "name = \"inclination\"\r\n"
        "free = [ 'inclination',\r\n"
        "  \"azimuth\", # inclination\r\n"
        "  \"inclination\"]\r\n"
        "[plant.baseline.blade]\r\n"
        "\"fold\"   =   12";
    std::string is = old;
    for (const auto& [from, to] :
         {std::pair{"[ evolution ]", "[ search ]"},
          {"'inclination'", "'insertion_angle'"},
          {"  \"inclination\"", "  \"insertion_angle\""},
          {"\"fold\"", "\"folding_angle\""}})
        is = replaced(is, from, to);
    EXPECT_EQ(text_of(old), is);
}

TEST(Migration, InlineTablesAndDottedKeysAreFollowed) {
    EXPECT_EQ(text_of("evolution.population = 5\nevolution . elites = 2\n"
                      "field.cut = 1\n"),
              "search.population = 5\nsearch . elites = 2\n"
              "field.border_rows = 1\n");
    EXPECT_EQ(text_of("leaf = [{ \"ä\" = 'ö', inclination = 3, droop = 4 }]\n"),
              "leaf = [{ \"ä\" = 'ö', insertion_angle = 3, curvature = 4 }]\n");
    EXPECT_EQ(text_of("plant = { bounds = { inclination = [1, 2] } }\n"),
              "plant = { bounds = { insertion_angle = [1, 2] } }\n");
}

TEST(Migration, StalksKeepTheirShape) {
    EXPECT_EQ(text_of("[stalk]\nheight = 2\n  diameter = 0.027 # m\n"),
              "[stalk]\nheight = 2\n  leaf_base = \"axis\"\n"
              "  base_diameter = 0.027 # m\n");
    EXPECT_EQ(text_of("stalk = { height = 2, diameter = 0.027 }\n"),
              "stalk = { height = 2, leaf_base = \"axis\", "
              "base_diameter = 0.027 }\n");
    const std::string tall =
        "[plant.baseline.stalk]\nheight = 2\ndiameter = 0.027\n";
    const Plant plant =
        parse_campaign(text_of(sample_text("", tall)), "c").crop.baseline;
    EXPECT_EQ(plant.stalk.leaf_base, LeafBase::axis);
    EXPECT_EQ(plant.stalk.radius(0), plant.stalk.radius(2));
    EXPECT_EQ(plant.stalk.radius(1), 0.027 / 2);
}

TEST(Migration, PlantsWithoutStalksHaveNoOrgansButLeaves) {
    EXPECT_EQ(text_of("[plant]\nstalk = false # none\nbaseline = \"t\"\n"),
              "[plant]\norgans = [] # none\nbaseline = \"t\"\n");
    EXPECT_EQ(text_of("plant.stalk=true\n"), "plant.organs=[\"stalk\"]\n");
}

TEST(Migration, ConstraintsAreThoseOfTraits) {
    EXPECT_EQ(text_of("[constraints]\nlength_step = 0.1\nwidth_step = 0.2\n"
                      "inclination_step = 3\nerect_top = true\n"),
              "[constraints]\nlength.step = 0.1\nwidth.step = 0.2\n"
              "insertion_angle.step = 3\ninsertion_angle.falling = true\n");
}

TEST(Migration, ByteOrderMarksMoveNothing) {
    EXPECT_EQ(text_of("\xEF\xBB\xBF[evolution]\n"), "\xEF\xBB\xBF[search]\n");
}

TEST(Migration, OldNamesElsewhereAreNoOldNames) {
    const std::string text =
        "[blade]\ninclination = 3\n[leaf.leaf]\ndroop = 4\n"
        "[x.leaf]\ndroop = 5\n[field]\nsearch = 2\nfold = 3\n";
    EXPECT_EQ(text_of(text), text);
}

TEST(Migration, ATableWithBothNamesIsLeftToTheReader) {
    const std::string text =
        "[[leaf]]\ninclination = 3\ninsertion_angle = 4\ndroop = 5\n"
        "[evolution]\nelites = 1\n[search]\nelites = 2\n";
    const Migration migration = migrated(text, "old.toml");
    EXPECT_EQ(migration.text, replaced(text, "droop", "curvature"));
    ASSERT_EQ(migration.changes.size(), 1u);
    EXPECT_EQ(migration.changes[0].what, "key 'droop' in [leaf]");
    EXPECT_EQ(migration.changes[0].where.line, 4);
}

TEST(Migration, NamesThatAreWrittenWithEscapesAreLeftToTheReader) {
    const std::string text = "[evolution]\n[field]\n\"c\\u0075t\" = 1\n";
    EXPECT_EQ(text_of(text), replaced(text, "evolution", "search"));
}

TEST(Migration, ChangesAreInTheOrderOfTheText) {
    const Migration migration = migrated(
        "evolution.population = 5\nevolution.elites = 2\nfield.cut = 1\n",
        "old.toml");
    ASSERT_EQ(migration.changes.size(), 3u);
    for (int line = 1; line <= 3; ++line)
        EXPECT_EQ(migration.changes[line - 1].where.line, line);
}

TEST(Migration, CampaignsTellWhichPlantTheyName) {
    EXPECT_EQ(migrated("[plant]\nbaseline = \"../b73.toml\"\n", "a/b/c.toml")
                  .plant_file,
              "a/b73.toml");
    EXPECT_EQ(migrated("[plant.baseline]\n", "a/b/c.toml").plant_file, "");
}

TEST(Migration, WhatIsNotTomlIsRefused) {
    try {
        migrated("[evolution]\nelites = two\n", "old.toml");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_TRUE(
            std::string(error.what()).starts_with("old.toml:2:11: not valid"))
            << error.what();
    }
}

}  // namespace ideotype
