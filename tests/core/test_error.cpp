// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"

namespace ideotype {

namespace {

Problem make_problem(Location where, std::string message) {
    return {std::move(where), "", ProblemCode::data, std::move(message)};
}

}  // namespace

TEST(Problem, ProblemIsFormattedAsFileLineColumn) {
    EXPECT_EQ(to_string(make_problem({"ames.toml", 12, 5}, "unknown key")),
              "ames.toml:12:5: unknown key");
}

TEST(Problem, UnknownLocationIsOmitted) {
    EXPECT_EQ(to_string(make_problem({"ames.toml"}, "is empty")),
              "ames.toml: is empty");
}

TEST(Error, DefaultIsARuntimeFailure) {
    EXPECT_EQ(Error("x").exit_code(), ExitCode::runtime);
    EXPECT_EQ(Error("x", ExitCode::refused).exit_code(), ExitCode::refused);
    EXPECT_STREQ(Error("no such file").what(), "no such file");
}

TEST(Error, ExitCodesAgreeWithTheManual) {
    EXPECT_EQ(static_cast<int>(ExitCode::ok), 0);
    EXPECT_EQ(static_cast<int>(ExitCode::runtime), 1);
    EXPECT_EQ(static_cast<int>(ExitCode::usage), 2);
    EXPECT_EQ(static_cast<int>(ExitCode::invalid_campaign), 3);
    EXPECT_EQ(static_cast<int>(ExitCode::refused), 4);
}

TEST(InputError, EveryProblemIsListedInOrder) {
    const InputError error({make_problem({"a.toml", 2, 1}, "first"),
                            make_problem({"a.toml", 9, 3}, "second")});
    EXPECT_STREQ(error.what(), "a.toml:2:1: first\na.toml:9:3: second");
    EXPECT_EQ(error.exit_code(), ExitCode::invalid_campaign);
    ASSERT_EQ(error.problems().size(), 2u);
    EXPECT_EQ(error.problems()[1].where.line, 9);
}

TEST(NearestName, MisspeltNameIsFound) {
    const std::vector<std::string> names{"latitude", "longitude", "elevation"};
    EXPECT_EQ(nearest_name("latitud", names), "latitude");
    EXPECT_EQ(nearest_name("lattitude", names), "latitude");
    EXPECT_EQ(nearest_name("longtitude", names), "longitude");
    EXPECT_EQ(nearest_name("elevation", names), "elevation");
}

TEST(NearestName, CloserNameIsPreferred) {
    EXPECT_EQ(nearest_name("row_spacin", {"plant_spacing", "row_spacing"}),
              "row_spacing");
    EXPECT_EQ(nearest_name("plan_spacing", {"row_spacing", "plant_spacing"}),
              "plant_spacing");
}

TEST(NearestName, WordsInAnotherOrderAreRecognised) {
    EXPECT_EQ(nearest_name("stalk.diameter_base",
                           {"stalk.top_diameter", "stalk.base_diameter"}),
              "stalk.base_diameter");
    EXPECT_EQ(nearest_name("order_dates", {"utc_offset", "date_order"}),
              "date_order");
}

TEST(NearestName, NoNameIsReturnedIfNoneIsNear) {
    EXPECT_EQ(nearest_name("colour", {"latitude", "longitude"}), "");
    EXPECT_EQ(nearest_name("latitude", {}), "");
    EXPECT_EQ(nearest_name("", {"latitude"}), "");
}

TEST(ShortQuotes, OnlyLongTextsAreShortened) {
    const std::string name(100, 'n'), list = "use one of a, b, c ";
    EXPECT_EQ(shorten_quotes("x is \"y\"; use z"), "x is \"y\"; use z");
    EXPECT_EQ(shorten_quotes("x is \"" + name + "\"; use z"),
              "x is \"" + std::string(60, 'n') + "... (100 bytes)\"; use z");
    EXPECT_EQ(shorten_quotes("key '" + name + "' is"),
              "key '" + std::string(59, 'n') + "... (102 bytes) is");
    EXPECT_EQ(shorten_quotes("\"" + name.substr(0, 50) + ' ' + name + '"'),
              '"' + std::string(50, 'n') + ' ' + std::string(9, 'n') +
                  "... (151 bytes)\"");
    // Quoted text from a file is shortened, but the program's own words and
    // paths are not.
    std::string lists;
    for (int i = 0; i < 9; ++i) lists += list;
    EXPECT_EQ(shorten_quotes(lists), lists);
    const std::string path = "cannot read /" + name + "/x.toml";
    EXPECT_EQ(shorten_quotes(path), path);
    // A multi-byte character is never split.
    std::string umlauts = "\"n";
    for (int i = 0; i < 50; ++i) umlauts += "\u00e4";
    EXPECT_EQ(shorten_quotes(umlauts).substr(0, 63),
              umlauts.substr(0, 60) + "...");
}

TEST(NearestName, TextOfMegabytesHasNoNearName) {
    const std::vector<std::string> names(1000, "curvature");
    EXPECT_EQ(nearest_name(std::string(10'000'000, 'c'), names), "");
    EXPECT_EQ(nearest_name("curvatures_of", names), "curvature");
}

}  // namespace ideotype
