// SPDX-License-Identifier: Apache-2.0
//! Measures where the time of rank 0 goes: evolves a case whose outcomes are
//! there at once and prints the processor time of each part [us per
//! evaluation]. Usage: master FOLDER [POPULATION...]
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "parallel/messages.hpp"
#include "run/evolve_case.hpp"
#include "run/provenance.hpp"

namespace ideotype {

namespace {

//! Measures the processor time since its last call [s].
class Stopwatch {
  public:
    double lap() {
        const double before = last_;
        last_ = now();
        return last_ - before;
    }

  private:
    static double now() {
        std::timespec time{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) +
               1e-9 * static_cast<double>(time.tv_nsec);
    }
    double last_ = now();
};

struct Parts {
    double ask = 0, propose = 0, messages = 0, record = 0, read = 0, tell = 0,
           commit = 0;
};

Outcome outcome_of(const OutcomeSchema& schema, const Genome& genome) {
    Outcome outcome = unknown_outcome(schema);
    outcome.for_each_number([](double& x) { x = 1; });
    outcome.status = Status::done;
    outcome.objectives.assign(schema.objectives.size(), {genome[0], 0.1});
    return outcome;
}

Parts measure(Campaign campaign, int population, int generations,
              const std::string& path) {
    const Case chosen = cases(campaign).front();
    campaign.search.population = population;
    campaign.stop.generations = generations;
    std::filesystem::remove(path);
    const HistoryHeader header = header_of(campaign, chosen, "none");
    History history = History::create(path, header);
    const SearchSpace space = search_space(campaign, chosen);
    const auto optimizer = make_optimizer(campaign.search, space, chosen.seed);
    Parts parts;
    Stopwatch watch;
    for (std::uint32_t g = 0; g < static_cast<std::uint32_t>(generations);
         ++g) {
        watch.lap();
        std::vector<Candidate> candidates;
        const auto size = static_cast<std::uint32_t>(optimizer->size(g));
        for (std::uint32_t slot = 0; slot < size; ++slot)
            candidates.push_back(optimizer->propose(g, slot));
        parts.ask += watch.lap();
        history.propose(g, candidates.size(), 0, candidates);
        parts.propose += watch.lap();
        for (std::uint32_t slot = 0; slot < size; ++slot) {
            Task task;
            task.generation = g;
            task.slot = slot;
            const Genome& genome = candidates[slot].genome;
            Outcome outcome = outcome_of(header.schema, genome);
            watch.lap();
            const Bytes work = encode_work({task, genome});
            parts.messages += watch.lap();
            const Bytes bytes = encode_reply({task, outcome});
            watch.lap();
            const Reply reply = decode_reply(bytes, header.schema);
            parts.messages += watch.lap();
            history.record(g, slot, reply.outcome, 1);
            parts.record += watch.lap();
        }
        const Population rows = history.generation(g);
        parts.read += watch.lap();
        for (const Individual& row : rows) optimizer->learn(row);
        const auto summary = summarize(rows, space.genes, space.senses.front());
        parts.tell += watch.lap();
        history.commit(g, summary);
        parts.commit += watch.lap();
    }
    return parts;
}

}  // namespace

}  // namespace ideotype

int main(int argc, char** argv) {
    using namespace ideotype;
    const std::string folder = argc > 1 ? argv[1] : ".";
    std::vector<int> populations;
    for (int i = 2; i < argc; ++i) populations.push_back(std::stoi(argv[i]));
    if (populations.empty()) populations = {100, 1000, 10000};
    const Campaign campaign = read_campaign(IDEOTYPE_CAMPAIGNS "/ames.toml");
    fmt::print(
        "population     ask propose messages  record    read    tell"
        "  commit     all\n");
    for (const int population : populations) {
        const int generations = std::max(3, 3000 / population);
        const std::string path = folder + "/master.h5";
        Parts parts = measure(campaign, population, generations, path);
        std::filesystem::remove(path);
        const double each = 1e6 / (population * generations);
        double sum = 0;
        fmt::print("{:>10}", population);
        for (const double part :
             {parts.ask, parts.propose, parts.messages, parts.record,
              parts.read, parts.tell, parts.commit}) {
            fmt::print(" {:>7.2f}", part * each);
            sum += part * each;
        }
        fmt::print(" {:>7.2f}\n", sum);
    }
}
