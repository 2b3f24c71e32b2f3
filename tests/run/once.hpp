// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include "run/evolve_case.hpp"

namespace ideotype {

//! Starts one routine and waits for its end.
class Once : public Director {
  public:
    explicit Once(Routine<Ending> routine) : routine_(std::move(routine)) {}

    bool start_next() override {
        if (std::exchange(is_started_, true)) return false;
        routine_.start();
        return true;
    }
    void on_silence(const Task&, const std::string&) override {}
    void on_stop(int) override {}

    Ending result() { return routine_.result(); }

  private:
    Routine<Ending> routine_;
    bool is_started_ = false;
};

}  // namespace ideotype
