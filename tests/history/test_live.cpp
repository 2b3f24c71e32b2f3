// SPDX-License-Identifier: Apache-2.0
#include <functional>
#include <unistd.h>

#include <gtest/gtest.h>
#include <sys/syscall.h>

#include "sample_history.hpp"

namespace ideotype {
namespace {

//! A function that is called before each read of a file, including reads by
//! HDF5.
std::function<void()> before_read;

}  // namespace
}  // namespace ideotype

//! Replaces pread of the system.
extern "C" [[gnu::visibility("default")]] ssize_t pread(int file, void* bytes,
                                                        std::size_t count,
                                                        off_t first) {
    if (ideotype::before_read) ideotype::before_read();
    return syscall(SYS_pread64, file, bytes, count, first);
}

namespace ideotype {
namespace {

// A writer in another process, which proceeds step by step. The process of the
// test is the reader: a process forked while the file is open would inherit
// HDF5's cache instead of reading the file.
class Writer {
  public:
    using Step = std::function<void(History&)>;

    Writer(const std::string& path, const std::vector<Step>& steps) {
        if (pipe(go_) != 0 || pipe(done_) != 0)
            throw std::runtime_error("no pipe");
        process_ = fork();
        if (process_ != 0) return;
        ::close(go_[1]);
        try {
            History history = History::create(path, sample_header());
            for (const Step& step : steps) {
                wait(go_[0]);
                step(history);
                if (::write(done_[1], "d", 1) != 1) _exit(2);
            }
            wait(go_[0]);
        } catch (...) {
            _exit(1);
        }
        _exit(0);
    }

    ~Writer() {
        ::close(go_[1]);
        waitpid(process_, nullptr, 0);
        for (const int end : {go_[0], done_[0], done_[1]}) ::close(end);
    }

    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    //! Makes the writer take one step.
    void step() {
        ASSERT_EQ(::write(go_[1], "g", 1), 1);
        ASSERT_TRUE(wait(done_[0]));
    }

  private:
    static bool wait(int end) {
        char byte = 0;
        return ::read(end, &byte, 1) == 1;
    }

    int go_[2] = {-1, -1};
    int done_[2] = {-1, -1};
    pid_t process_ = -1;
};

void expect_row(const Row& row, std::uint32_t generation, std::uint32_t slot) {
    EXPECT_EQ(row.outcome.status, Status::done);
    EXPECT_EQ(row.candidate.genome, sample_candidate(generation, slot).genome);
    EXPECT_EQ(row.outcome.objectives[0].mean,
              sample_outcome(generation, slot).objectives[0].mean);
    EXPECT_EQ(row.attempt, 1U);
}

TEST(Live, FileIsReadWhileItIsWritten) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    Writer writer(path, {[](History& history) {
                      history.begin_session({"now", "node", "run", 1});
                      complete(history, 0);
                      propose(history, 1, sample_candidates(1));
                      history.record(1, 3, sample_outcome(1, 3), 1);
                  }});
    writer.step();
    const History live = History::read(path);
    EXPECT_EQ(live.next_generation(), 1U);
    EXPECT_EQ(list_pending(live, 1), (std::vector<std::uint32_t>{0, 1, 2}));
    expect_row(live.row(1, 3), 1, 3);
    expect_row(live.row(0, 2), 0, 2);
    EXPECT_EQ(live.generation(0).size(), 4U);
    EXPECT_EQ(live.summaries().size(), 1U);
    EXPECT_EQ(live.finished(), std::nullopt);
}

TEST(Live, OpenReaderSeesLaterRows) {
    const Folder folder;
    const std::string path = folder / "case.h5";
    std::vector<Writer::Step> steps{[](History&) {}};
    for (std::uint32_t g = 0; g < 5; ++g)
        steps.push_back([g](History& history) { complete(history, g); });
    steps.push_back([](History& history) { history.finish("generations"); });
    Writer writer(path, steps);
    writer.step();
    const History live = History::read(path);
    EXPECT_EQ(live.size(0), 0U);
    for (std::uint32_t g = 0; g < 5; ++g) {
        writer.step();
        EXPECT_EQ(live.next_generation(), g + 1);
        for (std::uint32_t slot = 0; slot < 4; ++slot)
            expect_row(live.row(g, slot), g, slot);
        EXPECT_EQ(live.summaries().size(), g + 1);
    }
    EXPECT_EQ(live.finished(), std::nullopt);
    writer.step();
    EXPECT_EQ(live.finished(), "generations");
}

TEST(Live, CaseMayFinishBetweenTwoReads) {
    constexpr int stride = 5;  // a larger stride keeps the test short
    int reads = 0;
    for (int position = 0; position <= reads; position += stride) {
        const Folder folder;
        const std::string path = folder / "case.h5";
        Writer writer(path, {[](History& history) { complete(history, 0); },
                             [](History& history) {
                                 complete(history, 1);
                                 history.propose_final(sample_candidates(2, 1));
                                 history.record_final(0,
                                                      sample_outcome(2, 0, 3));
                                 history.finish("generations");
                             }});
        writer.step();
        reads = 0;
        before_read = [&] {
            if (reads++ == position) writer.step();
        };
        EXPECT_NO_THROW(History::read(path)) << "before read " << position;
        before_read = nullptr;
    }
    EXPECT_GT(reads, 100);
}

}  // namespace
}  // namespace ideotype
