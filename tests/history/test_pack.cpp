// SPDX-License-Identifier: Apache-2.0
#include <csignal>
#include <fstream>

#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/resource.h>

#include "ideotype/core/error.hpp"
#include "ideotype/history/pack.hpp"
#include "sample_history.hpp"

namespace ideotype {
namespace {

class Pack : public testing::Test {
  protected:
    Pack() {
        HistoryHeader header = sample_header();
        header.population = 300;
        header.generations = 10;
        History history = History::create(path, header);
        history.begin_session({"2025-08-07T12:00:00Z", "node", "run", 3});
        for (std::uint32_t g = 0; g < 6; ++g) {
            history.propose(g, sample_candidates(g, 300));
            record_pending(history, g);
            history.commit(g, {.best_slot = g, .best = g + 0.5});
        }
        history.propose_final(sample_candidates(7, 3));
        for (const std::uint32_t slot : history.pending_final())
            history.record_final(slot, sample_outcome(7, slot, 3));
    }

    void finish() { History::resume(path).finish("stagnation"); }

    std::string contents() const {
        std::ifstream stream(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    //! The exit code of an attempt, and that it changed nothing.
    ExitCode code_of_failure() const {
        const std::string before = contents();
        ExitCode code = ExitCode::ok;
        try {
            pack_file(path);
        } catch (const Error& error) {
            code = error.exit_code();
            EXPECT_TRUE(std::string(error.what()).starts_with(path + ": "))
                << error.what();
        }
        EXPECT_EQ(contents(), before);
        EXPECT_FALSE(std::filesystem::exists(path + ".packed"));
        return code;
    }

    Folder folder;
    std::string path = folder / "case.h5";
};

TEST_F(Pack, MakesItSmallerAndReadsTheSame) {
    finish();
    std::filesystem::permissions(path, std::filesystem::perms(0640));
    const PackedSize size = pack_file(path);
    EXPECT_LT(size.after, size.before / 4);
    EXPECT_EQ(std::filesystem::status(path).permissions(),
              std::filesystem::perms(0640));
    for (const auto open : {History::read, History::resume}) {
        const History history = open(path);
        EXPECT_EQ(history.finished(), "stagnation");
        EXPECT_EQ(history.header().text.at("case"), "ames-all-1");
        EXPECT_EQ(history.header().genes.size(), 3U);
        EXPECT_EQ(history.next_generation(), 6U);
        EXPECT_EQ(history.summaries().at(5).best, 5.5);
        EXPECT_EQ(history.finalists().size(), 3U);
        for (const std::uint32_t slot : {0U, 299U}) {
            const Row row = history.row(5, slot);
            const Outcome outcome = sample_outcome(5, slot);
            EXPECT_EQ(row.candidate.genome, sample_candidate(5, slot).genome);
            EXPECT_EQ(row.candidate.parents, sample_candidate(5, slot).parents);
            EXPECT_EQ(row.outcome.objectives[0].mean,
                      outcome.objectives[0].mean);
            EXPECT_EQ(row.outcome.quantities[1].standard_error, 0.03);
            EXPECT_EQ(row.outcome.worker, slot);
        }
        EXPECT_EQ(history.size(6), 0U);
    }
}

TEST_F(Pack, KeepsUnitsAndDimensionScales) {
    finish();
    pack_file(path);
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    ASSERT_GE(file, 0) << "plain HDF5 cannot open it";
    const hid_t genome = H5Dopen2(file, "evaluations/genome", H5P_DEFAULT);
    EXPECT_GT(H5Aexists(genome, "units"), 0);
    EXPECT_GT(H5Aexists(genome, "DIMENSION_LIST"), 0);
    EXPECT_GT(H5Aexists(genome, "DIMENSION_LIST"), 0);
    const hid_t form = H5Dget_create_plist(genome);
    EXPECT_EQ(H5Pget_nfilters(form), 3);
    H5Pclose(form);
    H5Dclose(genome);
    H5Fclose(file);
}

TEST_F(Pack, ChangesNothingTheSecondTime) {
    finish();
    pack_file(path);
    const std::string before = contents();
    const PackedSize size = pack_file(path);
    EXPECT_EQ(size.before, size.after);
    EXPECT_EQ(contents(), before);
}

TEST_F(Pack, RefusesWhatIsNotFinished) {
    EXPECT_EQ(code_of_failure(), ExitCode::refused);
}

TEST_F(Pack, RefusesWhatIsInUse) {
    finish();
    const History history = History::resume(path);
    EXPECT_EQ(in_other_process([&] {
                  try {
                      pack_file(path);
                      return 0;
                  } catch (const Error& error) {
                      return static_cast<int>(error.exit_code());
                  }
              }),
              static_cast<int>(ExitCode::refused));
}

TEST_F(Pack, LeavesTheFileAsItWasIfTheDiskIsFull) {
    finish();
    EXPECT_EQ(in_other_process([&] {
                  signal(SIGXFSZ, SIG_IGN);
                  const rlimit limit{20'000, 20'000};
                  setrlimit(RLIMIT_FSIZE, &limit);
                  const bool is_told = code_of_failure() == ExitCode::runtime;
                  return is_told && !HasFailure() ? 0 : 1;
              }),
              0);
    EXPECT_EQ(History::read(path).next_generation(), 6U);
}

}  // namespace
}  // namespace ideotype
