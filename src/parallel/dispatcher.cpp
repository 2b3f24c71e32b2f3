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

//! An evaluation is late if it takes this many times as long as the longest
//! evaluation so far.
constexpr double longest_factor = 20;

std::string describe(const Task& task) {
    return task.is_final ? fmt::format("finalist {}", task.slot)
                         : fmt::format("generation {} slot {}", task.generation,
                                       task.slot);
}

}  // namespace

struct Dispatcher::Assignment {
    //! Number of the batch, which may already be closed.
    std::uint64_t batch = 0;
    std::uint64_t item = 0;
    Task task;
    double began = 0;     //!< start, as a time of now() [s]
    double deadline = 0;  //!< as a time of now() [s]
};

Dispatcher::Dispatcher(std::unique_ptr<Workers> workers, const StopFlag& stop,
                       const AnswerRules& rules, const RankClock& clock)
    : workers_(std::move(workers)),
      stop_(stop),
      rules_(rules),
      clock_(clock),
      assignments_(static_cast<std::size_t>(workers_->width())),
      last_time_(clock.now()) {
    IDEOTYPE_EXPECT(workers_->width() > 0);
    IDEOTYPE_EXPECT(rules.deadline > 0);
    IDEOTYPE_EXPECT(rules.final_effort > 0 && rules.attention > 0);
    for (int worker = 0; worker < workers_->width(); ++worker)
        idle_.insert(idle_.end(), worker);
}

Dispatcher::~Dispatcher() {
    // Receive from busy workers, which otherwise could not send their replies.
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
        if (stop_.requested() && !open_.empty() && !has_reported_stop_) {
            has_reported_stop_ = true;
            director.on_stop(busy_in_time());
        }
        // Hand out work before coroutines resume, since proposing a generation
        // takes time.
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
                "no worker responds any more; if evaluations take longer than "
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
    return idle_.size() + deadlines_.size() < assignments_.size();
}

//! Returns the running time of this process [s]. It excludes pauses of the job,
//! for example after Ctrl-Z, so that a pause makes no worker late.
double Dispatcher::now() {
    constexpr double longest_step = 0.5;
    const double time = clock_.now();
    IDEOTYPE_EXPECT(time >= last_time_);
    running_ += std::min(time - last_time_, longest_step);
    last_time_ = time;
    return running_;
}

void Dispatcher::give(int worker, const Assignment& assignment,
                      const Work& work) {
    IDEOTYPE_EXPECT(idle_.contains(worker));
    idle_.erase(worker);
    deadlines_.emplace(assignment.deadline, worker);
    assignments_[static_cast<std::size_t>(worker)] = assignment;
    workers_->give(worker, work);
}

//! Accepts the answer of a worker, which becomes idle.
Dispatcher::Assignment Dispatcher::take(int worker, const Outcome& outcome) {
    IDEOTYPE_EXPECT(worker >= 0 && worker < width());
    IDEOTYPE_EXPECT(assignments_[static_cast<std::size_t>(worker)].has_value());
    const Assignment assignment = *std::exchange(
        assignments_[static_cast<std::size_t>(worker)], std::nullopt);
    const bool was_in_time =
        deadlines_.erase({assignment.deadline, worker}) > 0;
    if (was_in_time)
        longest_ = std::max(longest_,
                            outcome.seconds / rules_.effort(assignment.task));
    idle_.insert(worker);
    return assignment;
}

std::optional<int> Dispatcher::next_late() {
    const auto first = deadlines_.begin();
    if (first == deadlines_.end() || now() <= first->first) return {};
    const int worker = first->second;
    deadlines_.erase(first);
    return worker;
}

//! Sends the next work to an idle worker. Returns false if there is no work or
//! no idle worker, or if a stop is requested.
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
        const auto entry = batch.unanswered_.find(item);
        // Another answer may have arrived in the meantime.
        if (entry == batch.unanswered_.end()) return true;
        const Work& work = entry->second;
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

//! Waits for a limited time until an answer arrives or a worker is late.
void Dispatcher::receive(Director& director) {
    if (const auto answer = workers_->wait(seconds_to_wait())) {
        const auto& [worker, outcome] = *answer;
        const Assignment assignment = take(worker, outcome);
        if (outcome.status == Status::proposed)
            note_obstacle(workers_->number(worker), assignment.task,
                          outcome.message);
        else
            settle(assignment, outcome);
    }
    while (const auto worker = next_late()) give_up(*worker, director);
}

//! Records that a machine, not the plant, caused an evaluation to fail.
void Dispatcher::note_obstacle(int worker, const Task& task,
                               const std::string& reason) {
    if (!obstacle_.empty()) return;
    obstacle_ = fmt::format(
        "worker {} could not evaluate {} {}; the machine failed, not the "
        "plant, which remains to be evaluated: give each worker more memory, "
        "or use fewer workers",
        worker, describe(task), reason);
}

//! Records an outcome, unless its batch is closed or another attempt answered
//! first.
void Dispatcher::settle(const Assignment& assignment, const Outcome& outcome) {
    IDEOTYPE_EXPECT(outcome.status == Status::done ||
                    outcome.status == Status::failed);
    const auto open = by_number_.find(assignment.batch);
    if (open == by_number_.end()) return;
    Batch& batch = *open->second;
    const auto entry = batch.unanswered_.find(assignment.item);
    if (entry == batch.unanswered_.end()) return;
    Work work = std::move(entry->second);
    batch.unanswered_.erase(entry);
    work.task = assignment.task;
    try {
        batch.record_(work, outcome);
    } catch (...) {
        batch.failure_ = std::current_exception();
    }
    const bool continues = !batch.failure_ && (!batch.unanswered_.empty() ||
                                               is_ending() || fetch(batch));
    if (!continues) close(batch);
}

//! Decides whether the task of a late worker is repeated or fails.
void Dispatcher::give_up(int worker, Director& director) {
    const Assignment assignment =
        *assignments_[static_cast<std::size_t>(worker)];
    std::string message = fmt::format(
        "no answer from worker {} within {:.3g} s for {}, attempt {}",
        workers_->number(worker), assignment.deadline - assignment.began,
        describe(assignment.task), assignment.task.attempt);
    const auto batch_entry = by_number_.find(assignment.batch);
    const bool is_needed =
        batch_entry != by_number_.end() &&
        batch_entry->second->unanswered_.contains(assignment.item);
    // If no worker is left, the machines are more likely at fault than the
    // candidate. Its evaluation stays pending.
    const bool is_alone = idle_.empty() && busy_in_time() == 0;
    const bool is_last = assignment.task.attempt >= most_attempts;
    const bool ends = is_ending();
    if (is_needed && ends)
        message += "; left for the next start";
    else if (is_needed && !is_alone)
        message += is_last ? "; it has failed" : "; trying again";
    director.on_silence(assignment.task, message);
    if (!is_needed || ends || is_alone) return;
    if (is_last) {
        const std::string reason = fmt::format(
            "no answer within {:.3g} s in {} attempts",
            assignment.deadline - assignment.began, assignment.task.attempt);
        Outcome outcome =
            failed_outcome(workers_->schema(assignment.task), reason);
        outcome.seconds = assignment.deadline - assignment.began;
        outcome.worker = static_cast<std::uint32_t>(workers_->number(worker));
        settle(assignment, outcome);
    } else {
        Batch& batch = *batch_entry->second;
        ++batch.unanswered_.at(assignment.item).task.attempt;
        batch.waiting_.push_back(assignment.item);
    }
}

double Dispatcher::seconds_to_wait() const {
    if (deadlines_.empty()) return rules_.attention;
    return std::clamp(deadlines_.begin()->first - running_, 0.0,
                      rules_.attention);
}

//! Receives an answer and discards it, or detects a late worker.
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
