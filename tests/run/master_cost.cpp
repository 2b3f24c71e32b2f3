// SPDX-License-Identifier: Apache-2.0
//! Measures the cost of an evaluation for rank 0: evolves a case with workers
//! that only sleep, with the real loop, messages and history. Prints one line
//! per duration of an evaluation; nothing is asserted. Usage: mpirun -n RANKS
//! master_cost FOLDER
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include <fmt/format.h>
#include <sys/resource.h>

#include "once.hpp"
#include "run/evaluator.hpp"
#include "run/evolve_case.hpp"
#include "run/progress.hpp"
#include "run/provenance.hpp"

namespace ideotype {

namespace {

double cpu_seconds() {
    struct rusage usage {};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) +
               1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

//! Sleeps, then returns an outcome with all columns.
class SleepingEvaluator : public Evaluator {
  public:
    SleepingEvaluator(OutcomeSchema schema, double seconds)
        : schema_(std::move(schema)), seconds_(seconds) {}

    const OutcomeSchema& schema(const Task&) const override { return schema_; }

    Outcome evaluate(const Task&, const Genome& genome) override {
        std::this_thread::sleep_for(std::chrono::duration<double>(seconds_));
        Outcome outcome = unknown_outcome(schema_);
        outcome.for_each_number([](double& x) { x = 1; });
        outcome.status = Status::done;
        outcome.objectives.assign(schema_.objectives.size(), {genome[0], 0.1});
        return outcome;
    }

  private:
    OutcomeSchema schema_;
    double seconds_;
};

class Counter : public Watcher {
  public:
    void on_evaluation(const Task&, const Outcome&) override { ++evaluations; }
    void on_generation(std::uint32_t, std::uint32_t,
                       const GenerationSummary&) override {}
    void on_final(const std::string&) override {}

    int evaluations = 0;
};

void measure(Campaign campaign, double seconds, const Session& session,
             const StopFlag& stop, const std::string& folder) {
    const Case chosen = cases(campaign).front();
    const int workers = std::max(1, session.size() - 1);
    // Each measurement takes several seconds, and at least one generation.
    constexpr double enough = 4;
    constexpr double most_generations = 20;
    campaign.search.population = 100;
    campaign.stop.generations = static_cast<int>(std::clamp(
        enough * workers / (seconds * campaign.search.population + 1e-9), 1.0,
        most_generations));
    const HistoryHeader header = header_of(campaign, chosen, "none");
    SleepingEvaluator evaluator(header.schema, seconds);
    if (session.rank() != 0) return serve(session, {&evaluator});

    const std::string path =
        fmt::format("{}/cost_{}_{}.h5", folder, session.size(), seconds * 1e3);
    std::filesystem::remove(path);
    Counter counter;
    const auto dispatcher = make_dispatcher(session, {&evaluator}, stop);
    const double began = now();
    const double cpu_began = cpu_seconds();
    {
        History history = History::create(path, header);
        const auto optimizer = make_optimizer(
            campaign.search, search_space(campaign, chosen), chosen.seed);
        Once once(evolve_case({campaign, chosen, *optimizer, *dispatcher,
                               counter, [began] { return now() - began; }},
                              history));
        dispatcher->run(once);
    }
    const double cpu = cpu_seconds() - cpu_began;
    const double wall = now() - began;
    const double count = counter.evaluations + header.finalists;
    fmt::print("{:>7} {:>8.0f} {:>11.0f} {:>9.0f} {:>12.1f} {:>9.1f}\n",
               workers, seconds * 1e3, count, count / wall, cpu / count * 1e6,
               100 * cpu / wall);
    std::fflush(stdout);
    std::filesystem::remove(path);
}

}  // namespace

}  // namespace ideotype

int main(int argc, char** argv) {
    using namespace ideotype;
    const StopFlag stop;
    const Session session;
    const std::string folder = argc > 1 ? argv[1] : ".";
    const Campaign campaign = read_campaign(IDEOTYPE_CAMPAIGNS "/ames.toml");
    for (const double milliseconds : {0.0, 5.0, 100.0})
        measure(campaign, milliseconds / 1e3, session, stop, folder);
}
