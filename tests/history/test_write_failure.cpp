// SPDX-License-Identifier: Apache-2.0
#include <csignal>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "ideotype/core/error.hpp"
#include "sample_history.hpp"

namespace ideotype {
namespace {

// Imitates a full disk by a limit on the size of files.
void limit_file_size(std::uintmax_t bytes) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, bytes};
    setrlimit(RLIMIT_FSIZE, &limit);
}

HistoryHeader large_header() {
    HistoryHeader header = sample_header();
    header.population = 1000;
    return header;
}

TEST(WriteFailure, FailureNamesTheFileAndKeepsRecordedRows) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    const int result = run_in_other_process([&] {
        History history = History::create(path, large_header());
        propose(history, 0, sample_candidates(0, 1000));
        for (std::uint32_t slot = 0; slot < 1000; ++slot)
            history.record(0, slot, sample_outcome(0, slot), 1);
        history.commit(0, {});
        limit_file_size(1000);
        try {
            propose(history, 1, sample_candidates(1, 1000));
            return 1;
        } catch (const Error& error) {
            const std::string message = error.what();
            if (!message.starts_with(path)) return 2;
            if (message.find("File too large") == std::string::npos) return 3;
        }
        // After a failed write the history stores nothing more, and reports
        // this.
        try {
            history.message("still here?");
            return 4;
        } catch (const Error&) {
        }
        return 0;
    });
    EXPECT_EQ(result, 0);

    History history = History::resume(path);
    EXPECT_EQ(history.next_generation(), 1U);
    EXPECT_EQ(history.row(0, 999).outcome.worker, 999U);
    propose(history, 1, sample_candidates(1, 1000));
    for (const std::uint32_t slot : list_pending(history, 1))
        history.record(1, slot, sample_outcome(1, slot), 1);
    history.commit(1, {});
    EXPECT_EQ(history.next_generation(), 2U);
}

// Returns the error message of committing a generation, or "".
std::string commit_and_catch(History& history) {
    try {
        complete(history, 0);
    } catch (const Error& error) {
        EXPECT_EQ(error.exit_code(), ExitCode::refused);
        return error.what();
    }
    return "";
}

TEST(WriteFailure, DeletedFileAcceptsNoMoreRows) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    History history = History::create(path, sample_header());
    EXPECT_NO_THROW(history.require_in_place());
    std::filesystem::remove(path);
    EXPECT_THROW(history.require_in_place(), Error);
    const std::string message = commit_and_catch(history);
    EXPECT_TRUE(message.starts_with(path + ": this file was deleted"))
        << message;
}

TEST(WriteFailure, TruncatedFileAcceptsNoMoreRows) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    History history = History::create(path, sample_header());
    propose(history, 0, sample_candidates(0));
    std::filesystem::resize_file(path, std::filesystem::file_size(path) - 1);
    try {
        history.record(0, 0, sample_outcome(0, 0), 1);
        FAIL() << "it was recorded";
    } catch (const Error& error) {
        EXPECT_EQ(error.exit_code(), ExitCode::refused);
        const std::string message = error.what();
        EXPECT_TRUE(message.starts_with(path + ": this file was cut"))
            << message;
    }
}

TEST(WriteFailure, ReplacedFileAcceptsNoRowsAndIsLeftUnchanged) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    History history = History::create(path, sample_header());
    std::filesystem::rename(path, folder / "away.h5");
    std::filesystem::copy_file(folder / "away.h5", path);
    EXPECT_NE(commit_and_catch(history), "");
    EXPECT_EQ(History::read(path).evaluated(), 0U);
    // The history can be used again once the file is back in its place.
    std::filesystem::rename(folder / "away.h5", path);
    EXPECT_EQ(commit_and_catch(history), "");
    EXPECT_EQ(history.next_generation(), 1U);
}

TEST(WriteFailure, ProgramDoesNotCrashAtExit) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    const pid_t child = fork();
    if (child == 0) {
        {
            History history = History::create(path, large_header());
            limit_file_size(1000);
            EXPECT_THROW(propose(history, 0, sample_candidates(0, 1000)),
                         Error);
        }
        exit(testing::Test::HasFailure() ? 1 : 0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST(WriteFailure, UnfinishedFileNeverHasTheFinalName) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    EXPECT_EQ(run_in_other_process([&] {
                  limit_file_size(2000);
                  try {
                      History::create(path, large_header());
                      return 1;
                  } catch (const Error& error) {
                      return std::string(error.what()).starts_with(path) ? 0
                                                                         : 2;
                  }
              }),
              0);
    EXPECT_TRUE(std::filesystem::is_empty(folder / ""));
    EXPECT_EQ(History::create(path, large_header()).next_generation(), 0U);
}

}  // namespace
}  // namespace ideotype
