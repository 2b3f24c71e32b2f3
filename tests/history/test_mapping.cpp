// SPDX-License-Identifier: Apache-2.0
#include <csignal>
#include <fcntl.h>

#include <gtest/gtest.h>

#include "dataset.hpp"
#include "disk/open.hpp"
#include "ideotype/core/error.hpp"
#include "sample_history.hpp"

namespace ideotype {
namespace {

class MappingTest : public testing::Test {
  protected:
    MappingTest() {
        initialize_hdf5();
        History::create(path_, sample_header());
        file_ = open_to_write(path_);
    }

    Folder folder_;
    std::string path_ = folder_ / "case.h5";
    Handle file_;
};

TEST_F(MappingTest, MappedBytesEqualThoseOfHdf5) {
    const auto mapping = Mapping::create(file_);
    ASSERT_TRUE(mapping);
    for (const char* name : {"evaluations/absorbed_by_leaf", "final/seconds"}) {
        Dataset by_hdf5(file_, name), by_memory(file_, name);
        by_memory.use(*mapping);
        std::vector<double> row(by_hdf5.width(), 1.5), other = row;
        other.back() = -2.5;
        by_memory.write(1, row);
        by_hdf5.write(2, other);
        EXPECT_EQ(by_hdf5.read<double>(1, 1), row) << name;
        EXPECT_EQ(by_memory.read<double>(2, 1), other) << name;
    }
    Dataset by_hdf5(file_, "evaluations/message"),
        by_memory(file_, "evaluations/message");
    by_memory.use(*mapping);
    by_memory.write_text(3, "too tall");
    EXPECT_EQ(by_hdf5.read_text(2, 2),
              (std::vector<std::string>{"", "too tall"}));
}

TEST_F(MappingTest, MissingRowsAreRefused) {
    const auto mapping = Mapping::create(file_);
    Dataset seconds(file_, "evaluations/seconds");
    seconds.use(*mapping);
    const std::vector<double> two{1, 2};
    EXPECT_NO_THROW(seconds.write(seconds.rows() - 2, two));
    EXPECT_THROW(seconds.write(seconds.rows() - 1, two), Hdf5Error);
    EXPECT_THROW(seconds.read<double>(seconds.rows(), 1), Hdf5Error);
}

TEST_F(MappingTest, FileWithHolesIsNotMapped) {
    const auto size = std::filesystem::file_size(path_);
    ASSERT_EQ(
        fallocate(get_descriptor(file_),
                  FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE,
                  static_cast<off_t>(size / 2), static_cast<off_t>(size / 2)),
        0);
    EXPECT_FALSE(Mapping::create(file_));
}

TEST_F(MappingTest, MappingEndsWithTheLastBlock) {
    haddr_t end = 0;
    ASSERT_GE(H5Fget_eoa(file_, &end), 0);
    const auto cut = [&](haddr_t size) {
        ASSERT_EQ(ftruncate(get_descriptor(file_), static_cast<off_t>(size)),
                  0);
    };
    cut(end + 4096);
    const auto mapping = Mapping::create(file_);
    ASSERT_TRUE(mapping);
    cut(end);
    EXPECT_TRUE(mapping->is_whole());
    cut(end - 1);
    EXPECT_FALSE(mapping->is_whole());
}

TEST_F(MappingTest, RecordedRowSurvivesAnImmediateKill) {
    file_ = {};
    const pid_t child = fork();
    if (child == 0) {
        History history = History::resume(path_);
        propose(history, 0, sample_candidates(0));
        history.record(0, 2, sample_outcome(0, 2), 1);
        kill(getpid(), SIGKILL);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    const History history = History::read(path_);
    EXPECT_EQ(history.row(0, 2).outcome.status, Status::done);
    EXPECT_EQ(history.row(0, 2).outcome.objectives[0].mean,
              sample_outcome(0, 2).objectives[0].mean);
    EXPECT_EQ(history.row(0, 1).outcome.status, Status::proposed);
}

}  // namespace
}  // namespace ideotype
