// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <csignal>
#include <random>
#include <thread>
#include <unistd.h>

#include <gtest/gtest.h>

#include "sample_history.hpp"

namespace ideotype {
namespace {

constexpr std::uint32_t population = 8;
constexpr std::uint32_t generations = 50;
constexpr int kills = 30;

HistoryHeader long_header() {
    HistoryHeader header = sample_header();
    header.population = population;
    header.generations = generations;
    return header;
}

// A report from the writer: a durable row, or a committed generation if the
// slot is -1.
struct Report {
    std::uint32_t generation = 0;
    std::int32_t slot = -1;
};

// Evolves until the end or until it is killed, and reports through a pipe.
[[noreturn]] void write_history(const std::string& path, int pipe) {
    const auto report = [&](const Report& entry) {
        if (write(pipe, &entry, sizeof entry) != sizeof entry) _exit(3);
    };
    try {
        History history = std::filesystem::exists(path)
                              ? History::resume(path)
                              : History::create(path, long_header());
        history.begin_session({"2025-08-07T12:00:00Z", "node", "run", 1});
        for (auto g = history.next_generation(); g < generations; ++g) {
            propose(history, g, sample_candidates(g, population));
            for (const std::uint32_t slot : list_pending(history, g)) {
                history.record(g, slot, sample_outcome(g, slot), 1);
                report({g, static_cast<std::int32_t>(slot)});
            }
            history.commit(g, {.best_slot = g % population});
            history.message("generation " + std::to_string(g));
            report({g, -1});
        }
    } catch (const std::exception& error) {
        fprintf(stderr, "writer: %s\n", error.what());
        _exit(2);
    }
    _exit(0);
}

struct Killed {
    int status = 0;
    std::vector<Report> reports;
};

Killed write_and_kill(const std::string& path,
                      std::chrono::microseconds delay) {
    int ends[2];
    if (pipe(ends) != 0) return {};
    const pid_t writer = fork();
    if (writer == 0) {
        close(ends[0]);
        write_history(path, ends[1]);
    }
    close(ends[1]);
    // The pipe is read continuously, so that the writer never waits.
    std::thread killer([&] {
        std::this_thread::sleep_for(delay);
        kill(writer, SIGKILL);
    });
    Killed killed;
    Report report;
    while (read(ends[0], &report, sizeof report) == sizeof report)
        killed.reports.push_back(report);
    killer.join();
    close(ends[0]);
    waitpid(writer, &killed.status, 0);
    return killed;
}

void expect_outcome(const Row& row, std::uint32_t g, std::uint32_t slot) {
    const Outcome outcome = sample_outcome(g, slot);
    EXPECT_EQ(row.candidate.genome, sample_candidate(g, slot).genome);
    EXPECT_EQ(row.candidate.parents, sample_candidate(g, slot).parents);
    EXPECT_EQ(row.outcome.objectives[0].mean, outcome.objectives[0].mean);
    EXPECT_EQ(row.outcome.quantities[1].standard_error,
              outcome.quantities[1].standard_error);
    EXPECT_EQ(row.outcome.worker, outcome.worker);
    EXPECT_EQ(row.outcome.randomisations, outcome.randomisations);
}

// Expects that all finished rows are right, and that unfinished rows occur only
// in the last generation.
void expect_sound(const History& history) {
    for (std::uint32_t g = 0; g <= history.next_generation(); ++g) {
        if (g == generations) break;
        for (std::uint32_t slot = 0; slot < history.size(g); ++slot) {
            const Row row = history.row(g, slot);
            if (row.outcome.status == Status::done)
                expect_outcome(row, g, slot);
            else
                EXPECT_EQ(g, history.next_generation());
        }
    }
    const auto summaries = history.summaries();
    for (std::uint32_t g = 0; g < summaries.size(); ++g)
        EXPECT_EQ(summaries[g].best_slot, g % population);
}

TEST(Kill, ReportedRowsSurvive) {
    const Folder folder;
    std::mt19937 random(20250807);
    std::uniform_int_distribution<int> microseconds(300, 25000);
    int unfinished = 0;
    int files = 0;
    std::string path;
    for (int i = 0; i < kills; ++i) {
        if (path.empty()) path = folder / std::to_string(files++);
        SCOPED_TRACE("kill " + std::to_string(i) + " of file " + path);
        const Killed killed = write_and_kill(
            path, std::chrono::microseconds(microseconds(random)));
        if (WIFSIGNALED(killed.status))
            ++unfinished;
        else
            ASSERT_EQ(WEXITSTATUS(killed.status), 0);
        if (!std::filesystem::exists(path)) {
            EXPECT_TRUE(killed.reports.empty());
            continue;
        }
        const History history = History::read(path);
        for (const Report& report : killed.reports) {
            const auto g = report.generation;
            if (report.slot < 0) {
                EXPECT_GT(history.next_generation(), g);
                continue;
            }
            const auto slot = static_cast<std::uint32_t>(report.slot);
            const Row row = history.row(g, slot);
            EXPECT_EQ(row.outcome.status, Status::done);
            expect_outcome(row, g, slot);
        }
        expect_sound(history);
        if (HasFailure()) return;
        if (history.next_generation() == generations) path.clear();
    }
    EXPECT_GT(unfinished, kills / 2) << "most writers ended before the kill";
}

}  // namespace
}  // namespace ideotype
