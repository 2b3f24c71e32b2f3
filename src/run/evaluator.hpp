// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/light/device.hpp"
#include "parallel/evaluator.hpp"
#include "stand/stand.hpp"

namespace ideotype {

//! Evaluates candidates of all cases of a campaign.
class CanopyEvaluator : public Evaluator {
  public:
    //! Makes the evaluator, which the campaign must outlive.
    //! @throws Error if the processor lacks the instruction set.
    CanopyEvaluator(const Campaign& campaign, const std::string& isa);

    const OutcomeSchema& schema(const Task& task) const override;
    Outcome evaluate(const Task& task, const Genome& genome) override;

  private:
    const Campaign& campaign_;
    std::vector<Case> cases_;
    std::vector<Stand> stands_;  //!< stands by case
    Device device_;
};

}  // namespace ideotype
