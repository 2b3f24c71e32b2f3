// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <list>
#include <utility>

#include "ideotype/core/routine.hpp"
#include "parallel/dispatcher.hpp"

namespace ideotype {

//! Starts some routines one after the other, and keeps all messages.
class FakeDirector : public Director {
  public:
    void add(Routine<bool> routine) { waiting_.push_back(std::move(routine)); }

    bool start_next() override {
        if (waiting_.empty()) return false;
        started.push_back(std::move(waiting_.front()));
        waiting_.pop_front();
        started.back().start();
        return true;
    }
    void on_silence(const Task&, const std::string& what) override {
        silences.push_back(what);
    }
    void on_stop(int in_flight) override { stops.push_back(in_flight); }

    std::list<Routine<bool>> started;
    std::vector<std::string> silences;
    std::vector<int> stops;

  private:
    std::deque<Routine<bool>> waiting_;
};

//! Returns a routine that awaits one batch.
inline Routine<bool> batch_routine(Dispatcher& dispatcher,
                                   std::vector<Work> work, Record record) {
    co_await dispatcher.evaluate(std::move(work), std::move(record));
    co_return true;
}

//! Evaluates one batch and nothing else; rethrows the errors of its record.
inline void evaluate(Dispatcher& dispatcher, std::vector<Work> work,
                     Record record) {
    FakeDirector director;
    director.add(batch_routine(dispatcher, std::move(work), std::move(record)));
    dispatcher.run(director);
    for (auto& routine : director.started) routine.result();
}

}  // namespace ideotype
