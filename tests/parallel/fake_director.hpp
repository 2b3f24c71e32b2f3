// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <list>
#include <utility>

#include "ideotype/core/routine.hpp"
#include "parallel/dispatcher.hpp"

namespace ideotype {

//! Starts routines one after the other and stores all messages.
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
    void on_silence(const Task&, const std::string& message) override {
        silences.push_back(message);
    }
    void on_stop(int in_flight) override { stops.push_back(in_flight); }

    std::list<Routine<bool>> started;
    std::vector<std::string> silences;
    std::vector<int> stops;

  private:
    std::deque<Routine<bool>> waiting_;
};

//! Makes a routine that awaits one batch.
inline Routine<bool> make_routine(Dispatcher& dispatcher,
                                  std::vector<Work> work, Record record) {
    co_await dispatcher.evaluate(std::move(work), std::move(record));
    co_return true;
}

//! Evaluates a single batch; rethrows errors of its record.
inline void evaluate(Dispatcher& dispatcher, std::vector<Work> work,
                     Record record) {
    FakeDirector director;
    director.add(make_routine(dispatcher, std::move(work), std::move(record)));
    dispatcher.run(director);
    for (auto& routine : director.started) routine.result();
}

}  // namespace ideotype
