// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gtest/gtest.h>

#include "sample_campaign.hpp"

namespace ideotype {
namespace {

//! Returns a table of two traits; a test may replace `part` by a mistake.
std::string lines(const std::string& part = "", const std::string& wrong = "") {
    std::string text = R"([feasibility]
limit = 2
correlations = [0.5]
[[feasibility.trait]]
measure = "leaf.length"
leaf = "top"
mean = 0.8
deviation = 0.1
[[feasibility.trait]]
measure = "stalk.height"
mean = 2
deviation = 0.2
[[feasibility.line]]
name = "B73"
values = [0.76, 1.5]
)";
    return part.empty() ? text
                        : text.replace(text.find(part), part.size(), wrong);
}

TEST(Feasibility, LinesAreWrittenAsTheyAreRead) {
    const Campaign campaign = sample("", lines());
    ASSERT_TRUE(campaign.spec.feasibility.known_lines());
    EXPECT_EQ(campaign.spec.feasibility.limit, 2);
    EXPECT_EQ(campaign.spec.feasibility.lines.lines.at(0).name, "B73");
    EXPECT_EQ(parse_campaign(campaign.resolved, "a.toml").resolved,
              campaign.resolved);
    EXPECT_FALSE(sample().spec.feasibility.known_lines());
}

TEST(Feasibility, FilesOfLinesAreRead) {
    const std::string quick = IDEOTYPE_CAMPAIGNS "/ames_quick.toml";
    const auto value_of = [&](const std::string& name) {
        return read_campaign(quick,
                             {"feasibility={lines=\"lines/" + name + "\"}"})
            .spec.feasibility.lines;
    };
    EXPECT_EQ(value_of("maize_panel.toml").traits.size(), 7u);
    const MeasuredLines angles = value_of("maize_angles.toml");
    EXPECT_EQ(angles.lines.size(), 5u);
    const LineDistance expected =
        distance(angles, read_campaign(quick).crop.baseline);
    EXPECT_LT(expected.from_mean, 3);
    EXPECT_EQ(angles.lines[expected.line - 1].name, "B73 x PHW30");
}

TEST(Feasibility, ErrorsInLinesAreReported) {
    const auto tells = [](const std::string& part, const std::string& wrong,
                          const char* words) {
        const std::string message =
            problem_of(sample_text("", lines(part, wrong)));
        EXPECT_NE(message.find(words), message.npos) << message;
    };
    tells("stalk.height", "stalk.hight", "feasibility.trait names stalk.hight");
    tells("leaf = \"top\"\n", "", "leaf.length is a measure of leaves");
    tells("leaf = \"top\"", "leaf = \"fourth\"", "write for example leaf");
    tells("[0.76, 1.5]", "[0.76]", "there are 2 traits");
    tells("[0.5]", "[0.5, 0.5]", "2 traits have 1 pairs");
    tells("[0.5]", "[1]", "not positive definite");
    const std::string limit =
        problem_of(sample_text("", "[feasibility]\nlimit = 2\n"));
    EXPECT_NE(limit.find("and there are none"), limit.npos) << limit;
    const std::string objective = problem_of(
        sample_text("", "[objective]\nminimise = \"distance_from_lines\"\n"));
    EXPECT_NE(objective.find("add [feasibility]"), objective.npos) << objective;
    const std::string file = problem_of(
        sample_text("", "[feasibility]\nlines = \"nowhere.toml\"\n"));
    EXPECT_NE(file.find("named by feasibility.lines"), file.npos) << file;
}

}  // namespace
}  // namespace ideotype
