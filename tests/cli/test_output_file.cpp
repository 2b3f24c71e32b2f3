// SPDX-License-Identifier: Apache-2.0
// Files of the program are complete or absent, and replace no other file.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "cli/formats/output_file.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {

namespace {

namespace fs = std::filesystem;

class OutputFiles : public testing::Test {
  protected:
    void SetUp() override {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }

    std::string path(const char* name) const {
        return (folder_ / name).string();
    }

    std::string text(const char* name) const {
        std::ifstream file(folder_ / name);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    auto count() const {
        return std::distance(fs::directory_iterator(folder_), {});
    }

    void write(const char* name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
    }

    fs::path folder_ = fs::path(testing::TempDir()) / "output_files";
};

ExitCode refusal(const std::string& path) {
    try {
        OutputFile file(path);
    } catch (const Error& error) {
        return error.exit_code();
    }
    return ExitCode::ok;
}

TEST_F(OutputFiles, GetTheirNameWhenTheyAreComplete) {
    OutputFile file(path("a.csv"));
    file.print("{} {}", 1, 2);
    EXPECT_FALSE(fs::exists(path("a.csv")));
    file.finish();
    EXPECT_EQ(text("a.csv"), "1 2");
    EXPECT_EQ(count(), 1);
}

TEST_F(OutputFiles, AreAbsentIfTheyAreNotFinished) {
    { OutputFile(path("a.csv")).print("half"); }
    EXPECT_EQ(count(), 0);
}

TEST_F(OutputFiles, DoNotReplaceAFileThatAppearsMeanwhile) {
    {
        OutputFile file(path("a.csv"));
        file.print("late");
        write("a.csv", "early");
        EXPECT_THROW(file.finish(), Error);
    }
    EXPECT_EQ(text("a.csv"), "early");
    EXPECT_EQ(count(), 1);
}

TEST_F(OutputFiles, OfTwoProcessesDoNotMix) {
    OutputFile first(path("a.csv"));
    {
        OutputFile second(path("a.csv"));
        first.print("first");
        second.print("second");
        second.finish();
    }
    EXPECT_THROW(first.finish(), Error);
    EXPECT_EQ(text("a.csv"), "second");
}

TEST_F(OutputFiles, DoNotFollowSymbolicLinks) {
    write("precious", "precious");
    fs::create_symlink("precious", path("to_file"));
    fs::create_symlink("none", path("to_nothing"));
    fs::create_directory(path("folder"));
    for (const char* name : {"to_file", "to_nothing", "folder"})
        EXPECT_EQ(refusal(path(name)), ExitCode::refused) << name;
    EXPECT_EQ(text("precious"), "precious");
    EXPECT_FALSE(fs::exists(path("none")));
}

}  // namespace

}  // namespace ideotype
