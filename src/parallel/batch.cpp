// SPDX-License-Identifier: Apache-2.0
// Batches of a dispatcher: the work that a coroutine awaits.
#include <limits>
#include <optional>
#include <utility>

#include "dispatcher.hpp"
#include "ideotype/core/contract.hpp"

namespace ideotype {

Batch Dispatcher::evaluate(NextWork source, Record record) {
    return {*this, std::move(source), std::move(record)};
}

Batch Dispatcher::evaluate(std::vector<Work> work, Record record) {
    NextWork source = [work = std::move(work),
                       next = std::size_t{0}]() mutable -> std::optional<Work> {
        if (next == work.size()) return std::nullopt;
        return std::move(work[next++]);
    };
    return evaluate(std::move(source), std::move(record));
}

void Dispatcher::add(Batch& batch) {
    open_.emplace(batch.precedence_, &batch);
    by_number_.emplace(batch.number_, &batch);
    IDEOTYPE_ENSURE(open_.size() == by_number_.size());
}

//! Closes a batch: queues its coroutine for resumption.
void Dispatcher::close(Batch& batch) {
    IDEOTYPE_EXPECT(by_number_.contains(batch.number_));
    open_.erase(batch.precedence_);
    by_number_.erase(batch.number_);
    complete_.push_back(&batch);
}

void Dispatcher::remove(Batch& batch) {
    if (by_number_.erase(batch.number_) > 0) open_.erase(batch.precedence_);
    std::erase(complete_, &batch);
}

//! Moves the next work from a batch's source to the waiting work; returns false
//! if the source is empty or failed.
bool Dispatcher::fetch(Batch& batch) {
    std::optional<Work> work;
    try {
        work = batch.source_();
    } catch (...) {
        batch.failure_ = std::current_exception();
    }
    if (!work) return false;
    constexpr auto after_search = std::numeric_limits<std::uint32_t>::max();
    const Task& task = work->task;
    const bool is_open = by_number_.contains(batch.number_);
    if (is_open) open_.erase(batch.precedence_);
    batch.precedence_ = {task.is_final ? after_search : task.generation,
                         task.case_index, batch.number_};
    if (is_open) open_.emplace(batch.precedence_, &batch);
    batch.waiting_.push_back(batch.fetched_);
    batch.unanswered_.emplace(batch.fetched_++, *std::move(work));
    return true;
}

void Dispatcher::resume_complete() {
    while (!complete_.empty()) {
        Batch& batch = *complete_.front();
        complete_.erase(complete_.begin());
        IDEOTYPE_EXPECT(batch.awaiting_ && !batch.awaiting_.done());
        batch.awaiting_.resume();
    }
}

//! Closes all batches, so that their coroutines resume with the outcomes that
//! have arrived.
void Dispatcher::release_all() {
    while (!open_.empty()) close(*open_.begin()->second);
}

}  // namespace ideotype
