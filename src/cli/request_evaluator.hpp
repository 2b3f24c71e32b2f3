// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "genome_request.hpp"
#include "parallel/dispatcher.hpp"
#include "stand/stand.hpp"

namespace ideotype {

//! A request as it travels: what its task does not say of the sampling stands
//! behind the genes.
Work to_work(const GenomeRequest& request);

//! Evaluates them. The case must outlive it.
class RequestEvaluator : public Evaluator {
  public:
    //! @throws Error if the processor lacks the instruction set.
    RequestEvaluator(const ServedCase& served, const std::string& isa);

    const OutcomeSchema& schema(const Task&) const override {
        return served_.schema;
    }
    Outcome evaluate(const Task& task, const Genome& genome) override;

  private:
    const ServedCase& served_;
    Stand stand_;
    Device device_;
};

}  // namespace ideotype
