// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "dispatcher.hpp"

namespace ideotype {

Batch::Batch(Dispatcher& dispatcher, NextWork source, Record record)
    : dispatcher_(dispatcher),
      source_(std::move(source)),
      record_(std::move(record)),
      number_(dispatcher.batches_++) {}

Batch::~Batch() {
    dispatcher_.remove(*this);
}

bool Batch::await_ready() {
    return dispatcher_.stop_.requested() || !dispatcher_.fetch(*this);
}

void Batch::await_suspend(std::coroutine_handle<> awaiting) {
    awaiting_ = awaiting;
    dispatcher_.add(*this);
}

void Batch::await_resume() const {
    if (failure_) std::rethrow_exception(failure_);
}

}  // namespace ideotype
