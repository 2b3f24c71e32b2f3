#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

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
        read_campaign(path.string());
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

std::string problem_of(const std::string& text) {
    try {
        parse_campaign(text, "sample.toml");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
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
    text = text.substr(0, table) + "baseline = \"plants/b73.toml\"\n";
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
            "inclination = 40\ndroop = 60\nazimuth = 90\n"
            "insertion_height = 0.2\n";
    EXPECT_NE(problem_of(sample_text("", leaves))
                  .find("the plant has 41 leaves (the limit is 40)"),
              std::string::npos);
}

TEST(BrokenCampaign, UnknownSkiesAreRefusedWithTheKnownOnes) {
    EXPECT_NE(problem_of(sample_text("", "[light]\nsky = \"cloudy\"\n"))
                  .find("light.sky is \"cloudy\" (not one of its values) use "
                        "\"uniform\" or \"overcast\" or \"clear\""),
              std::string::npos);
    EXPECT_NE(problem_of(sample_text("", "[light]\nsky = 3\n"))
                  .find("light.sky is an integer (expected: text)"),
              std::string::npos);
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
