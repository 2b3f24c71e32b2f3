// SPDX-License-Identifier: Apache-2.0
#include "evaluator.hpp"

namespace ideotype {

CanopyEvaluator::CanopyEvaluator(const Campaign& campaign,
                                 const std::string& isa)
    : campaign_(campaign), cases_(cases(campaign)), device_(isa) {
    for (const Case& each : cases_) stands_.emplace_back(campaign, each);
}

const OutcomeSchema& CanopyEvaluator::schema(const Task& task) const {
    return stands_.at(task.case_index).schema(task.is_final);
}

Outcome CanopyEvaluator::evaluate(const Task& task, const Genome& genome) {
    const auto in = [&](const Campaign& campaign, const Case& chosen,
                        Stand& stand, const Genome& plant) {
        return stand.evaluate(grow(campaign, plant),
                              sampling_of(task, campaign, chosen), device_);
    };
    const std::uint32_t i = task.case_index;
    if (campaign_.varied.keys.empty())
        return in(campaign_, cases_.at(i), stands_.at(i), genome);
    Genome plain = genome;
    const Campaign varied = at_keys(campaign_, plain);
    const Case chosen = cases(varied).at(i);
    Stand stand(varied, chosen);
    return in(varied, chosen, stand, plain);
}

}  // namespace ideotype
