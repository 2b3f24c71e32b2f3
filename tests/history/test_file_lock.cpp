// SPDX-License-Identifier: Apache-2.0
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <fcntl.h>
#include <fstream>
#include <functional>
#include <optional>
#include <unistd.h>

#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/stat.h>
#include <sys/syscall.h>

#include "disk/file_lock.hpp"
#include "ideotype/core/error.hpp"
#include "sample_history.hpp"

namespace {

// The error number that imitates a file system without locks; 0 if locks work.
int lock_failure = 0;

}  // namespace

// Replaces fcntl of the C library.
extern "C" int fcntl(int descriptor, int command, ...) {
    va_list arguments;
    va_start(arguments, command);
    void* argument = va_arg(arguments, void*);
    va_end(arguments);
    if (lock_failure != 0 &&
        (command == F_OFD_SETLK || command == F_OFD_GETLK)) {
        errno = lock_failure;
        return -1;
    }
    return static_cast<int>(syscall(SYS_fcntl, descriptor, command, argument));
}

namespace ideotype {
namespace {

int catch_exit_code(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return static_cast<int>(error.exit_code());
    }
    return 0;
}

constexpr int refused = static_cast<int>(ExitCode::refused);

class WithoutLocks : public testing::TestWithParam<int> {
  protected:
    WithoutLocks() { lock_failure = GetParam(); }
    ~WithoutLocks() override { lock_failure = 0; }

    Folder folder;
    std::string path = folder / "case.h5";
};

TEST_P(WithoutLocks, SecondWriterOnThisHostIsRefused) {
    const History history = History::create(path, sample_header());
    EXPECT_EQ(run_in_other_process([&] {
                  if (find_writer(path) != Writer::alive) return 1;
                  return catch_exit_code([&] { History::resume(path); });
              }),
              refused);
}

TEST_P(WithoutLocks, KilledRunIsResumedWithAWarning) {
    EXPECT_EQ(run_in_other_process([&] {
                  History history = History::create(path, sample_header());
                  complete(history, 0);
                  return raise(SIGKILL);
              }),
              128 + SIGKILL);
    EXPECT_EQ(find_writer(path), Writer::killed);
    {
        History history = History::resume(path);
        history.begin_session({"2025-08-07T12:00:00Z", "node", "run", 1});
        complete(history, 1);
        EXPECT_EQ(history.next_generation(), 2U);
    }
    EXPECT_EQ(find_writer(path), Writer::closed);
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t messages = H5Dopen2(file, "messages/text", H5P_DEFAULT);
    const hid_t type = H5Dget_type(messages);
    std::vector<char> text(1000 * H5Tget_size(type));
    EXPECT_GE(
        H5Dread(messages, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), 0);
    EXPECT_TRUE(std::string(text.data())
                    .starts_with("this file system has no "
                                 "locks"))
        << text.data();
    H5Tclose(type);
    H5Dclose(messages);
    H5Fclose(file);
}

INSTANTIATE_TEST_SUITE_P(FileLock, WithoutLocks,
                         testing::Values(ENOLCK, EOPNOTSUPP, ENOSYS));

std::string read_text(const std::string& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST(FileLock, LockAppliesToTheHistoryUnderAnyName) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    const std::string link = folder / "link.h5";
    const History history = History::create(path, sample_header());
    std::filesystem::create_symlink(path, link);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / ""),
                            std::filesystem::directory_iterator()),
              2);
    for (const std::string& name : {path, link}) {
        EXPECT_EQ(find_writer(name), Writer::alive);
        EXPECT_EQ(run_in_other_process([&] {
                      return catch_exit_code([&] { History::resume(name); });
                  }),
                  refused);
    }
}

TEST(FileLock, SecondCreatorOfAHistoryIsRefused) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    const FileLock first = FileLock::create_new(path);
    EXPECT_EQ(run_in_other_process([&] {
                  return catch_exit_code(
                      [&] { History::create(path, sample_header()); });
              }),
              refused);
    EXPECT_FALSE(history_exists(path));
}

TEST(FileLock, FileLeftByAKilledProcessIsReused) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    std::ofstream(path + ".new") << "unfinished";
    History::create(path, sample_header());
    EXPECT_EQ(History::read(path).next_generation(), 0u);
    EXPECT_FALSE(std::filesystem::exists(path + ".new"));
}

TEST(FileLock, LinkedFilesAreNotOverwritten) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    const std::string precious = folder / "precious";
    const std::string unfinished = path + ".new";
    std::ofstream(precious) << "hi";
    const auto expect_refused = [&] {
        EXPECT_EQ(
            catch_exit_code([&] { History::create(path, sample_header()); }),
            refused);
        EXPECT_EQ(read_text(precious), "hi");
        EXPECT_FALSE(history_exists(path));
        std::filesystem::remove(unfinished);
    };
    std::filesystem::create_symlink(precious, unfinished);
    expect_refused();
    std::filesystem::create_hard_link(precious, unfinished);
    expect_refused();
    ASSERT_EQ(mkfifo(unfinished.c_str(), 0600), 0);
    expect_refused();
    // A link with the name of the locks of version 0.2.0 must not be followed.
    std::filesystem::create_symlink(precious, path + ".lock");
    History::create(path, sample_header());
    EXPECT_EQ(read_text(precious), "hi");
}

TEST(FileLock, LockOfTheNextWriterSurvivesRemovalOfTheFolder) {
    const Folder folder;
    const std::string path = folder / "results/case.h5";
    const std::string results = folder / "results";
    std::filesystem::create_directory(results);
    std::optional<History> first = History::create(path, sample_header());
    std::filesystem::remove_all(results);
    std::filesystem::create_directory(results);
    const History second = History::create(path, sample_header());
    first.reset();
    EXPECT_EQ(find_writer(path), Writer::alive);
    EXPECT_EQ(run_in_other_process([&] {
                  return catch_exit_code([&] { History::resume(path); });
              }),
              refused);
}

TEST(FileLock, ReadOnlyFolderIsNamedWithARemedy) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    History::create(path, sample_header());
    chmod((folder / "").c_str(), 0555);
    const int code = run_in_other_process([&] {
        // Root can write to read-only folders, so that the test gives up root.
        if (geteuid() == 0 && setuid(65534) != 0) return 1;
        if (History::read(path).next_generation() != 0) return 2;
        for (const auto& open : std::vector<std::function<void()>>{
                 [&] { History::resume(path); },
                 [&] { History::create(path + "2", sample_header()); }}) {
            try {
                open();
                return 3;
            } catch (const Error& error) {
                const std::string message = error.what();
                if (error.exit_code() != ExitCode::runtime) return 4;
                for (const std::string& part :
                     {std::string("Permission denied"), std::string("--out"),
                      std::filesystem::path(path).parent_path().string()})
                    if (message.find(part) == std::string::npos) return 5;
            }
        }
        return 0;
    });
    chmod((folder / "").c_str(), 0755);
    EXPECT_EQ(code, 0);
}

}  // namespace
}  // namespace ideotype
