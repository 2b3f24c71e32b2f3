// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fake_evaluator.hpp"
#include "mpi_fixture.hpp"
#include "parallel/dispatcher.hpp"

namespace ideotype {

//! A test in which rank 0 gives commands and the other ranks serve.
class Commanded : public OnAllRanks {
  protected:
    explicit Commanded(FakeEvaluator evaluator = FakeEvaluator())
        : evaluator_(std::move(evaluator)) {}

    //! Runs the commands of a test on rank 0 while the other ranks serve.
    template <class Command>
    void command(Command give_orders, const AnswerRules& rules = {}) {
        if (!is_master()) return serve(session(), {&evaluator_});
        const auto dispatcher =
            make_dispatcher(session(), {&evaluator_}, stop_, rules);
        give_orders(*dispatcher);
    }

    FakeEvaluator evaluator_;
    StopFlag stop_;
};

}  // namespace ideotype
