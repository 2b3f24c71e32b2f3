// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "ideotype/core/error.hpp"
#include "sample_history.hpp"

namespace ideotype {
namespace {

// Expects that the path is refused, with a message that names what the file is
// instead of a history.
void expect_no_history(const std::string& path, const std::string& thing) {
    for (const auto& open : std::vector<std::function<void()>>{
             [&] { History::create(path, sample_header()); },
             [&] { History::resume(path); }, [&] { History::salvage(path); },
             [&] { History::read(path); }})
        try {
            open();
            ADD_FAILURE() << path << " was taken for a history";
        } catch (const Error& error) {
            const std::string message = error.what();
            EXPECT_TRUE(message.starts_with(path + ": ")) << message;
            EXPECT_NE(message.find(thing), std::string::npos) << message;
        }
}

TEST(Place, SpecialFilesAreRefusedWithoutWaiting) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    expect_no_history(path, "a named pipe");
    std::filesystem::remove(path);
    std::filesystem::create_directory(path);
    expect_no_history(path, "a folder");
    std::filesystem::remove(path);
    std::filesystem::create_symlink(path, path);
    expect_no_history(path, "symbolic links form a loop");
    expect_no_history("/dev/null", "a device");
}

}  // namespace
}  // namespace ideotype
