#include "ideotype/parallel/dispatcher.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"
#include "workers.hpp"

namespace ideotype {

namespace {

//! An evaluation is not late before it takes this many times the longest.
constexpr double longest_factor = 20;

//! How soon a stop request or a passed deadline is noticed [s].
constexpr double attention = 0.25;

double steady_seconds() {
    using Clock = std::chrono::steady_clock;
    return std::chrono::duration<double>(Clock::now().time_since_epoch())
        .count();
}

std::string name_of(const Task& task) {
    return task.is_final ? fmt::format("finalist {}", task.slot)
                         : fmt::format("generation {} slot {}", task.generation,
                                       task.slot);
}

}  // namespace

//! What a worker was given. Its batch may be gone since.
struct Dispatcher::Assignment {
    Precedence batch;
    std::size_t item = 0;
    Task task;
    double began = 0;     //!< on the steady clock [s]
    double deadline = 0;  //!< on the steady clock [s]
};

struct Dispatcher::WorkerSlot {
    int worker = 0;
    std::optional<Assignment> given;
    bool is_late = false;
};

Dispatcher::Dispatcher(std::unique_ptr<Workers> workers, const StopFlag& stop,
                       const AnswerRules& rules)
    : workers_(std::move(workers)), stop_(stop), rules_(rules) {
    for (int worker = 0; worker < workers_->width(); ++worker)
        slots_.push_back({worker, std::nullopt, false});
}

Dispatcher::~Dispatcher() {
    // The reply of a busy worker could not leave it if nobody took it.
    if (dismiss()) return;
    while (std::any_of(slots_.begin(), slots_.end(),
                       [](const WorkerSlot& slot) { return slot.is_late; }))
        drop_next();
}

int Dispatcher::width() const {
    return workers_->width();
}

Batch Dispatcher::evaluate(std::vector<Work> work, Record record) {
    return {*this, std::move(work), std::move(record)};
}

void Dispatcher::run(Director& director) {
    bool has_next = true;
    for (;;) {
        if (stop_.requested() && !open_.empty() && !has_told_of_stop_) {
            has_told_of_stop_ = true;
            director.on_stop(busy_in_time());
        }
        // Before routines go on, since they take their time to breed.
        while (hand_out()) continue;
        resume_complete();
        while (has_idle() && !stop_.requested())
            if (!hand_out() && !(has_next = has_next && director.start_next()))
                break;

        if (busy_in_time() > 0)
            receive(director);
        else if (stop_.requested() && !open_.empty())
            release_all();
        else if (open_.empty() && (stop_.requested() || !has_next))
            return;
        else if (!has_idle())
            throw Error(fmt::format(
                "no worker answers any more; if evaluations take longer than "
                "{:.4g} s, raise parallel.deadline",
                rules_.deadline));
    }
}

bool Dispatcher::dismiss() {
    while (busy_in_time() > 0) drop_next();
    if (!std::exchange(is_dismissed_, true)) workers_->dismiss();
    return std::none_of(slots_.begin(), slots_.end(),
                        [](const WorkerSlot& slot) { return slot.is_late; });
}

void Dispatcher::add(Batch& batch) {
    const Task& task = batch.items_.front().work.task;
    const auto after_all = std::numeric_limits<std::uint32_t>::max();
    batch.precedence_ = {task.is_final ? after_all : task.generation,
                         task.case_index, batches_++};
    open_.emplace(batch.precedence_, &batch);
}

void Dispatcher::remove(Batch& batch) {
    const auto found = open_.find(batch.precedence_);
    if (found != open_.end() && found->second == &batch) open_.erase(found);
    std::erase(complete_, &batch);
}

bool Dispatcher::has_idle() const {
    return std::any_of(slots_.begin(), slots_.end(),
                       [](const WorkerSlot& slot) { return !slot.given; });
}

int Dispatcher::busy_in_time() const {
    return static_cast<int>(std::count_if(
        slots_.begin(), slots_.end(),
        [](const WorkerSlot& slot) { return slot.given && !slot.is_late; }));
}

//! Sends the next work to an idle worker; false if there is none of either, or
//! a stop is requested.
bool Dispatcher::hand_out() {
    if (stop_.requested()) return false;
    const auto idle =
        std::find_if(slots_.begin(), slots_.end(),
                     [](const WorkerSlot& slot) { return !slot.given; });
    if (idle == slots_.end()) return false;
    for (const auto& [precedence, batch] : open_)
        while (!batch->waiting_.empty()) {
            const std::size_t index = batch->waiting_.back();
            batch->waiting_.pop_back();
            const Batch::Item& item = batch->items_[index];
            if (item.is_answered) continue;
            const Task& task = item.work.task;
            const double now = steady_seconds();
            idle->given = {
                precedence, index, task, now,
                now + std::max(rules_.deadline, longest_factor * longest_ *
                                                    rules_.effort(task))};
            workers_->give(idle->worker, item.work);
            return true;
        }
    return false;
}

void Dispatcher::resume_complete() {
    while (!complete_.empty()) {
        Batch& batch = *complete_.front();
        complete_.erase(complete_.begin());
        batch.awaiting_.resume();
    }
}

//! Lets all routines go on with what there is.
void Dispatcher::release_all() {
    for (const auto& [precedence, batch] : open_) complete_.push_back(batch);
    open_.clear();
}

//! Waits until an answer arrives or a worker is late, but not for long.
void Dispatcher::receive(Director& director) {
    if (auto answer = workers_->wait(seconds_to_wait())) {
        WorkerSlot& slot = slots_[static_cast<std::size_t>(answer->worker)];
        const Assignment given = *std::exchange(slot.given, std::nullopt);
        if (!std::exchange(slot.is_late, false))
            longest_ = std::max(
                longest_, answer->outcome.seconds / rules_.effort(given.task));
        settle(given, answer->outcome);
    }
    const double now = steady_seconds();
    for (WorkerSlot& slot : slots_)
        if (slot.given && !slot.is_late && now > slot.given->deadline) {
            slot.is_late = true;
            give_up(slot, director);
        }
}

//! Records an outcome, unless its batch is gone or another attempt was first.
void Dispatcher::settle(const Assignment& given, const Outcome& outcome) {
    const auto found = open_.find(given.batch);
    if (found == open_.end()) return;
    Batch& batch = *found->second;
    Batch::Item& item = batch.items_[given.item];
    if (std::exchange(item.is_answered, true)) return;
    --batch.unanswered_;
    item.work.task = given.task;
    try {
        batch.record_(item.work, outcome);
    } catch (...) {
        batch.failure_ = std::current_exception();
    }
    if (batch.unanswered_ > 0 && !batch.failure_) return;
    open_.erase(found);
    complete_.push_back(&batch);
}

//! What happens to the task of a worker that has become late.
void Dispatcher::give_up(const WorkerSlot& slot, Director& director) {
    const Assignment given = *slot.given;
    std::string what =
        fmt::format("no answer from rank {} within {:.3g} s for {}, attempt {}",
                    workers_->rank(slot.worker), given.deadline - given.began,
                    name_of(given.task), given.task.attempt);
    const auto found = open_.find(given.batch);
    if (found == open_.end()) {
        director.on_silence(given.task, what);
        return;
    }
    if (stop_.requested()) {
        director.on_silence(given.task, what + "; left for the next start");
        return;
    }
    // With nobody left, the fault is hardly the candidate's: it stays pending.
    if (std::all_of(slots_.begin(), slots_.end(),
                    [](const WorkerSlot& each) { return each.is_late; })) {
        director.on_silence(given.task, what);
        return;
    }
    const bool is_last =
        given.task.attempt >= static_cast<std::uint32_t>(rules_.attempts);
    director.on_silence(
        given.task, what + (is_last ? "; it has failed" : "; trying again"));
    if (is_last) {
        const std::string reason =
            fmt::format("no answer within {:.3g} s in {} attempts",
                        given.deadline - given.began, given.task.attempt);
        Outcome outcome = failed_outcome(workers_->schema(given.task), reason);
        outcome.seconds = given.deadline - given.began;
        outcome.worker =
            static_cast<std::uint32_t>(workers_->rank(slot.worker));
        settle(given, outcome);
    } else {
        Batch& batch = *found->second;
        ++batch.items_[given.item].work.task.attempt;
        batch.waiting_.push_back(given.item);
    }
}

double Dispatcher::seconds_to_wait() const {
    const double now = steady_seconds();
    double seconds = attention;
    for (const WorkerSlot& slot : slots_)
        if (slot.given && !slot.is_late)
            seconds = std::min(seconds, slot.given->deadline - now);
    return std::max(seconds, 0.0);
}

//! Takes an answer that nobody needs any more, or notices who is late.
void Dispatcher::drop_next() {
    if (const auto answer = workers_->wait(seconds_to_wait())) {
        WorkerSlot& slot = slots_[static_cast<std::size_t>(answer->worker)];
        slot.given.reset();
        slot.is_late = false;
    }
    const double now = steady_seconds();
    for (WorkerSlot& slot : slots_)
        if (slot.given && now > slot.given->deadline) slot.is_late = true;
}

std::unique_ptr<Dispatcher> make_dispatcher(Evaluator& evaluator,
                                            const StopFlag& stop) {
    return std::make_unique<Dispatcher>(make_local_worker(evaluator), stop);
}

std::unique_ptr<Dispatcher> make_dispatcher(const Session& session,
                                            Evaluator& evaluator,
                                            const StopFlag& stop,
                                            const AnswerRules& rules) {
    if (session.size() == 1) return make_dispatcher(evaluator, stop);
    return std::make_unique<Dispatcher>(make_rank_workers(session, evaluator),
                                        stop, rules);
}

}  // namespace ideotype
