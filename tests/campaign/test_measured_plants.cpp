// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "campaign/campaign.hpp"
#include "campaign/reading/files.hpp"

namespace ideotype {

namespace {

namespace fs = std::filesystem;

//! A plant of two leaves in a folder of its own.
class MeasuredPlants : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() /
                  ("ideotype_" + std::string(::testing::UnitTest::GetInstance()
                                                 ->current_test_info()
                                                 ->name()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string written(const std::string& text,
                        const std::string& name = "field.csv") {
        const std::string path = (folder_ / name).string();
        std::ofstream(path) << text;
        return path;
    }

    Plant read(const std::string& text) {
        return read_crop(written(text), &other_).baseline;
    }

    //! Returns the message of the error, without the folder.
    std::string problems_of(const std::string& text) {
        try {
            read(text);
        } catch (const InputError& error) {
            std::string all = error.what();
            for (std::size_t at;
                 (at = all.find(folder_.string() + '/')) != std::string::npos;)
                all.erase(at, folder_.string().size() + 1);
            return all;
        }
        return "";
    }

    //! Two leaves, an ear at the higher one and 10 cm of stalk above it.
    static Plant other() {
        Plant plant;
        plant.leaves = {{.5, .05, 40, 60, 90, .2}, {.6, .06, 30, 50, 270, .4}};
        plant.blade.width_controls = {.3, .9, .9, 1.1, .4, 0};
        plant.stalk.height = .5;
        Organ ear;
        ear.name = "ear";
        ear.leaf = 2;
        ear.length = .2;
        ear.base_diameter = .05;
        plant.organs = {ear};
        return plant;
    }

    fs::path folder_;
    Plant other_ = other();
};

TEST_F(MeasuredPlants, ColumnsTellTheirUnitsAndConventions) {
    const Plant plant = read(
        "# row_direction: 100\n"
        "leaf,length_cm,width_mm,insertion_angle_from_horizontal_deg,"
        "azimuth_from_north_deg,insertion_height_m\n"
        "2,70.5,65,60,20,0.9\n"
        "1,\"35\",45,50,190,0.25\n");
    EXPECT_EQ(plant.name, "field");
    ASSERT_EQ(plant.leaves.size(), 2u);
    const Leaf& low = plant.leaves[0];
    EXPECT_EQ(low.length, .35);
    EXPECT_EQ(low.width, .045);
    EXPECT_EQ(low.insertion_angle, 40);
    EXPECT_EQ(low.azimuth, 90);
    EXPECT_EQ(low.insertion_height, .25);
    const Leaf& high = plant.leaves[1];
    EXPECT_EQ(high.length, .705);
    EXPECT_EQ(high.azimuth, 280);
    EXPECT_EQ(high.insertion_angle, 30);
    // Curvatures are those of the other plant.
    EXPECT_EQ(low.curvature, 60);
    EXPECT_EQ(high.curvature, 50);
}

TEST_F(MeasuredPlants, HeightsTellHowMuchALeafBends) {
    // The blade of the lower leaf is an arc of circle in the other plant's
    // form with an exponent of 1: its tip and top are known by trigonometry.
    other_.blade.curvature_exponent = 1;
    const double bend = 100, first = 40, last = first + bend;
    const auto sine = [](double x) {
        return std::sin(x * std::numbers::pi / 180);
    };
    const double radius = .5 / (bend * std::numbers::pi / 180);
    const double tip = .2 + radius * (sine(last) - sine(first));
    const double top = .2 + radius * (1 - sine(first));
    for (const auto& [column, height] :
         {std::pair{"tip_height", tip}, std::pair{"top_height", top}}) {
        const Plant plant = read(fmt::format("{}_mm\n{:.6f}\n{:.6f}\n", column,
                                             1000 * height, 900.));
        EXPECT_NEAR(plant.leaves[0].curvature, bend, .02) << column;
    }
    EXPECT_EQ(problems_of("top_height_cm\n300\n60\n"),
              "field.csv:2:1: the highest point of the leaf is at 3 m (a leaf "
              "of 0.5 m that leaves the stalk at 0.2 m by 40 deg has it at "
              "0.2569 .. 0.583 m); correct one of these");
    EXPECT_EQ(problems_of("curvature_deg,tip_height_cm\n9,50\n9,60\n"),
              "field.csv:1:15: tip_height_cm is given twice (curvature_deg "
              "too); remove one of the columns");
}

TEST_F(MeasuredPlants, DirectionsMayTurnEitherWay) {
    const auto azimuth = [&](const std::string& column) {
        return read(column + "\n-30\n390\n").leaves;
    };
    EXPECT_EQ(problems_of("azimuth_deg\n-30\n390\n"),
              "field.csv:3:1: azimuth_deg is 390 (expected: -360 .. 360); "
              "check the unit and the convention of the column");
    EXPECT_EQ(read("azimuth_deg\n-30\n360\n").leaves[0].azimuth, 330);
    EXPECT_EQ(read("azimuth_deg\n-30\n360\n").leaves[1].azimuth, 0);
    EXPECT_EQ(read("azimuth_from_row_counterclockwise_deg\n30\n0\n")
                  .leaves[0]
                  .azimuth,
              330);
    EXPECT_THROW(azimuth("azimuth_deg"), InputError);
}

TEST_F(MeasuredPlants, TheStalkGrowsWithTheHighestLeafAndItsOrgansGoAlong) {
    const std::string head =
        "length_cm,width_cm,insertion_angle_deg,curvature_deg,azimuth_deg,"
        "insertion_height_cm\n";
    const std::string leaf = "50,5,40,60,90,";
    const Plant plant =
        read(head + leaf + "20\n" + leaf + "40\n" + leaf + "160\n");
    ASSERT_EQ(plant.leaves.size(), 3u);
    EXPECT_NEAR(plant.stalk.height, 1.7, 1e-12);
    EXPECT_EQ(plant.organs[0].leaf, 3);
    EXPECT_EQ(read(head + leaf + "20\n").organs[0].leaf, 1);
}

TEST_F(MeasuredPlants, AllProblemsAreToldInOnePass) {
    EXPECT_EQ(
        problems_of("leaf,lenght_cm,width,insertion_angle_deg,"
                    "azimuth_from_north_deg,azimuth_deg\n"
                    "1,30,4,200,1,30\n"
                    "3,50,6,x,1,3\n"
                    "3,50,6,x,1\n"),
        "field.csv:1:6: there is no column 'lenght_cm'; did you mean "
        "'length_cm'?\n"
        "field.csv:1:16: column 'width' has no unit; name it width_cm\n"
        "field.csv:1:42: azimuth_from_north_deg needs the direction of the "
        "rows in which the plants stood (0 .. 360 deg clockwise from north); "
        "write a line such as # row_direction: 90\n"
        "field.csv:1:65: azimuth_deg is given twice (azimuth_from_north_deg "
        "too); remove one of the columns\n"
        "field.csv:2:8: insertion_angle_deg is 200 (expected: 0 .. 90); check "
        "the unit and the convention of the column\n"
        "field.csv:3:1: leaf 2 is missing (the lowest is 1, and ranks have no "
        "gaps); add it or renumber the leaves\n"
        "field.csv:3:8: insertion_angle_deg is \"x\" (which is no number); "
        "write one "
        "with a decimal point, or leave the column out\n"
        "field.csv:4:1: there are 5 entries (the table has 6 columns); give "
        "each column one");
    EXPECT_EQ(problems_of("leaf;length_cm\n1;20\n2;30\n")
                  .find("field.csv:1:1: columns are not separated by commas"),
              0u);
    EXPECT_NE(problems_of("").find("there are no leaves"), std::string::npos);
    EXPECT_EQ(problems_of("leaf,length_cm\n1,20\n1,30\n"),
              "field.csv:3:1: leaf 1 is given twice (each leaf has one line); "
              "remove one of the lines");
}

TEST_F(MeasuredPlants, LeavesAreCheckedAsThoseOfCropFiles) {
    EXPECT_EQ(problems_of("length_cm,width_cm\n30,40\n50,5\n"),
              "field.csv:2:4: leaf.width is 0.4 m (wider than its length of "
              "0.3 m); check the units: both are in m");
    EXPECT_EQ(problems_of("insertion_height_cm\n40\n20\n"),
              "field.csv:3:1: leaf.insertion_height is 0.2 m (below the leaf "
              "before it, at 0.4 m); list the lowest leaf first");
}

TEST_F(MeasuredPlants, OfOtherNumbersOfLeavesAllMeasuresAreNeeded) {
    const std::string problems =
        problems_of("length_cm,width_cm,azimuth_deg\n30,4,90\n");
    for (const std::string measure :
         {"insertion_angle of leaves (needed where plants do not have the 2 "
          "leaves of the crop); add insertion_angle_deg\n",
          "curvature of leaves (needed where plants do not have the 2 leaves "
          "of the crop); add curvature_deg or tip_height_cm or top_height_cm\n",
          "insertion_height"})
        EXPECT_NE(problems.find("field.csv:1:1: there is no column for the " +
                                measure),
                  std::string::npos)
            << problems;
}

TEST_F(MeasuredPlants, UnknownColumnsAreListedOnceWithTheKnownOnes) {
    const std::string problems = problems_of(
        "name,height,length_cm,biomass,yield\n1,200,30,1,9\n1,200,50,1,9\n");
    EXPECT_EQ(problems.find("field.csv:1:1: there are no columns 'name', "
                            "'height', 'biomass', 'yield' (a table has one "
                            "line for each leaf of a plant); columns are leaf, "
                            "plant or line, length_cm/_m/_mm, width_cm/_m/_mm, "
                            "insertion_angle_deg, "),
              0u)
        << problems;
    EXPECT_EQ(problems.find('\n'), std::string::npos) << problems;
    for (const std::string column : {"tip_height_cm", "petiole_angle_deg"})
        EXPECT_EQ(problems.find(column), problems.rfind(column)) << column;
}

TEST_F(MeasuredPlants, LeavesMayBeCountedFromLeavesThatAreGone) {
    const std::string counted = "leaf,length_cm\n1,40\n2,50\n";
    const std::string later = "leaf,length_cm\n6,50\n5,40\n";
    EXPECT_EQ(read(later).leaves[0].length, read(counted).leaves[0].length);
    EXPECT_EQ(read(later).leaves[1].length, .5);
    EXPECT_EQ(problems_of("leaf,length_cm\n5,40\n7,50\n"),
              "field.csv:3:1: leaf 6 is missing (the lowest is 5, and ranks "
              "have no gaps); add it or renumber the leaves");
}

TEST_F(MeasuredPlants, ATableOfSeveralPlantsIsReadWhole) {
    const std::string table =
        "line,leaf,length_cm\nDH 1,1,40\nDH 1,2,50\nDH 2,2,70\nDH 2,1,60\n";
    const std::vector<Crop> crops = read_crops(written(table), &other_);
    ASSERT_EQ(crops.size(), 2u);
    EXPECT_EQ(crops[0].baseline.name, "DH_1");
    EXPECT_EQ(crops[0].baseline.leaves[1].length, .5);
    EXPECT_EQ(crops[1].baseline.name, "DH_2");
    EXPECT_EQ(crops[1].baseline.leaves[0].length, .6);
    // The plants are also told where there is room for one alone.
    EXPECT_EQ(problems_of(table),
              "field.csv:1:1: the table has 2 plants (DH 1, DH 2), but one is "
              "needed here; choose it by a line such as # plant: DH 1, or give "
              "the table to ideotype compare, which takes all");
    EXPECT_EQ(read("# plant: DH 2\n" + table).leaves[1].length, .7);
    EXPECT_EQ(problems_of("# plant: DH 3\n" + table),
              "field.csv:2:1: there is no plant 'DH 3' (the table has DH 1, "
              "DH 2); did you mean 'DH 1'?");
    // All problems of all plants are reported once.
    try {
        read_crops(written("plant,leaf,lenght_cm,width_cm\na,1,40,x\n"
                           "a,2,40,5\nb,1,40,70\n,1,40,5\n"),
                   &other_);
        FAIL() << "a wrong table is read";
    } catch (const InputError& error) {
        ASSERT_EQ(error.problems().size(), 4u) << error.what();
        EXPECT_EQ(error.problems()[1].where.line, 2);
        EXPECT_EQ(error.problems()[2].where.line, 4);
    }
}

TEST_F(MeasuredPlants, ATableNamesItsCrop) {
    ASSERT_TRUE(known_crop("maize"));
    EXPECT_FALSE(known_crop("maze"));
    std::string lengths = "length_cm\n";
    for (int leaf = 1; leaf <= 10; ++leaf)
        lengths += std::to_string(50 + leaf) + "\n";
    const Crop maize = read_crop(written("# crop: maize\n" + lengths));
    EXPECT_EQ(maize.baseline.leaves[9].length, .6);
    EXPECT_EQ(maize.baseline.organs.size(), 4u);
    EXPECT_FALSE(maize.traits.empty());
    // A file may be named too, relative to the folder of the table; the named
    // file counts.
    written(*known_crop("maize"), "mine.toml");
    EXPECT_EQ(read("# crop: mine.toml,,\n" + lengths).organs.size(), 4u);
    const std::string problems = problems_of("# crop: mime.toml\n" + lengths);
    EXPECT_EQ(problems.find("field.csv:1:9: cannot read "), 0u) << problems;
    EXPECT_NE(problems.find("(named by # crop); did you mean 'mine.toml'?"),
              std::string::npos)
        << problems;
    // Nothing tells the remaining measures.
    try {
        read_crop(written(lengths));
        FAIL() << "a table without a crop is a plant";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what())
                      .find("field.csv:1:1: the table names no crop (which "
                            "tells stalk, organs and traits); begin it with a "
                            "line such as # crop: maize"),
                  std::string::npos);
    }
}

TEST_F(MeasuredPlants, TablesThatNameEachOtherAreToldAsOneCircle) {
    const std::string leaf = "leaf,length_cm\n1,50\n";
    EXPECT_EQ(problems_of("# crop: field.csv\n" + leaf),
              "field.csv:1:9: the table takes its crop from itself (field.csv "
              "-> field.csv); name a crop such as maize, or a crop file "
              "(.toml)");
    written("# crop: field.csv\n" + leaf, "b.csv");
    EXPECT_EQ(problems_of("# of today\n# crop: ./b.csv\n" + leaf),
              "b.csv:1:9: the table takes its crop from itself (b.csv -> "
              "field.csv -> b.csv); name a crop such as maize, or a crop file "
              "(.toml)");
    // Any file of the circle may begin it; a table that leads to the circle is
    // no part of it.
    written("# crop: c.csv\n" + leaf, "c.csv");
    fs::create_directory_symlink(folder_, folder_ / "same");
    EXPECT_EQ(problems_of("# crop: same/c.csv\n" + leaf),
              "same/c.csv:1:9: the table takes its crop from itself "
              "(same/c.csv -> same/c.csv); name a crop such as maize, or a "
              "crop file (.toml)");
    // A table may take its crop from another.
    std::string ten = "length_cm\n";
    for (int i = 0; i < 10; ++i) ten += "50\n";
    written("# crop: maize\n" + ten, "b.csv");
    EXPECT_EQ(problems_of("# crop: b.csv\n" + ten), "");
}

TEST_F(MeasuredPlants, ATableCanBeTheBaselineOfACampaign) {
    std::string table = "# crop: maize\nlength_cm\n";
    for (int leaf = 1; leaf <= 10; ++leaf) table += "55\n";
    written(table);
    const Campaign campaign =
        read_campaign(written("name = \"mine\"\n"
                              "[[site]]\nname = \"a\"\nlatitude = 42.0\n"
                              "longitude = -93.6\nutc_offset = -5\n"
                              "[[day]]\ndate = 2025-08-07\nstart = 07:00:00\n"
                              "end = 20:00:00\n"
                              "[[spacing]]\nrow = 0.762\nplant = 0.1524\n"
                              "[plant]\nbaseline = \"field.csv\"\n",
                              "mine.toml"));
    EXPECT_EQ(campaign.crop.baseline.leaves[3].length, .55);
    // A history needs no other file.
    const Campaign again = parse_campaign(campaign.resolved, "resolved");
    EXPECT_EQ(again.resolved, campaign.resolved);
    EXPECT_EQ(again.crop.baseline.name, "field");
}

TEST_F(MeasuredPlants, BoundsAreForWhatIsBred) {
    const auto campaign_with = [&](const std::string& plant) {
        return read_campaign(
            written("name = \"mine\"\n"
                    "[[site]]\nname = \"a\"\nlatitude = 42.0\n"
                    "longitude = -93.6\nutc_offset = -5\n"
                    "[[day]]\ndate = 2025-08-07\nstart = 07:00:00\n"
                    "end = 20:00:00\n"
                    "[[spacing]]\nrow = 0.762\nplant = 0.1524\n"
                    "[plant]\nbaseline = \"field.csv\"\n" +
                        plant,
                    "mine.toml"));
    };
    std::string table = "# crop: maize\nwidth_cm,insertion_angle_deg\n";
    for (int leaf = 1; leaf <= 10; ++leaf)
        table += leaf == 9 ? "4.2,5\n" : "8,30\n";
    written(table);
    // Commands that breed nothing take the plant.
    const Campaign mine = campaign_with("bounds = \"biological\"\n");
    EXPECT_EQ(mine.crop.baseline.leaves[8].width, .042);
    try {
        require_breedable(mine);
        FAIL() << "a baseline outside its bounds would be bred";
    } catch (const InputError& error) {
        EXPECT_EQ(error.problems().size(), 2u) << error.what();
    }
    // The message has the lines to write.
    const std::string advice = mine.outside_bounds.back().what;
    EXPECT_EQ(advice,
              "plant.bounds leave the baseline out (what is bred begins with "
              "it); delete bounds = \"...\" if it is there, and add at the end "
              "of the campaign:\n"
              "[plant.bounds]\n"
              "width = [0.0273, 0.10800000000000001]\n"
              "insertion_angle = [5, 80]");
    require_breedable(
        campaign_with(advice.substr(advice.find("[plant.bounds]")) + "\n"));
}

}  // namespace
}  // namespace ideotype
