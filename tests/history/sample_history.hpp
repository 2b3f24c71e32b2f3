// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "history/history.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/quantity.hpp"
#include "temporary_folder.hpp"

namespace ideotype {

//! Makes a header with 3 genes, 1 objective, a quantity along leaves, 4 slots,
//! 5 generations and 3 finalists.
inline HistoryHeader sample_header() {
    HistoryHeader header;
    header.text = {{"case", "ames-all-1"}, {"isa", "avx2"}, {"empty", ""}};
    header.numbers = {{"latitude", 42.0}, {"replicate", 1}};
    header.campaign_source = "# Übersicht\nname = \"ames\"\n";
    header.campaign_resolved = "name = \"ames\"\nseed = 1\n";
    header.genes = {
        {"leaf01_length", "m", 0.4, 1.1, false, true, "length", 1},
        {"leaf01_insertion_angle", "deg", 10, 80, false, false,
         "insertion_angle", 1},
        {"leaf01_azimuth", "deg", 0, 360, true, true, "azimuth", 1}};
    header.schema.objectives = {{"absorbed_par", "MJ m-2 day-1"}};
    header.schema.randomisations = 2;
    header.schema.measured = {
        {counted("leaf", "leaf rank", 2, 1)},
        {{"lai", "m2 m-2", "leaf area", {}, Certainty::exact},
         {"absorbed_by_leaf", "MJ m-2 day-1", "light", {"leaf"}}}};
    header.final_randomisations = 3;
    header.seed = 0xfedcba9876543210;
    header.population = 4;
    header.generations = 5;
    header.finalists = 3;
    return header;
}

//! Makes a candidate that is a function of generation and slot.
inline Candidate sample_candidate(std::uint32_t generation,
                                  std::uint32_t slot) {
    Candidate candidate;
    candidate.genome = {0.1 + generation / 3.0, 20.0 + slot / 7.0, -0.0};
    candidate.origin = generation == 0 ? Origin::random : Origin::child;
    if (generation > 0) candidate.parents = {1, static_cast<int>(slot)};
    return candidate;
}

inline std::vector<Candidate> sample_candidates(std::uint32_t generation,
                                                std::uint32_t count = 4) {
    std::vector<Candidate> candidates;
    for (std::uint32_t slot = 0; slot < count; ++slot)
        candidates.push_back(sample_candidate(generation, slot));
    return candidates;
}

inline Outcome sample_outcome(std::uint32_t generation, std::uint32_t slot,
                              std::size_t randomisations = 2) {
    const double x = generation + slot / 9.0;
    Outcome outcome;
    outcome.status = Status::done;
    outcome.objectives = {{x + 1 / 3.0, 0.01 + x}};
    outcome.randomisations.assign(randomisations, x);
    outcome.randomisations.back() += 2 / 3.0;
    outcome.quantities = {{3 + x, 0}, {1e-300, 0.03}, {-x, 0.04}};
    outcome.seconds = 0.5;
    outcome.worker = slot;
    return outcome;
}

//! Proposes all candidates of a generation.
inline std::size_t propose(History& history, std::uint32_t generation,
                           const std::vector<Candidate>& candidates) {
    return history.propose(generation, candidates.size(), 0, candidates);
}

//! Lists the slots of a generation that are proposed but neither done nor
//! failed.
inline std::vector<std::uint32_t> list_pending(const History& history,
                                               std::uint32_t generation) {
    std::vector<std::uint32_t> slots;
    for (std::uint32_t slot = 0; slot < history.size(generation); ++slot)
        if (history.row(generation, slot).outcome.status == Status::proposed)
            slots.push_back(slot);
    return slots;
}

//! Records all pending slots of a generation.
inline void record_pending(History& history, std::uint32_t generation) {
    for (const std::uint32_t slot : list_pending(history, generation))
        history.record(generation, slot, sample_outcome(generation, slot), 1);
}

//! Proposes, records and commits a generation.
inline void complete(History& history, std::uint32_t generation) {
    propose(history, generation, sample_candidates(generation));
    record_pending(history, generation);
    history.commit(generation, {.best_slot = 3, .best = generation + 0.5});
}

//! Runs an action in another process and returns its exit code, or 99 after an
//! exception. A second process is necessary because HDF5 cannot open a file for
//! reading and for writing in the same process.
template <class Action>
int run_in_other_process(Action action) {
    const pid_t child = fork();
    if (child == 0) {
        try {
            _exit(action());
        } catch (...) {
            _exit(99);
        }
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

//! A test with a new history that has the sample header, in a temporary folder.
class HistoryTest : public testing::Test {
  protected:
    //! Closes the history and opens it to continue.
    void reopen() {
        close();
        history = std::make_unique<History>(History::resume(path));
    }

    void close() { history.reset(); }

    Folder folder;
    std::string path = folder / "case.h5";
    std::unique_ptr<History> history =
        std::make_unique<History>(History::create(path, sample_header()));
};

//! Returns the error message of an action that must be refused.
inline std::string catch_refusal(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.exit_code() == ExitCode::refused
                   ? error.what()
                   : std::string("not refused: ") + error.what();
    }
    return "no error";
}

}  // namespace ideotype
