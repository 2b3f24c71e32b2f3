// SPDX-License-Identifier: Apache-2.0
#include "evolve_case.hpp"

#include <utility>

#include "case_search.hpp"
#include "stand/stand.hpp"

namespace ideotype {

namespace {

//! Re-evaluates the baseline and the best distinct genomes of the last
//! generation. Returns false if a stop request came first.
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
        evolution.watcher.on_evaluation(done.task, outcome);
    };
    co_await evolution.dispatcher.evaluate(std::move(work), record);
    co_return history.pending_final().empty();
}

}  // namespace

SearchSpace search_space(const Campaign& campaign, const Case& chosen) {
    SearchSpace space{
        search_genes(campaign, chosen), baseline_genome(campaign), {}};
    for (const KeyFactor& each : campaign.varied.keys)
        space.baseline.push_back(each.number);
    for (const ObjectiveEntry& objective : objectives_of(campaign))
        space.senses.push_back(objective.sense);
    space.is_constrained = has_constraints(campaign.spec.constraints);
    return space;
}

Routine<Ending> evolve_case(Evolution evolution, History& history) {
    const double spent_before = history.wall_time();
    CaseSearch search(evolution, history);
    const NextWork next = [&] { return search.next(); };
    const Record record = [&](const Work& done, const Outcome& outcome) {
        search.record(done, outcome);
    };
    co_await evolution.dispatcher.evaluate(next, record);
    search.commit();
    history.set_wall_time(spent_before + evolution.elapsed());
    const auto reason = search.ending();
    if (!reason) co_return Ending::drained;
    evolution.watcher.on_final(*reason);
    const bool is_complete = co_await evaluate_finalists(evolution, history);
    history.set_wall_time(spent_before + evolution.elapsed());
    if (!is_complete) co_return Ending::drained;
    history.finish(*reason);
    co_return Ending::finished;
}

}  // namespace ideotype
