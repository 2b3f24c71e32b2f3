// SPDX-License-Identifier: Apache-2.0
#include <csignal>
#include <fstream>
#include <functional>
#include <unistd.h>

#include <gtest/gtest.h>
#include <hdf5.h>

#include "checksum.hpp"
#include "handle.hpp"
#include "ideotype/core/error.hpp"
#include "sample_history.hpp"

namespace ideotype {
namespace {

struct Failure {
    std::string message = "no error";
    ExitCode exit_code = ExitCode::ok;
};

Failure catch_failure(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return {error.what(), error.exit_code()};
    }
    return {};
}

// Expects that opening the file for reading and for writing is refused, with
// the file name and the given reason.
void expect_refused(const std::string& path, const std::string& reason) {
    for (const auto open : {History::read, History::resume}) {
        const Failure failure = catch_failure([&] { open(path); });
        EXPECT_EQ(failure.exit_code, ExitCode::refused) << failure.message;
        EXPECT_TRUE(failure.message.starts_with(path + ": "))
            << failure.message;
        EXPECT_NE(failure.message.find(reason), std::string::npos)
            << failure.message;
        EXPECT_EQ(failure.message.find('\n'), std::string::npos);
    }
}

std::string read_contents(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void write_contents(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

TEST(Open, ExistingFileIsNotOverwritten) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    History::create(path, sample_header());
    const std::string before = read_contents(path);
    const Failure failure =
        catch_failure([&] { History::create(path, sample_header()); });
    EXPECT_EQ(failure.exit_code, ExitCode::refused);
    EXPECT_NE(failure.message.find("--resume"), std::string::npos);
    EXPECT_EQ(read_contents(path), before);
}

TEST(Open, MissingFileIsNamed) {
    const Folder folder;
    const std::string path = folder / "missing.h5";
    for (const auto open : {History::read, History::resume}) {
        const Failure failure = catch_failure([&] { open(path); });
        EXPECT_EQ(failure.exit_code, ExitCode::runtime);
        EXPECT_NE(failure.message.find(path), std::string::npos);
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder / ""));
}

TEST(Open, MissingFolderIsNamed) {
    const Folder folder;
    const Failure failure = catch_failure(
        [&] { History::create(folder / "none/case.h5", sample_header()); });
    EXPECT_EQ(failure.exit_code, ExitCode::runtime);
    EXPECT_NE(failure.message.find("/none: "), std::string::npos);
}

TEST(Open, OtherFilesAreRefused) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    write_contents(path, "");
    expect_refused(path, "not a history");
    write_contents(path, std::string(5000, 'x'));
    expect_refused(path, "not a history");
}

TEST(Open, TruncatedFileIsRefused) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    {
        History history = History::create(path, sample_header());
        complete(history, 0);
    }
    const auto size = std::filesystem::file_size(path);
    std::filesystem::resize_file(path, size - 1);
    expect_refused(path, "truncated");
    std::filesystem::resize_file(path, size / 2);
    expect_refused(path, "truncated");
}

TEST(Open, GenerationsBeforeTheCutAreSalvaged) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    const std::string cut = folder / "cut.h5";
    HistoryHeader header = sample_header();
    header.population = 500;
    {
        History history = History::create(path, header);
        for (std::uint32_t g = 0; g < 4; ++g) {
            propose(history, g, sample_candidates(g, 500));
            record_pending(history, g);
            history.commit(g, {});
        }
    }
    const std::string whole = read_contents(path);
    EXPECT_EQ(History::salvage(path).missing_bytes(), 0U);
    EXPECT_EQ(History::salvage(path).next_generation(), 4U);
    std::uint32_t left = 4;
    bool is_partly_left = false;
    for (std::size_t size = whole.size() - 1; size > 1'000'000;
         size -= 10'000) {
        write_contents(cut, whole.substr(0, size));
        const History history = History::salvage(cut);
        EXPECT_EQ(history.missing_bytes(), whole.size() - size);
        EXPECT_LE(history.next_generation(), left);
        left = history.next_generation();
        is_partly_left = is_partly_left || (left > 0 && left < 4);
        EXPECT_EQ(history.header().genes.size(), 3U);
        EXPECT_EQ(history.summaries().size(), 4U);
        for (std::uint32_t g = 0; g < left; ++g)
            for (const std::uint32_t slot : {0U, 499U}) {
                const Individual one = history.generation(g)[slot];
                const Outcome outcome = sample_outcome(g, slot);
                EXPECT_EQ(one.candidate.genome,
                          sample_candidate(g, slot).genome);
                EXPECT_EQ(one.objectives[0].mean, outcome.objectives[0].mean);
                EXPECT_EQ(one.objectives[0].standard_error,
                          outcome.objectives[0].standard_error);
            }
        EXPECT_EQ(read_contents(cut), whole.substr(0, size))
            << "it was changed";
    }
    EXPECT_TRUE(is_partly_left);
    EXPECT_EQ(left, 0U);
    write_contents(cut, whole.substr(0, 1000));
    const Failure failure = catch_failure([&] { History::salvage(cut); });
    EXPECT_EQ(failure.exit_code, ExitCode::refused);
    EXPECT_NE(failure.message.find("truncated: 1000 of"), std::string::npos)
        << failure.message;
}

// Writes a string attribute, to imitate another version of the program.
void set_attribute(const std::string& path, const std::string& name,
                   const std::string& value) {
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    const hid_t attribute = H5Aopen(file, name.c_str(), H5P_DEFAULT);
    const hid_t type = H5Aget_type(attribute);
    EXPECT_EQ(H5Tget_size(type), value.size());
    EXPECT_GE(H5Awrite(attribute, type, value.data()), 0);
    H5Tclose(type);
    H5Aclose(attribute);
    H5Fclose(file);
}

TEST(Open, OtherFormatIsRefused) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    History::create(path, sample_header());
    set_attribute(path, "format", "something-else-0");
    expect_refused(path, "not a history");
}

TEST(Open, OtherMajorVersionIsRefused) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    History::create(path, sample_header());
    set_attribute(path, "format_version", "3.0");
    expect_refused(path, "format version 3.0");
    set_attribute(path, "format_version", "1.0");
    EXPECT_NE(catch_failure([&] {
                  History::read(path);
              }).message.find("ideotype 0.2.1 reads it"),
              std::string::npos);
}

TEST(Open, OtherMinorVersionIsReadButNotResumed) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    History::create(path, sample_header());
    set_attribute(path, "format_version", "2.1");
    Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose,
                "open");
    const std::string checksum = header_checksum(file);
    file.close("close");
    set_attribute(path, "checksum", checksum);
    EXPECT_EQ(History::read(path).header().text.at("format_version"), "2.1");
    const Failure failure = catch_failure([&] { History::resume(path); });
    EXPECT_EQ(failure.exit_code, ExitCode::refused);
    EXPECT_NE(failure.message.find("resumes only 2.0"), std::string::npos)
        << failure.message;
}

TEST(Open, DamagedFileIsNamedQuickly) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    History::create(path, sample_header());
    std::string bytes = read_contents(path);
    const std::size_t at = bytes.find("format_version");
    ASSERT_NE(at, std::string::npos);
    bytes[at] = 'F';
    write_contents(path, bytes);
    for (const auto open : {History::read, History::resume}) {
        const Failure failure = catch_failure([&] { open(path); });
        EXPECT_EQ(failure.exit_code, ExitCode::runtime);
        EXPECT_TRUE(failure.message.starts_with(path + ": "))
            << failure.message;
    }
}

TEST(Open, SecondWriterIsRefusedWhileTheFirstLives) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    History history = History::create(path, sample_header());
    EXPECT_EQ(run_in_other_process([&] {
                  const std::string who =
                      "in use by process " + std::to_string(getppid());
                  for (const auto& open : std::vector<std::function<void()>>{
                           [&] { History::resume(path); },
                           [&] { History::create(path, sample_header()); }}) {
                      const Failure failure = catch_failure(open);
                      if (failure.exit_code != ExitCode::refused) return 1;
                      if (failure.message.find(who) == std::string::npos)
                          return 2;
                  }
                  return 0;
              }),
              0);
    complete(history, 0);
    EXPECT_EQ(history.next_generation(), 1U);
}

TEST(Open, ClosedHistoryLeavesOnlyItsFile) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    History::create(path, sample_header());
    History::resume(path);
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder / ""))
        names.push_back(entry.path().filename());
    EXPECT_EQ(names, std::vector<std::string>{"case.h5"});
}

TEST(Open, KilledFileIsReadAndResumed) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    EXPECT_EQ(run_in_other_process([&] {
                  History history = History::create(path, sample_header());
                  complete(history, 0);
                  propose(history, 1, sample_candidates(1));
                  history.record(1, 2, sample_outcome(1, 2), 1);
                  return raise(SIGKILL);
              }),
              128 + SIGKILL);
    EXPECT_EQ(list_pending(History::read(path), 1).size(), 3U);
    // Reading changes nothing, so that the file can be read again.
    EXPECT_EQ(History::read(path).next_generation(), 1U);
    {
        History history = History::resume(path);
        propose(history, 1, sample_candidates(1));
        record_pending(history, 1);
        history.commit(1, {});
    }
    const History history = History::read(path);
    EXPECT_EQ(history.next_generation(), 2U);
    EXPECT_EQ(history.row(1, 2).attempt, 1U);
}

}  // namespace
}  // namespace ideotype
