// SPDX-License-Identifier: Apache-2.0
#include "case_search.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "search/population.hpp"

namespace ideotype {

namespace {

//! The fraction of failed evaluations in a generation that ends a case with an
//! error.
constexpr double most_failures = 0.5;

void require_few_failures(History& history, std::uint32_t generation,
                          const Population& rows) {
    const auto failures = std::count_if(
        rows.begin(), rows.end(),
        [](const Individual& row) { return row.status == Status::failed; });
    const double limit = most_failures * static_cast<double>(rows.size());
    if (failures == 0 || static_cast<double>(failures) < limit) return;
    std::string reason;
    for (std::uint32_t slot = 0; reason.empty(); ++slot)
        reason = history.row(generation, slot).outcome.message;
    const std::string message = fmt::format(
        "{} of {} evaluations of generation {} failed (a case ends when half "
        "of them do); the first reason: {}",
        failures, rows.size(), generation, reason);
    history.message(message);
    throw CaseError(message);
}

}  // namespace

CaseSearch::CaseSearch(const Evolution& evolution, History& history)
    : evolution_(evolution),
      history_(history),
      space_(search_space(evolution.campaign, evolution.chosen)),
      summarized_(space_.genes, space_.senses,
                  evolution.campaign.search.reference),
      spent_before_(history.wall_time()),
      progress_{{}, spent_before_} {
    for (std::uint32_t g = 0; g < history.next_generation(); ++g) {
        Population rows = history.generation(g);
        if (!evolution_.campaign.search.axes.empty()) {
            const std::vector<Row> known = history.rows(g);
            for (std::size_t i = 0; i < rows.size(); ++i)
                rows[i].features = features_of(known[i].outcome);
        }
        const GenerationSummary summary = summarized_(rows);
        known_rows_ += rows.size();
        judge(summary, rows);
        for (Individual& row : rows) evolution.optimizer.learn(std::move(row));
    }
}

std::optional<Work> CaseSearch::next() {
    if (waiting_.empty()) {
        learn();
        extend();
    }
    if (waiting_.empty()) return std::nullopt;
    Work work = std::move(waiting_.front());
    waiting_.pop_front();
    return work;
}

void CaseSearch::record(const Work& work, const Outcome& outcome) {
    // Commit only now, when workers have already received new work.
    commit();
    const Task& task = work.task;
    history_.record(task.generation, task.slot, outcome, task.attempt);
    evolution_.watcher.on_evaluation(task, outcome);
    keep(task.generation, task.slot, outcome);
}

std::optional<std::string> CaseSearch::ending() const {
    if (!open_.empty() || !is_over(first_open())) return std::nullopt;
    return reason_.value_or("room");
}

//! Returns whether the search ends before a generation. Call it only when all
//! rows on which the generation depends are known.
bool CaseSearch::is_over(std::uint32_t generation) const {
    const Optimizer& optimizer = evolution_.optimizer;
    const auto limit =
        static_cast<std::uint32_t>(evolution_.campaign.stop.generations);
    return generation >= limit ||
           (reason_ && optimizer.needs(generation) >= reason_row_) ||
           !history_.has_room(generation, optimizer.size(generation));
}

//! Proposes rows until one of them waits for evaluation or no more can be
//! proposed.
void CaseSearch::extend() {
    while (waiting_.empty() && (is_proposing() || begin_generation())) {
        propose();
        // Learn rows that an earlier session evaluated, since they may allow
        // more proposals.
        learn();
    }
}

//! Proposes a batch of rows of the last open generation. Workers can evaluate
//! them while further rows are proposed.
void CaseSearch::propose() {
    constexpr std::size_t batch = 64;
    const Open& last = open_.back();
    const auto generation =
        first_open() + static_cast<std::uint32_t>(open_.size()) - 1;
    std::vector<Candidate> candidates;
    for (std::size_t i = last.rows.size();
         i < last.size && candidates.size() < batch; ++i)
        candidates.push_back(evolution_.optimizer.propose(
            generation, static_cast<std::uint32_t>(i)));
    add(candidates);
}

//! Begins the next generation. Returns false if there is none, or if rows on
//! which it depends are not known yet.
bool CaseSearch::begin_generation() {
    Optimizer& optimizer = evolution_.optimizer;
    const auto generation =
        first_open() + static_cast<std::uint32_t>(open_.size());
    if (known_rows_ < optimizer.needs(generation) || is_over(generation))
        return false;
    open_.emplace_back().size = optimizer.size(generation);
    return true;
}

//! Stores candidates of the last open generation in the history. They may be
//! handed out only afterwards.
void CaseSearch::add(const std::vector<Candidate>& candidates) {
    Open& open = open_.back();
    const auto generation =
        first_open() + static_cast<std::uint32_t>(open_.size()) - 1;
    const auto first = static_cast<std::uint32_t>(open.rows.size());
    const std::size_t stored =
        history_.propose(generation, open.size, first, candidates);
    for (const Candidate& candidate : candidates) {
        const auto slot = static_cast<std::uint32_t>(open.rows.size());
        open.rows.push_back({candidate, Status::proposed, {}, 0});
        const std::uint32_t original =
            evolution_.campaign.has_light_by_row
                ? slot
                : open.first_slots.emplace(candidate.genome, slot)
                      .first->second;
        const Outcome outcome = slot - first < stored
                                    ? history_.row(generation, slot).outcome
                                    : Outcome{};
        if (slot - first < stored && outcome.status != Status::proposed) {
            keep(generation, slot, outcome);
        } else if (original != slot) {
            open.copies.emplace(original, slot);
            copy(generation, original);
        } else {
            Task task;
            task.case_index =
                static_cast<std::uint32_t>(evolution_.chosen.index);
            task.generation = generation;
            task.slot = slot;
            waiting_.push_back({task, candidate.genome});
        }
    }
}

void CaseSearch::keep(std::uint32_t generation, std::uint32_t slot,
                      const Outcome& outcome) {
    Individual& row = open_[generation - first_open()].rows[slot];
    row.status = outcome.status;
    row.objectives = outcome.objectives;
    row.violation = outcome.violation;
    row.randomisations = outcome.randomisations;
    row.features = features_of(outcome);
    copy(generation, slot);
}

std::vector<double> CaseSearch::features_of(const Outcome& outcome) const {
    std::vector<double> features;
    if (outcome.status == Status::done)
        for (const AtlasAxis& axis : evolution_.campaign.search.axes)
            features.push_back(
                find(history_.header().schema, outcome, axis.quantity)
                    .value()
                    .mean);
    return features;
}

//! Copies the outcome of a row, if it is known, to later rows with the same
//! genome.
void CaseSearch::copy(std::uint32_t generation, std::uint32_t original) {
    Open& open = open_[generation - first_open()];
    const auto [begin, end] = open.copies.equal_range(original);
    if (begin == end || !is_recorded(open.rows[original].status)) return;
    const Outcome outcome = history_.row(generation, original).outcome;
    const std::vector<std::pair<const std::uint32_t, std::uint32_t>> copies(
        begin, end);
    open.copies.erase(begin, end);
    for (const auto& [from, slot] : copies) {
        history_.record(generation, slot, outcome, 0);
        keep(generation, slot, outcome);
    }
}

//! Passes known rows to the optimizer in order.
//! @throws CaseError if too many evaluations of a generation fail.
void CaseSearch::learn() {
    while (!open_.empty()) {
        Open& open = open_.front();
        while (open.learnt < open.rows.size() &&
               is_recorded(open.rows[open.learnt].status)) {
            evolution_.optimizer.learn(open.rows[open.learnt++]);
            ++known_rows_;
        }
        if (open.learnt < open.size) return;
        complete();
    }
}

//! Moves the first open generation to the complete ones.
void CaseSearch::complete() {
    const std::uint32_t generation = first_open();
    const Population rows = std::move(open_.front().rows);
    open_.pop_front();
    history_.set_wall_time(wall_time());
    require_few_failures(history_, generation, rows);
    GenerationSummary summary = summarized_(rows);
    summary.wall_time = wall_time();
    progress_.wall_time = summary.wall_time;
    judge(summary, rows);
    complete_.push_back({generation, summary});
}

void CaseSearch::commit() {
    learn();
    for (const auto& [generation, summary] : complete_) {
        history_.commit(generation, summary);
        evolution_.watcher.on_generation(generation, history_.size(generation),
                                         summary);
    }
    complete_.clear();
}

void CaseSearch::judge(const GenerationSummary& summary,
                       const Population& rows) {
    const Individual& first = rows.front();
    if (progress_.generations.empty() && first.status == Status::done &&
        first.candidate.origin == Origin::baseline)
        progress_.baseline = first.objectives.front().mean;
    progress_.generations.push_back(summary);
    if (reason_) return;
    reason_ =
        finished(evolution_.campaign.stop, progress_, space_.senses.front());
    reason_row_ = known_rows_;
}

}  // namespace ideotype
