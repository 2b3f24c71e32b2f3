// SPDX-License-Identifier: Apache-2.0
#include "dispatcher.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"
#include "workers.hpp"

namespace ideotype {

namespace {

//! An evaluation is late if it takes longer than the longest one by this
//! factor.
constexpr double longest_factor = 20;

std::string name_of(const Task& task) {
    return task.is_final ? fmt::format("finalist {}", task.slot)
                         : fmt::format("generation {} slot {}", task.generation,
                                       task.slot);
}

}  // namespace

struct Dispatcher::Assignment {
    std::uint64_t batch = 0;  //!< number of the batch, which may be gone
    std::uint64_t item = 0;
    Task task;
    double began = 0;     //!< time of now() [s]
    double deadline = 0;  //!< time of now() [s]
};

Dispatcher::Dispatcher(std::unique_ptr<Workers> workers, const StopFlag& stop,
                       const AnswerRules& rules, const RankClock& clock)
    : workers_(std::move(workers)),
      stop_(stop),
      rules_(rules),
      clock_(clock),
      given_(static_cast<std::size_t>(workers_->width())),
      looked_(clock.now()) {
    IDEOTYPE_EXPECT(workers_->width() > 0);
    IDEOTYPE_EXPECT(rules.deadline > 0);
    IDEOTYPE_EXPECT(rules.final_effort > 0 && rules.attention > 0);
    for (int worker = 0; worker < workers_->width(); ++worker)
        idle_.insert(idle_.end(), worker);
}

Dispatcher::~Dispatcher() {
    // A busy worker could not send its reply if nobody received it.
    if (dismiss()) return;
    while (has_late()) drop_next();
}

int Dispatcher::width() const {
    return workers_->width();
}

void Dispatcher::run(Director& director) {
    IDEOTYPE_EXPECT(!is_dismissed_);
    bool has_next = true;
    for (;;) {
        if (stop_.requested() && !open_.empty() && !has_told_of_stop_) {
            has_told_of_stop_ = true;
            director.on_stop(busy_in_time());
        }
        // Work is handed out before routines go on, since breeding takes time.
        while (hand_out()) continue;
        resume_complete();
        while (!idle_.empty() && !is_ending())
            if (!hand_out() && !(has_next = has_next && director.start_next()))
                break;

        if (busy_in_time() > 0)
            receive(director);
        else if (is_ending() && !open_.empty())
            release_all();
        else if (open_.empty() && (is_ending() || !has_next))
            break;
        else if (idle_.empty())
            throw Error(fmt::format(
                "no worker answers any more; if evaluations take longer than "
                "{:.4g} s, raise parallel.deadline",
                rules_.deadline));
    }
    if (!obstacle_.empty()) throw Error(obstacle_);
}

bool Dispatcher::dismiss() {
    while (busy_in_time() > 0) drop_next();
    if (!std::exchange(is_dismissed_, true)) workers_->dismiss();
    return !has_late();
}

bool Dispatcher::has_late() const {
    return idle_.size() + deadlines_.size() < given_.size();
}

//! Returns the running time of this process [s]. It stands still while a job is
//! paused, as after Ctrl-Z, so that no worker becomes late.
double Dispatcher::now() {
    constexpr double longest_step = 0.5;
    const double looked = clock_.now();
    IDEOTYPE_EXPECT(looked >= looked_);
    running_ += std::min(looked - looked_, longest_step);
    looked_ = looked;
    return running_;
}

void Dispatcher::give(int worker, const Assignment& given, const Work& work) {
    IDEOTYPE_EXPECT(idle_.contains(worker));
    idle_.erase(worker);
    deadlines_.emplace(given.deadline, worker);
    given_[static_cast<std::size_t>(worker)] = given;
    workers_->give(worker, work);
}

//! Takes the answer of a worker, which is idle again.
Dispatcher::Assignment Dispatcher::take(int worker, const Outcome& outcome) {
    IDEOTYPE_EXPECT(worker >= 0 && worker < width());
    IDEOTYPE_EXPECT(given_[static_cast<std::size_t>(worker)].has_value());
    const Assignment given =
        *std::exchange(given_[static_cast<std::size_t>(worker)], std::nullopt);
    const bool was_in_time = deadlines_.erase({given.deadline, worker}) > 0;
    if (was_in_time)
        longest_ =
            std::max(longest_, outcome.seconds / rules_.effort(given.task));
    idle_.insert(worker);
    return given;
}

std::optional<int> Dispatcher::next_late() {
    const auto first = deadlines_.begin();
    if (first == deadlines_.end() || now() <= first->first) return {};
    const int worker = first->second;
    deadlines_.erase(first);
    return worker;
}

//! Sends the next work to an idle worker; returns false without work or idle
//! worker, or if a stop is requested.
bool Dispatcher::hand_out() {
    if (is_ending() || idle_.empty()) return false;
    for (const auto& [precedence, open] : open_) {
        Batch& batch = *open;
        if (batch.waiting_.empty() && !fetch(batch)) {
            if (!batch.failure_) continue;
            close(batch);
            return true;
        }
        const std::uint64_t item = batch.waiting_.back();
        batch.waiting_.pop_back();
        const auto found = batch.unanswered_.find(item);
        // A late worker may have answered after all.
        if (found == batch.unanswered_.end()) return true;
        const Work& work = found->second;
        const double began = now();
        const double patience =
            std::max(rules_.deadline,
                     longest_factor * longest_ * rules_.effort(work.task));
        give(*idle_.begin(),
             {batch.number_, item, work.task, began, began + patience}, work);
        return true;
    }
    return false;
}

//! Waits until an answer arrives or a worker is late, but not for long.
void Dispatcher::receive(Director& director) {
    if (const auto answer = workers_->wait(seconds_to_wait())) {
        const auto& [worker, outcome] = *answer;
        const Assignment given = take(worker, outcome);
        if (outcome.status == Status::proposed)
            note_obstacle(workers_->number(worker), given.task,
                          outcome.message);
        else
            settle(given, outcome);
    }
    while (const auto worker = next_late()) give_up(*worker, director);
}

//! Notes that a machine could not evaluate, whatever the plant.
void Dispatcher::note_obstacle(int worker, const Task& task,
                               const std::string& reason) {
    if (!obstacle_.empty()) return;
    obstacle_ = fmt::format(
        "worker {} could not evaluate {} {}; that is not the plant's fault, so "
        "nothing is said of it: give each worker more memory, or have fewer",
        worker, name_of(task), reason);
}

//! Records an outcome, unless its batch has ended or another attempt answered
//! first.
void Dispatcher::settle(const Assignment& given, const Outcome& outcome) {
    IDEOTYPE_EXPECT(outcome.status == Status::done ||
                    outcome.status == Status::failed);
    const auto open = by_number_.find(given.batch);
    if (open == by_number_.end()) return;
    Batch& batch = *open->second;
    const auto found = batch.unanswered_.find(given.item);
    if (found == batch.unanswered_.end()) return;
    Work work = std::move(found->second);
    batch.unanswered_.erase(found);
    work.task = given.task;
    try {
        batch.record_(work, outcome);
    } catch (...) {
        batch.failure_ = std::current_exception();
    }
    const bool goes_on = !batch.failure_ && (!batch.unanswered_.empty() ||
                                             is_ending() || fetch(batch));
    if (!goes_on) close(batch);
}

//! Decides what happens to the task of a worker that has become late.
void Dispatcher::give_up(int worker, Director& director) {
    const Assignment given = *given_[static_cast<std::size_t>(worker)];
    std::string what = fmt::format(
        "no answer from worker {} within {:.3g} s for {}, attempt {}",
        workers_->number(worker), given.deadline - given.began,
        name_of(given.task), given.task.attempt);
    const auto found = by_number_.find(given.batch);
    const bool is_needed = found != by_number_.end() &&
                           found->second->unanswered_.contains(given.item);
    // If no worker is left, the fault is hardly the candidate's, which stays
    // pending.
    const bool is_alone = idle_.empty() && busy_in_time() == 0;
    const bool is_last = given.task.attempt >= most_attempts;
    const bool ends = is_ending();
    if (is_needed && ends)
        what += "; left for the next start";
    else if (is_needed && !is_alone)
        what += is_last ? "; it has failed" : "; trying again";
    director.on_silence(given.task, what);
    if (!is_needed || ends || is_alone) return;
    if (is_last) {
        const std::string reason =
            fmt::format("no answer within {:.3g} s in {} attempts",
                        given.deadline - given.began, given.task.attempt);
        Outcome outcome = failed_outcome(workers_->schema(given.task), reason);
        outcome.seconds = given.deadline - given.began;
        outcome.worker = static_cast<std::uint32_t>(workers_->number(worker));
        settle(given, outcome);
    } else {
        Batch& batch = *found->second;
        ++batch.unanswered_.at(given.item).task.attempt;
        batch.waiting_.push_back(given.item);
    }
}

double Dispatcher::seconds_to_wait() const {
    if (deadlines_.empty()) return rules_.attention;
    return std::clamp(deadlines_.begin()->first - running_, 0.0,
                      rules_.attention);
}

//! Takes and drops an answer, or notices a late worker.
void Dispatcher::drop_next() {
    if (const auto answer = workers_->wait(seconds_to_wait()))
        take(answer->worker, answer->outcome);
    while (next_late()) continue;
}

std::unique_ptr<Dispatcher> make_dispatcher(const Session& session,
                                            const Evaluators& evaluators,
                                            const StopFlag& stop,
                                            const AnswerRules& rules) {
    return std::make_unique<Dispatcher>(
        session.size() == 1 ? make_thread_workers(session, evaluators)
                            : make_rank_workers(session, evaluators),
        stop, rules, session.clock());
}

}  // namespace ideotype
