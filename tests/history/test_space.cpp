// SPDX-License-Identifier: Apache-2.0
#include <csignal>
#include <fstream>
#include <functional>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "ideotype/core/error.hpp"
#include "sample_history.hpp"

namespace ideotype {
namespace {

HistoryHeader large_header() {
    HistoryHeader header = sample_header();
    header.population = 1000;
    header.generations = 20;
    return header;
}

// Imitates a full disk by a limit on the size of files.
void limit_file_size(std::uintmax_t bytes) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, bytes};
    setrlimit(RLIMIT_FSIZE, &limit);
}

std::intmax_t hole_bytes(const std::string& path) {
    struct stat status {};
    EXPECT_EQ(stat(path.c_str(), &status), 0);
    return status.st_size - status.st_blocks * 512;
}

// Returns the error message of an action in a process with a limit on the size
// of files.
std::string fail_under_limit(const Folder& folder, std::uintmax_t bytes,
                             const std::function<void()>& action) {
    const int code = run_in_other_process([&] {
        std::ofstream out(folder / "message");
        limit_file_size(bytes);
        try {
            action();
            return 1;
        } catch (const Error& error) {
            out << error.what();
        }
        return 0;
    });
    EXPECT_EQ(code, 0);
    std::ifstream message(folder / "message");
    return {std::istreambuf_iterator<char>(message), {}};
}

void expect_needed_and_free(const std::string& message) {
    for (const char* part :
         {"File too large", "MiB are needed", "MiB are free", "--out"})
        EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(Space, SpaceForTheWholeRunIsReservedAtOnce) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    History::create(path, large_header());
    EXPECT_GT(std::filesystem::file_size(path), 5'000'000U);
    EXPECT_LE(hole_bytes(path), 0);
}

TEST(Space, SpaceIsPredictedBeforeTheFileIsWritten) {
    for (const int generations : {1, 5, 16, 17, 24, 1000})
        for (const int size : {4, 7, 1000}) {
            HistoryHeader header = sample_header();
            header.generations = generations;
            header.population = size;
            const Folder folder;
            const std::string path = folder / "case.h5";
            History::create(path, header);
            const auto bytes =
                static_cast<double>(std::filesystem::file_size(path));
            EXPECT_NEAR(static_cast<double>(history_bytes(header)), bytes, 128)
                << generations << " x " << size;
        }
}

TEST(Space, LackOfSpaceIsReportedBeforeARunStarts) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    const std::string message = fail_under_limit(
        folder, 3'000'000, [&] { History::create(path, large_header()); });
    expect_needed_and_free(message);
    EXPECT_TRUE(message.starts_with(path + ": ")) << message;
    std::filesystem::remove(folder / "message");
    EXPECT_TRUE(std::filesystem::is_empty(folder / "")) << "left something";
}

TEST(Space, SpaceIsReservedForACopyWithHoles) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    const std::string copy = folder / "copy.h5";
    {
        History history = History::create(path, large_header());
        propose(history, 0, sample_candidates(0, 1000));
    }
    // Only the written parts are copied; the rest of the copy is a hole.
    constexpr std::uintmax_t written = 2'000'000;
    {
        std::ifstream source(path, std::ios::binary);
        std::string start(written, '\0');
        source.read(start.data(), written);
        std::ofstream(copy, std::ios::binary) << start;
    }
    std::filesystem::resize_file(copy, std::filesystem::file_size(path));
    EXPECT_GT(hole_bytes(copy), 3'000'000);
    History::resume(copy);
    EXPECT_LE(hole_bytes(copy), 0);
}

}  // namespace
}  // namespace ideotype
