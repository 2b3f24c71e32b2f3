#include "ideotype/run/evolve_case.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"
#include "ideotype/run/evaluator.hpp"
#include "ideotype/search/duplicates.hpp"
#include "ideotype/search/order.hpp"
#include "ideotype/search/stop_rules.hpp"

namespace ideotype {

namespace {

//! Evaluates what is pending of a proposed generation. Under common random
//! numbers equal genomes have equal outcomes: they are evaluated once and
//! copied (attempt 0). False if a stop came first.
Routine<bool> evaluate_pending(const Evolution& evolution, History& history,
                               std::uint32_t generation,
                               const std::vector<Candidate>& candidates) {
    const auto original_of = duplicates(candidates);
    std::vector<Work> work;
    for (const std::uint32_t slot : history.pending(generation))
        if (!original_of.contains(slot)) {
            Task task;
            task.case_index =
                static_cast<std::uint32_t>(evolution.chosen.index);
            task.generation = generation;
            task.slot = slot;
            work.push_back({task, candidates[slot].genome});
        }
    const Record record = [&](const Work& done, const Outcome& outcome) {
        history.record(generation, done.task.slot, outcome, done.task.attempt);
        evolution.watcher.on_evaluation(generation);
    };
    co_await evolution.dispatcher.evaluate(std::move(work), record);
    const auto pending = history.pending(generation);
    const std::set<std::uint32_t> unknown(pending.begin(), pending.end());
    for (const auto& [slot, original] : original_of)
        if (unknown.contains(slot) && !unknown.contains(original)) {
            const Row row = history.row(generation, original);
            history.record(generation, slot, row.outcome, 0);
        }
    co_return history.pending(generation).empty();
}

void require_few_failures(const Evolution& evolution, History& history,
                          std::uint32_t generation, const Population& rows) {
    const auto failures = std::count_if(
        rows.begin(), rows.end(),
        [](const Individual& row) { return row.status == Status::failed; });
    const double limit = evolution.campaign.stop.failed_fraction *
                         static_cast<double>(rows.size());
    if (failures == 0 || static_cast<double>(failures) < limit) return;
    std::string reason;
    for (std::uint32_t slot = 0; reason.empty(); ++slot)
        reason = history.row(generation, slot).outcome.message;
    const std::string message = fmt::format(
        "{} of {} evaluations of generation {} failed, more than "
        "stop.failed_fraction allows; the first reason: {}",
        failures, rows.size(), generation, reason);
    history.message(message);
    throw CaseError(message);
}

//! Evaluates the baseline and the best distinct genomes of the last
//! generation again; false if a stop came first.
Routine<bool> evaluate_finalists(const Evolution& evolution, History& history) {
    const SearchSpace space =
        search_space(evolution.campaign, evolution.chosen);
    const auto count =
        static_cast<std::size_t>(evolution.campaign.final_rule.candidates);
    std::vector<Candidate> finalists{{space.baseline, Origin::baseline}};
    for (Candidate& each : evolution.optimizer.best(count))
        finalists.push_back(std::move(each));
    history.propose_final(finalists);
    std::vector<Work> work;
    for (const std::uint32_t slot : history.pending_final()) {
        Task task;
        task.case_index = static_cast<std::uint32_t>(evolution.chosen.index);
        task.slot = slot;
        task.is_final = true;
        work.push_back({task, finalists[slot].genome});
    }
    const Record record = [&](const Work& done, const Outcome& outcome) {
        history.record_final(done.task.slot, outcome);
    };
    co_await evolution.dispatcher.evaluate(std::move(work), record);
    co_return history.pending_final().empty();
}

}  // namespace

SearchSpace search_space(const Campaign& campaign, const Case& chosen) {
    SearchSpace space{
        gene_space(campaign, chosen), baseline_numbers(campaign.crop), {}};
    for (const Aim& aim : aims(campaign)) space.senses.push_back(aim.sense);
    return space;
}

Routine<Ending> evolve_case(Evolution evolution, History& history) {
    const auto& [campaign, chosen, optimizer, dispatcher, watcher, elapsed] =
        evolution;
    const SearchSpace space = search_space(campaign, chosen);
    const double spent_before = history.wall_time();

    Progress progress{{}, spent_before};
    for (std::uint32_t g = 0; g < history.next_generation(); ++g) {
        const Population rows = history.generation(g);
        optimizer.tell(rows);
        progress.generations.push_back(
            summarize(rows, space.genes, space.senses.front()));
    }
    std::optional<std::string> reason;
    while (
        !(reason = finished(campaign.stop, progress, space.senses.front()))) {
        const std::uint32_t g = history.next_generation();
        const std::vector<Candidate> candidates = optimizer.ask();
        history.propose(g, candidates);
        const bool is_complete =
            co_await evaluate_pending(evolution, history, g, candidates);
        history.set_wall_time(spent_before + elapsed());
        if (!is_complete) co_return Ending::drained;

        const Population rows = history.generation(g);
        require_few_failures(evolution, history, g, rows);
        optimizer.tell(rows);
        GenerationSummary summary =
            summarize(rows, space.genes, space.senses.front());
        summary.wall_time = history.wall_time();
        history.commit(g, summary);
        watcher.on_generation(g, summary);
        progress.generations.push_back(summary);
        progress.wall_time = summary.wall_time;
    }
    watcher.on_final(*reason);
    const bool is_complete = co_await evaluate_finalists(evolution, history);
    history.set_wall_time(spent_before + elapsed());
    if (!is_complete) co_return Ending::drained;
    history.finish(*reason);
    co_return Ending::finished;
}

}  // namespace ideotype
