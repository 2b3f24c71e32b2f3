#include <algorithm>
#include <utility>

#include "ideotype/parallel/dispatcher.hpp"

namespace ideotype {

Batch::Batch(Dispatcher& dispatcher, std::vector<Work> work, Record record)
    : dispatcher_(dispatcher),
      unanswered_(work.size()),
      record_(std::move(record)) {
    for (Work& each : work) {
        waiting_.push_back(items_.size());
        items_.push_back({std::move(each), false});
    }
    std::reverse(waiting_.begin(), waiting_.end());
}

Batch::~Batch() {
    dispatcher_.remove(*this);
}

bool Batch::await_ready() const {
    return items_.empty() || dispatcher_.stop_.requested();
}

void Batch::await_suspend(std::coroutine_handle<> awaiting) {
    awaiting_ = awaiting;
    dispatcher_.add(*this);
}

void Batch::await_resume() const {
    if (failure_) std::rethrow_exception(failure_);
}

}  // namespace ideotype
