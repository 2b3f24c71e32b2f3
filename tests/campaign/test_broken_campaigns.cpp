// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

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

//! Returns the error messages for a campaign file, with file names relative to
//! its folder; empty if there is no error.
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
        const std::string printed = messages(file);
        EXPECT_NE(printed, "") << file;
        EXPECT_EQ(printed, content(file.replace_extension(".txt"))) << file;
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
        EXPECT_STREQ(
            error.what(),
            "cannot read no/such/campaign.toml; name a file that can be read");
    }
}

TEST(BrokenCampaign, ResolvedCampaignsNeedNoOtherFiles) {
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
    EXPECT_EQ(problem_of(sample_text("", leaves))
                  .find("sample.toml:299:1: there are 41 tables [[leaf]] (the "
                        "limit is 40); remove some"),
              0u)
        << problem_of(sample_text("", leaves));
}

TEST(BrokenCampaign, OversizedInputIsRefusedBeforeAnyWork) {
    const auto refuses = [](const std::string& text,
                            const std::string& reason) {
        const std::string problem = problem_of(text);
        EXPECT_NE(problem.find(reason), std::string::npos) << problem;
        EXPECT_EQ(std::count(problem.begin(), problem.end(), '\n'), 0);
    };
    const auto many = [](int count, const std::string& table) {
        std::string text;
        for (int i = 0; i < count; ++i)
            text += fmt::format(fmt::runtime(table), i);
        return text;
    };
    refuses(sample_text("", many(41,
                                 "[[plant.baseline.organ]]\nname = \"o{}\"\n"
                                 "length = 0.1\nbase_diameter = 0.01\n")),
            "there are 41 tables [[organ]] (the limit is 40)");
    const std::string spacings =
        many(100, "[[spacing]]\nname = \"s{}\"\nrow = 0.3\nplant = 0.2\n");
    refuses(sample_text("replicates = 1000\n", spacings),
            "there are 101000 cases");
    EXPECT_EQ(
        problem_of(sample_text("replicates = 1000\n",
                               "[objective]\nover = \"spacing\"\n" + spacings)),
        "");
    // The number of rows must fit in 32 bits, in which histories number them.
    const std::string stop = "[search]\npopulation = 100000\n[stop]\n";
    refuses(sample_text("", stop + "generations = 21475\n"),
            "stop.generations is 21475 (with a population of 100000 a history "
            "would have more rows than 2147483647); use 21474 or fewer");
    EXPECT_EQ(problem_of(sample_text("", stop + "generations = 21474\n")), "");
    const std::string leaf =
        "[[plant.baseline.leaf]]\nlength = 0.8\nwidth = 0.08\n"
        "insertion_angle = 40\ncurvature = 60\nazimuth = 90\n"
        "insertion_height = 0.2\n";
    std::string field =
        sample_text("", "[field]\nrows = 100\nplants = 100\n" + many(5, leaf));
    field.replace(field.find("[plant]"), 7, "[plant]\ncells_along = 200");
    refuses(field,
            "plant.cells_along is 200 (the leaves of 100 x 100 plants have "
            "24000000 faces, the limit is 20000000)");
    std::string dates = "date = [2000-01-01";
    for (int year = 2001; year <= 2060; ++year)
        for (int day = 1; day < 29; ++day)
            dates += fmt::format(", {}-02-{:02}", year, day);
    std::string text = sample_text();
    text.replace(text.find("date = 2025-08-07"), 17,
                 dates + "]\nstep_minutes = 1");
    refuses(text, "that is 1311180 instants");
}

//! Returns a table [[object]]: one triangle of the given width and height [m]
//! with its lowest point at z [m].
std::string object(double width, double height, double z) {
    return fmt::format(
        "[[object]]\nname = \"post\"\nz = {}\nfaces = [0, 1, 2, 2]\n"
        "vertices = [0, 0, 0, {}, 0, 0, 0, 0.1, {}]\n",
        z, width, height);
}

TEST(BrokenCampaign, ObjectsMuchLargerThanTheCellAreRefused) {
    // The cell consists of 4 rows, 0.762 m apart, with 4 plants each, 0.1524 m
    // apart.
    EXPECT_EQ(problem_of(sample_text("", object(300, 1, 0))), "");
    EXPECT_EQ(problem_of(sample_text("", object(0.1, 600, 0))), "");
    const std::string wide = problem_of(sample_text("", object(1e6, 1, 0)));
    EXPECT_NE(wide.find("object.vertices \"post\" has a face of 1e+06 m along "
                        "x over a period of 3.048 m (the limit is 100 times "
                        "the period); check that it is in metres, or use a "
                        "smaller object"),
              std::string::npos)
        << wide;
    const std::string high = problem_of(sample_text("", object(0.1, 1e6, 0)));
    EXPECT_NE(high.find("is 1e+06 m high over a period of 0.6096 m"),
              std::string::npos)
        << high;
    // The limit follows the rotation and the size of the cell.
    const std::string more = "[field]\nrows = 20\n" + object(1000, 1, 0);
    EXPECT_EQ(problem_of(sample_text("", more)), "");
    EXPECT_NE(problem_of(sample_text("", more + "turn = 90\n")).find("along y"),
              std::string::npos);
}

TEST(BrokenCampaign, ObjectsBelowTheSoilCauseAWarning) {
    const auto warnings = [](double z) {
        std::string text;
        for (const Problem& each : sample("", object(0.1, 2, z)).warnings)
            text += each.what;
        return text;
    };
    EXPECT_EQ(warnings(0), "");
    EXPECT_EQ(warnings(1), "");
    EXPECT_EQ(warnings(-0.5),
              "object.vertices \"post\" reaches 0.5 m below the soil (z = 0), "
              "where there is no light; raise it by object.z");
    EXPECT_EQ(warnings(-5),
              "object.vertices \"post\" is below the soil (its top is at z = "
              "-3 m), so it has no effect; raise it by object.z");
}

TEST(BrokenCampaign, TwoWaysToSetTheDistanceInTheRowAreRefused) {
    std::string text = sample_text();
    text.replace(text.find("plant = 0.1524"), 0, "density = 8\n");
    EXPECT_NE(
        problem_of(text).find(
            "spacing has 'plant' = 0.1524 m and 'density' = 8 m-2, which both "
            "set the distance between neighbours in a row; remove one of them"),
        std::string::npos)
        << problem_of(text);
}

TEST(BrokenCampaign, KeysWithoutEffectAreWarnedOf) {
    const auto warnings =
        sample("", "[light]\ndates = 4\nstages = 3\n").warnings;
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_EQ(warnings[0].what,
              "light.dates has no effect without a [[climate]]; remove it, or "
              "give the weather of a season");
    EXPECT_EQ(warnings[1].key, "light.stages");
    EXPECT_TRUE(sample("", "[light]\nfields = 4\n").warnings.empty());
}

TEST(BrokenCampaign, NumbersThatAreNotFiniteAreNamed) {
    for (const char* value : {"nan", "inf", "-inf"})
        for (const std::string& text :
             {sample_text("", fmt::format("[field]\njitter = {}\n", value)),
              sample_text("", fmt::format("[field]\nrows = {}\n", value)),
              sample_text(fmt::format("seed = {}\n", value)),
              replaced(sample_text(), "07:00:00", value)}) {
            const std::string problem = problem_of(text);
            EXPECT_NE(
                problem.find(fmt::format(" is {} (not a finite number", value)),
                std::string::npos)
                << problem;
        }
}

TEST(BrokenCampaign, ABladeHasAWidth) {
    for (const char* controls : {"0, 0, 0, 0, 0, 0", "0, 0, 0, 0, 0, 1e-300"})
        EXPECT_NE(
            problem_of(sample_text("", fmt::format("[plant.baseline.blade]\n"
                                                   "width_controls = [{}]\n",
                                                   controls)))
                .find("blade.width_controls are all 0"),
            std::string::npos);
}

TEST(BrokenCampaign, PathsThatAreNotRegularFilesAreRefusedAtOnce) {
    const std::string folder = testing::TempDir();
    const std::string pipe = folder + "/pipe.csv";
    fs::remove(pipe);
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THROW(read_campaign(pipe), Error);
    const auto problem = [&](const std::string& plant) -> std::string {
        std::string text = sample_text();
        text = text.substr(0, text.find("bounds")) + "baseline = \"" + plant +
               "\"\n";
        try {
            read_campaign_text(text, folder + "/of_files.toml");
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    for (const auto& [plant, what] :
         {std::pair{"pipe.csv", "pipe.csv (a named pipe, no regular file)"},
          {"/dev/zero", "cannot read /dev/zero (a device, no regular file)"},
          {"/", "cannot read / (a folder, no regular file)"}})
        EXPECT_NE(problem(plant).find(what), std::string::npos)
            << problem(plant);
}

TEST(BrokenCampaign, MessagesShortenLongQuotes) {
    const std::string name(10'000'000, 'x');
    std::string text = sample_text();
    text.replace(text.find("Ames"), 4, name);
    for (const std::string& broken :
         {problem_of(text), problem_of(sample_text(name + " = 1\n")),
          problem_of(sample_text("", "[light]\nsky = \"" + name + "\"\n"))}) {
        EXPECT_NE(broken.find(std::string(59, 'x')), std::string::npos);
        EXPECT_EQ(broken.find(std::string(65, 'x')), std::string::npos)
            << broken.substr(0, 1000);
        EXPECT_LT(broken.size(), 1500u);
    }
}

TEST(BrokenCampaign, UnknownSkiesAreRefusedWithAListOfKnownOnes) {
    EXPECT_NE(problem_of(sample_text("", "[light]\nsky = \"cloudy\"\n"))
                  .find("light.sky is \"cloudy\" (not one of its values); use "
                        "\"uniform\" or \"overcast\" or \"clear\""),
              std::string::npos);
    EXPECT_NE(problem_of(sample_text("", "[light]\nsky = 3\n"))
                  .find("light.sky is an integer (expected: text)"),
              std::string::npos);
}

TEST(BrokenCampaign, FieldsDivideTheRandomisations) {
    EXPECT_NE(problem_of(sample_text("", "[light]\nfields = 3\n"))
                  .find("light.fields is 3 (too few"),
              std::string::npos);
    EXPECT_NE(problem_of(sample_text("", "[light]\nfields = 5\n"))
                  .find("light.fields is 5 (the 16"),
              std::string::npos);
}

TEST(BrokenCampaign, AssimilationInOneFieldNeedsRandomisations) {
    const std::string light = "[light]\ntolerance = 0\nrandomisations = 2\n";
    for (const std::string wanted : {"net_assimilation", "margin"})
        EXPECT_NE(
            problem_of(sample_text("", light + "[objective]\nmaximise = \"" +
                                           wanted + "\"\n"))
                .find("light.randomisations is 2 (too few for assimilation"),
            std::string::npos);
    EXPECT_NO_THROW(parse_campaign(sample_text("", light), "sample.toml"));
}

TEST(BrokenCampaign, LinesThatAreNotTomlGetAdvice) {
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

TEST(BrokenCampaign, QuotedValuesGetAdvice) {
    const std::string problem = problem_of(
        "[day]\nstart = \"05:00\"\ndate = \"15.07.2025\"\n"
        "[spacing]\nrow = \"0.762\"\nplant = \"six\"\n");
    for (const std::string advice :
         {"write start = 05:00:00 without quotes",
          "write date = 2025-07-15 without quotes",
          "write row = 0.762 without quotes", "write for example plant = "})
        EXPECT_NE(problem.find("; " + advice), std::string::npos) << problem;
}

TEST(BrokenCampaign, RemediesAreValid) {
    const auto expect = [](const std::string& problem,
                           const std::string& what) {
        EXPECT_NE(problem.find(what), std::string::npos) << problem;
    };
    expect(problem_of("[day]\ndate = \"2025-02-29\"\n"),
           "day.date is 2025-02-29 (the calendar has no such day)");
    std::string text = sample_text();
    text.insert(text.find("[[spacing]]"), "step_minutes = 36.9231\n");
    expect(problem_of(text), "use 32.5 or 39");
    expect(problem_of(sample_text("",
                                  "[search]\noptimizer = \"auto\"\n"
                                  "[stop]\ngenerations = 2\n")),
           "stop.generations is 2 (a race of auto begins with 3 times "
           "search.population plants); use 3 or more");
    // A message to a user who has not chosen an optimizer must not mention
    // `auto`.
    expect(problem_of(sample_text("", "[stop]\ngenerations = 2\n")),
           "stop.generations is 2 (the optimizer is \"auto\", since "
           "search.optimizer is not given; a race of auto begins with 3 times "
           "search.population plants); use 3 or more, or set "
           "search.optimizer = \"ga\"");
    expect(problem_of(sample_text("", "[search]\npopulation = 6\n")),
           "search.population is 6 (the optimizer is \"auto\", since "
           "search.optimizer is not given; CMA-ES ranks at least 8 plants); "
           "use 8 or more, or leave it out, or set search.optimizer = \"ga\"");
    expect(problem_of(sample_text("",
                                  "[search]\noptimizer = \"ga\"\n"
                                  "[stop]\ngain_left = 0.1\n")),
           "stop.gain_left is 0.1 (its statement was tested for the optimizer "
           "\"auto\" alone); use stop.no_gain, or set search.optimizer = "
           "\"auto\"");
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

TEST(BrokenCampaign, DotsInTextsCommentsAndNumbersDoNotSeparateKeys) {
    for (const std::string line :
         {"x = \"\\\"a.b.c.d.e.f.g.h.i.j\"", "x = 'a.b.c.d.e.f.g.h.i.j'",
          "# a.b.c.d.e.f.g.h.i.j",
          "x = [1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, "
          "1.0, 1.0, 1.0]",
          "x = \"\"\"\na.b.c.d.e.\"f.g.h.i.j\"\"\""})
        EXPECT_EQ(problem_of(line + '\n').find("parts"), std::string::npos)
            << line;
}

TEST(BrokenCampaign, CropFilesAreRefusedAsCampaigns) {
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
