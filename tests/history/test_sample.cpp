// SPDX-License-Identifier: Apache-2.0
#include <set>

#include <gtest/gtest.h>
#include <hdf5.h>

#include "sample_history.hpp"

// Reads a history written by version 0.2.0, see tests/data/history. If a test
// here fails, the format has changed.

namespace ideotype {
namespace {

const std::string sample = IDEOTYPE_TEST_DATA "/history/format_2_0.h5";

TEST(Sample, HeaderIsRead) {
    const History history = History::read(sample);
    const HistoryHeader& header = history.header();
    EXPECT_EQ(header.text.at("format_version"), "2.0");
    EXPECT_EQ(header.text.at("case"), "ames_0807_762x152_all_r1");
    EXPECT_EQ(header.numbers.at("latitude"), 42.0);
    EXPECT_EQ(header.numbers.at("plant_spacing"), 0.1524);
    EXPECT_EQ(header.seed, 9750423567162723413U);
    EXPECT_EQ(header.population, 6);
    EXPECT_EQ(header.generations, 4);
    EXPECT_EQ(header.finalists, 3);
    ASSERT_EQ(header.genes.size(), 79U);
    EXPECT_EQ(header.genes[7].name, "leaf02_width");
    EXPECT_EQ(header.genes[7].unit, "m");
    EXPECT_EQ(header.genes[7].lower, 0.05);
    EXPECT_EQ(header.genes[7].upper, 0.14);
    EXPECT_FALSE(header.genes[7].is_circular);
    EXPECT_TRUE(header.genes[3].is_circular);
    ASSERT_EQ(header.schema.objectives.size(), 1U);
    EXPECT_EQ(header.schema.objectives[0].name, "absorbed_par");
    EXPECT_EQ(header.schema.objectives[0].unit, "MJ m-2 day-1");
    EXPECT_EQ(header.schema.measured.size(), 63U);
    EXPECT_TRUE(header.schema.measured.has("absorbed_by_layer"));
    EXPECT_EQ(header.schema.measured.axis("leaf_side").size(), 2U);
    EXPECT_EQ(std::get<0>(header.schema.measured.axis("layer").coordinates)[1],
              0.375);
    EXPECT_EQ(header.genes[8].trait, "insertion_angle");
    EXPECT_NE(header.campaign_source.find("# Makes the sample"),
              std::string::npos);
    EXPECT_NE(header.campaign_resolved.find("randomisations = 4"),
              std::string::npos);
}

TEST(Sample, RowsAreRead) {
    const History history = History::read(sample);
    EXPECT_EQ(history.finished(), "generations");
    const Row row = history.row(3, 4);
    EXPECT_EQ(row.outcome.status, Status::done);
    EXPECT_EQ(row.candidate.origin, Origin::child);
    EXPECT_EQ(row.candidate.parents, (std::array<std::int64_t, 2>{12, 14}));
    EXPECT_EQ(row.candidate.genome[7], 0.10248987086282312);
    EXPECT_EQ(row.outcome.objectives[0].mean, 10.375314388511304);
    EXPECT_EQ(row.outcome.violation, 0);
    EXPECT_EQ(row.outcome.objectives[0].standard_error, 0.3784693418232823);
    EXPECT_EQ(row.attempt, 1U);
    const auto summaries = history.summaries();
    ASSERT_EQ(summaries.size(), 4U);
    EXPECT_EQ(summaries[3].best_slot, 5U);
    EXPECT_EQ(summaries[3].best, 10.59557139073501);
    EXPECT_EQ(summaries[3].mean, 10.388675979723805);
    const auto finalists = history.finalists();
    ASSERT_EQ(finalists.size(), 3U);
    EXPECT_EQ(finalists[0].candidate.origin, Origin::baseline);
    EXPECT_EQ(finalists[2].outcome.objectives[0].mean, 10.274444431028046);
}

std::string read_unit(hid_t dataset) {
    if (H5Aexists(dataset, "units") <= 0) return "NO UNIT";
    const hid_t attribute = H5Aopen(dataset, "units", H5P_DEFAULT);
    const hid_t type = H5Aget_type(attribute);
    std::string unit(H5Tget_size(type), '\0');
    H5Aread(attribute, type, unit.data());
    H5Tclose(type);
    H5Aclose(attribute);
    return unit.c_str();
}

std::string describe_type(hid_t type) {
    std::string name = std::to_string(H5Tget_class(type)) + ":" +
                       std::to_string(H5Tget_size(type));
    const H5T_class_t kind = H5Tget_class(type);
    if (kind != H5T_COMPOUND && kind != H5T_ENUM) return name;
    const int members = H5Tget_nmembers(type);
    for (int i = 0; i < members; ++i) {
        char* member = H5Tget_member_name(type, static_cast<unsigned>(i));
        // The origin "sample" was introduced after this history was written.
        if (member != std::string("sample")) name += std::string(" ") + member;
        H5free_memory(member);
    }
    return name;
}

herr_t describe(hid_t file, const char* path, const H5O_info_t* info,
                void* target) {
    std::string text = path;
    if (info->type == H5O_TYPE_DATASET) {
        const hid_t dataset = H5Dopen2(file, path, H5P_DEFAULT);
        const hid_t type = H5Dget_type(dataset);
        const hid_t space = H5Dget_space(dataset);
        text += " " + describe_type(type) + " [" + read_unit(dataset) + "]";
        hsize_t sizes[3] = {0, 0, 0};
        const int rank = H5Sget_simple_extent_dims(space, sizes, nullptr);
        for (int i = 0; i < rank; ++i) text += " " + std::to_string(sizes[i]);
        H5Sclose(space);
        H5Tclose(type);
        H5Dclose(dataset);
    }
    static_cast<std::set<std::string>*>(target)->insert(text);
    return 0;
}

// Lists all objects of a file with path, type, unit and shape.
std::set<std::string> describe_objects(const std::string& path) {
    std::set<std::string> objects;
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    EXPECT_GE(file, 0);
    H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, describe, &objects,
              H5O_INFO_BASIC);
    H5Fclose(file);
    return objects;
}

TEST(Sample, NewFilesHaveTheSameObjects) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    {
        HistoryHeader header = History::read(sample).header();
        for (const char* name : {"format", "format_version", "checksum"})
            header.text.erase(name);
        History::create(path, header);
    }
    const auto expected = describe_objects(sample);
    const auto objects = describe_objects(path);
    EXPECT_GT(expected.size(), 50U);
    EXPECT_EQ(objects, expected);
    for (const std::string& object : objects)
        EXPECT_EQ(object.find("NO UNIT"), std::string::npos) << object;
}

}  // namespace
}  // namespace ideotype
