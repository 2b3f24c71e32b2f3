#include <array>
#include <cstring>

#include <gtest/gtest.h>
#include <hdf5.h>

#include "sample_history.hpp"

namespace ideotype {
namespace {

struct Session {
    std::array<char, 32> started;
    std::array<char, 64> host;
    std::array<char, 512> command;
    std::int32_t ranks;
};

using Message = std::array<char, 240>;

// All rows of a list, as analysis/FORMAT.md lays them out.
template <class Stored>
std::vector<Stored> read_list(const std::string& path, const char* name) {
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t dataset = H5Dopen2(file, name, H5P_DEFAULT);
    const hid_t type = H5Dget_type(dataset);
    EXPECT_EQ(H5Tget_size(type), sizeof(Stored));
    const hid_t space = H5Dget_space(dataset);
    std::vector<Stored> rows(
        static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    EXPECT_GE(
        H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.data()), 0);
    H5Sclose(space);
    H5Tclose(type);
    H5Dclose(dataset);
    H5Fclose(file);
    return rows;
}

template <std::size_t size>
std::string text(const std::array<char, size>& field) {
    return {field.data(), strnlen(field.data(), size)};
}

TEST(Journal, KeepsSessionsOfAllStarts) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    History::create(path, sample_header())
        .begin_session({"2025-08-07T12:00:00Z", "node1", "run a.toml", 4});
    History::resume(path).begin_session(
        {"2025-08-08T12:00:00Z", "node2", std::string(600, 'c'), 8});
    const auto rows = read_list<Session>(path, "sessions");
    ASSERT_GT(rows.size(), 3U);
    EXPECT_EQ(text(rows[0].started), "2025-08-07T12:00:00Z");
    EXPECT_EQ(text(rows[0].host), "node1");
    EXPECT_EQ(text(rows[0].command), "run a.toml");
    EXPECT_EQ(rows[0].ranks, 4);
    EXPECT_EQ(text(rows[1].host), "node2");
    EXPECT_EQ(text(rows[1].command), std::string(512, 'c'));
    EXPECT_EQ(rows[1].ranks, 8);
    EXPECT_EQ(text(rows[2].started), "");
}

TEST(Journal, TellsTheLastStart) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    {
        History history = History::create(path, sample_header());
        EXPECT_FALSE(history.last_session());
        history.begin_session({"2025-08-07T12:00:00Z", "node1", "first", 4});
    }
    History::resume(path).begin_session(
        {"2025-08-08T12:00:00Z", "node2", "second", 8});
    const auto last = History::read(path).last_session();
    ASSERT_TRUE(last);
    EXPECT_EQ(last->started, "2025-08-08T12:00:00Z");
    EXPECT_EQ(last->host, "node2");
    EXPECT_EQ(last->command, "second");
    EXPECT_EQ(last->ranks, 8);
}

TEST(Journal, KeepsMessagesInOrder) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    {
        History history = History::create(path, sample_header());
        history.message("first");
        history.message(std::string(300, 'x'));
    }
    History::resume(path).message("third");
    const auto rows = read_list<Message>(path, "messages");
    EXPECT_EQ(text(rows[0]), "first");
    EXPECT_EQ(text(rows[1]), std::string(240, 'x'));
    EXPECT_EQ(text(rows[2]), "third");
    EXPECT_EQ(text(rows[3]), "");
}

TEST(Journal, KeepsTheOldestMessagesWhenFull) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    {
        History history = History::create(path, sample_header());
        for (int i = 0; i < 1001; ++i) history.message(std::to_string(i));
    }
    const auto rows = read_list<Message>(path, "messages");
    ASSERT_EQ(rows.size(), 1000U);
    EXPECT_EQ(text(rows.front()), "0");
    EXPECT_EQ(text(rows.back()), "999");
}

}  // namespace
}  // namespace ideotype
