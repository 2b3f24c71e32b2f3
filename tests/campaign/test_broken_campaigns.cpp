// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "sample_campaign.hpp"

namespace ideotype {

namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

std::string without(std::string text, const std::string& unwanted) {
    for (std::size_t at; (at = text.find(unwanted)) != std::string::npos;)
        text.erase(at, unwanted.size());
    return text;
}

//! The messages of a campaign file, with the names of files as seen from its
//! folder; empty if nothing is wrong.
std::string messages(const fs::path& path) {
    try {
        require_breedable(read_campaign(path.string()));
    } catch (const InputError& error) {
        return without(error.what(), path.parent_path().string() + '/') + '\n';
    }
    return "";
}

std::set<fs::path> broken_files() {
    std::set<fs::path> files;
    for (const auto& entry :
         fs::directory_iterator(IDEOTYPE_TEST_DATA "/broken"))
        if (entry.path().extension() == ".toml") files.insert(entry.path());
    return files;
}

}  // namespace

TEST(BrokenCampaign, EveryProblemIsReportedInOnePass) {
    const std::set<fs::path> files = broken_files();
    EXPECT_GE(files.size(), 10u);
    for (fs::path file : files) {
        const std::string found = messages(file);
        EXPECT_NE(found, "") << file;
        EXPECT_EQ(found, content(file.replace_extension(".txt"))) << file;
    }
}

TEST(BrokenCampaign, EndsWithTheExitCodeOfInvalidCampaigns) {
    try {
        read_campaign(IDEOTYPE_TEST_DATA "/broken/many.toml");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.exit_code(), ExitCode::invalid_campaign);
        EXPECT_GT(error.problems().size(), 20u);
    }
}

TEST(BrokenCampaign, MissingFileIsNotAnInputError) {
    try {
        read_campaign("no/such/campaign.toml");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.exit_code(), ExitCode::runtime);
        EXPECT_STREQ(error.what(), "cannot read no/such/campaign.toml");
    }
}

TEST(BrokenCampaign, ResolvedCampaignsStandAlone) {
    std::string text = sample_text();
    const std::size_t table = text.find("[plant.baseline]");
    text = text.substr(0, table) + "baseline = \"crops/maize.toml\"\n";
    EXPECT_NE(problem_of(text).find("write it as [plant.baseline]"),
              std::string::npos)
        << problem_of(text);
}

TEST(BrokenCampaign, IntegersBeyondTheExactDecimalsAreOutOfRange) {
    const std::string problem =
        problem_of(sample_text("replicates = 9007199254740993\n"));
    EXPECT_NE(problem.find("above the range 1 .. 1000"), std::string::npos);
}

TEST(BrokenCampaign, PlantsHaveAtMostFortyLeaves) {
    std::string leaves;
    for (int i = 0; i < 40; ++i)
        leaves +=
            "[[plant.baseline.leaf]]\nlength = 0.8\nwidth = 0.08\n"
            "insertion_angle = 40\ncurvature = 60\nazimuth = 90\n"
            "insertion_height = 0.2\n";
    EXPECT_NE(problem_of(sample_text("", leaves))
                  .find("the plant has 41 leaves (the limit is 40)"),
              std::string::npos);
}

TEST(BrokenCampaign, UnknownSkiesAreRefusedWithTheKnownOnes) {
    EXPECT_NE(problem_of(sample_text("", "[light]\nsky = \"cloudy\"\n"))
                  .find("light.sky is \"cloudy\" (not one of its values); use "
                        "\"uniform\" or \"overcast\" or \"clear\""),
              std::string::npos);
    EXPECT_NE(problem_of(sample_text("", "[light]\nsky = 3\n"))
                  .find("light.sky is an integer (expected: text)"),
              std::string::npos);
}

TEST(BrokenCampaign, LinesThatAreNotTomlSayHowToWriteThem) {
    const std::pair<const char*, const char*> lines[] = {
        {"start = 05:00", "write times as in start = 05:00:00"},
        {"start = 5:30:00 # early", "write times as in start = 05:30:00"},
        {"date = 15.07.2025", "write dates as in date = 2025-07-15"},
        {"date = 2025-7-5", "write dates as in date = 2025-07-05"},
        {"date = 2025-02-30", "correct this line"},
        {"row = .8", "write numbers as in row = 0.8"},
        {"row = 0,762", "write numbers as in row = 0.762"},
        {"row = -0.5 m", "write numbers as in row = -0.5"},
        {"name = my_site", "write texts as in name = \"my_site\""},
        {"row = 30 in", "correct this line"},
        {"row = 1\nrow = 2", "remove one of the two"},
        {"plant.bounds = \"paper\"\n[plant.bounds]",
         "keep either bounds = \"...\" or [plant.bounds]"}};
    for (const auto& [line, advice] : lines) {
        const std::string problem = problem_of(line);
        EXPECT_TRUE(problem.ends_with(std::string("; ") + advice)) << problem;
    }
}

TEST(BrokenCampaign, QuotedValuesSayHowToWriteThem) {
    const std::string problem = problem_of(
        "[day]\nstart = \"05:00\"\ndate = \"15.07.2025\"\n"
        "[spacing]\nrow = \"0.762\"\nplant = \"six\"\n");
    for (const std::string advice :
         {"write start = 05:00:00 without quotes",
          "write date = 2025-07-15 without quotes",
          "write row = 0.762 without quotes", "write for example plant = "})
        EXPECT_NE(problem.find("; " + advice), std::string::npos) << problem;
}

TEST(BrokenCampaign, OnlyTheFirstLineThatIsNotTomlIsReported) {
    std::string text;
    for (int i = 0; i < 3000; ++i) text += fmt::format("key{} = 1 in\n", i);
    EXPECT_TRUE(problem_of(text).starts_with("sample.toml:1:"));
    EXPECT_EQ(problem_of(text).find("sample.toml:2:"), std::string::npos);
}

TEST(BrokenCampaign, KeysOfManyPartsAreRefusedBeforeTheParserRecurses) {
    std::string key = "a";
    for (int i = 1; i < 40000; ++i) key += ".a";
    EXPECT_TRUE(problem_of("# a\n" + key + " = 1\n")
                    .starts_with("sample.toml:2:16: a key has more than 8"));
    EXPECT_NE(problem_of('[' + key + "]\n").find("more than 8"),
              std::string::npos);
    EXPECT_NE(problem_of("x = {" + key + " = 1}\n").find("more than 8"),
              std::string::npos);
}

TEST(BrokenCampaign, DotsInTextsAndCommentsAndNumbersAreNoParts) {
    for (const std::string line :
         {"x = \"\\\"a.b.c.d.e.f.g.h.i.j\"", "x = 'a.b.c.d.e.f.g.h.i.j'",
          "# a.b.c.d.e.f.g.h.i.j",
          "x = [1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, "
          "1.0, 1.0, 1.0]",
          "x = \"\"\"\na.b.c.d.e.\"f.g.h.i.j\"\"\""})
        EXPECT_EQ(problem_of(line + '\n').find("parts"), std::string::npos)
            << line;
}

TEST(BrokenCampaign, PlantFilesAreNoCampaigns) {
    const std::string problem = problem_of("name = \"p\"\n[[leaf]]\n");
    EXPECT_NE(problem.find("this is a crop file"), std::string::npos);
    EXPECT_NE(problem.find("--under CAMPAIGN"), std::string::npos);
    EXPECT_EQ(problem.find('\n'), std::string::npos) << problem;
}

TEST(BrokenCampaign, BlackAndConservativeSurfacesAreAllowed) {
    EXPECT_EQ(problem_of(sample_text("",
                                     "[optics]\nleaf_reflectance = 0.7\n"
                                     "leaf_transmittance = 0.3\n"
                                     "stalk_reflectance = 0\n"
                                     "stalk_transmittance = 0\n"
                                     "soil_albedo = 1\n")),
              "");
}

}  // namespace ideotype
