#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <unistd.h>
#include <vector>

#include <sys/wait.h>

#include "ideotype/history/history.hpp"

namespace ideotype {

//! A folder of its own for each test, removed with everything in it.
class Folder {
  public:
    Folder() {
        std::string name =
            (std::filesystem::temp_directory_path() / "history-XXXXXX")
                .string();
        path_ = mkdtemp(name.data());
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::string operator/(const std::string& name) const {
        return (path_ / name).string();
    }

  private:
    std::filesystem::path path_;
};

//! 3 genes, 1 objective, 2 diagnostics; 4 slots, 5 generations, 3 finalists.
inline HistoryHeader sample_header() {
    HistoryHeader header;
    header.text = {{"case", "ames-all-1"}, {"isa", "avx2"}, {"empty", ""}};
    header.numbers = {{"latitude", 42.0}, {"replicate", 1}};
    header.campaign_source = "# Übersicht\nname = \"ames\"\n";
    header.campaign_resolved = "name = \"ames\"\nseed = 1\n";
    header.genes = {{"leaf01_length", "m", 0.4, 1.1, false, true},
                    {"leaf01_insertion_angle", "deg", 10, 80, false, false},
                    {"leaf01_azimuth", "deg", 0, 360, true, true}};
    header.schema = {{{"absorbed_par", "MJ m-2 day-1"}},
                     {{"lai", "m2 m-2"}, {"balance_error", "1"}}};
    header.seed = 0xfedcba9876543210;
    header.population = 4;
    header.generations = 5;
    header.finalists = 3;
    return header;
}

//! Any numbers, the same for the same generation and slot.
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

inline Outcome sample_outcome(std::uint32_t generation, std::uint32_t slot) {
    const double x = generation + slot / 9.0;
    Outcome outcome;
    outcome.status = Status::done;
    outcome.objectives = {{x + 1 / 3.0, 0.01 + x}};
    outcome.diagnostics = {{3 + x, 0.02}, {1e-300, 0.03}};
    outcome.seconds = 0.5;
    outcome.worker = slot;
    return outcome;
}

//! Records all that is pending of a generation.
inline void record_pending(History& history, std::uint32_t generation) {
    for (const std::uint32_t slot : history.pending(generation)) {
        const Outcome outcome = sample_outcome(generation, slot);
        history.record(generation, slot, outcome, outcome.objectives[0].mean,
                       1);
    }
}

//! Proposes, records and commits a generation.
inline void complete(History& history, std::uint32_t generation) {
    history.propose(generation, sample_candidates(generation));
    record_pending(history, generation);
    history.commit(generation, {.best_slot = 3, .best = generation + 0.5});
}

//! Exit code of a process that runs action, 99 if it threw. HDF5 does not let
//! one process have a file open to read and to write.
template <class Action>
int in_other_process(Action action) {
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

}  // namespace ideotype
