// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <hdf5.h>

#include "sample_history.hpp"

namespace ideotype {
namespace {

// Reads all entries of a list, as laid out in analysis/FORMAT.md.
std::vector<std::string> read_texts(const std::string& path, const char* name,
                                    std::size_t size) {
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t dataset = H5Dopen2(file, name, H5P_DEFAULT);
    const hid_t type = H5Dget_type(dataset);
    EXPECT_EQ(H5Tget_size(type), size);
    const hid_t space = H5Dget_space(dataset);
    const auto rows =
        static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
    std::string bytes(rows * size, '\0');
    EXPECT_GE(
        H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), 0);
    H5Sclose(space);
    H5Tclose(type);
    H5Dclose(dataset);
    H5Fclose(file);
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < rows; ++i) {
        const std::string padded = bytes.substr(i * size, size);
        texts.push_back(padded.substr(0, padded.find('\0')));
    }
    return texts;
}

TEST(Journal, SessionsOfAllStartsAreStored) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    History::create(path, sample_header())
        .begin_session({"2025-08-07T12:00:00Z", "node1", "run a.toml", 4,
                        "ideotype 0.2", "GNU", "Embree"});
    History::resume(path).begin_session(
        {"2025-08-08T12:00:00Z", "node2", std::string(600, 'c'), 8});
    const auto started = read_texts(path, "sessions/started", 32);
    ASSERT_GT(started.size(), 3U);
    EXPECT_EQ(started[0], "2025-08-07T12:00:00Z");
    EXPECT_EQ(started[1], "2025-08-08T12:00:00Z");
    EXPECT_EQ(started[2], "");
    EXPECT_EQ(read_texts(path, "sessions/host", 64)[1], "node2");
    const auto command = read_texts(path, "sessions/command", 512);
    EXPECT_EQ(command[0], "run a.toml");
    EXPECT_EQ(command[1], std::string(512, 'c'));
    EXPECT_EQ(read_texts(path, "sessions/program", 64)[0], "ideotype 0.2");
    EXPECT_EQ(read_texts(path, "sessions/compiler", 64)[0], "GNU");
    EXPECT_EQ(read_texts(path, "sessions/libraries", 256)[0], "Embree");
}

TEST(Journal, LastStartIsReported) {
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

TEST(Journal, MessagesAreStoredInOrder) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    {
        History history = History::create(path, sample_header());
        history.message("first");
        history.message(std::string(300, 'x'));
    }
    History::resume(path).message("third");
    const auto rows = read_texts(path, "messages/text", 240);
    EXPECT_EQ(rows[0], "first");
    EXPECT_EQ(rows[1], std::string(240, 'x'));
    EXPECT_EQ(rows[2], "third");
    EXPECT_EQ(rows[3], "");
}

TEST(Journal, OldestMessagesAreKeptWhenFull) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    {
        History history = History::create(path, sample_header());
        for (int i = 0; i < 1001; ++i) history.message(std::to_string(i));
    }
    const auto rows = read_texts(path, "messages/text", 240);
    ASSERT_EQ(rows.size(), 1000U);
    EXPECT_EQ(rows.front(), "0");
    EXPECT_EQ(rows.back(), "999");
}

}  // namespace
}  // namespace ideotype
