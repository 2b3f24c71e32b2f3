// SPDX-License-Identifier: Apache-2.0
#include "evaluator.hpp"

namespace ideotype {

CanopyEvaluator::CanopyEvaluator(const Campaign& campaign,
                                 const std::string& isa)
    : campaign_(campaign), device_(isa) {}

CanopyEvaluator::Place::Place(const Campaign& campaign, const Case& one)
    : chosen(one),
      stand(campaign, one),
      usual_schema(stand.schema(false)),
      final_schema(stand.schema(true)) {
    if (campaign.varied.keys.empty()) return;
    usual_schema = search_schema(campaign, one, campaign.sampling);
    final_schema.measured = usual_schema.measured;
}

CanopyEvaluator::Place& CanopyEvaluator::place(std::uint32_t index) const {
    const std::lock_guard lock(mutex_);
    const auto known = places_.find(index);
    if (known != places_.end()) return known->second;
    return places_.try_emplace(index, campaign_, cases(campaign_).at(index))
        .first->second;
}

const OutcomeSchema& CanopyEvaluator::schema(const Task& task) const {
    return place(task.case_index).schema(task.is_final);
}

Outcome CanopyEvaluator::evaluate(const Task& task, const Genome& genome) {
    const auto evaluate_in = [&](const Campaign& campaign, const Case& chosen,
                                 Stand& stand, const Genome& plant) {
        return stand.evaluate(grow(campaign, plant),
                              sampling_of(task, campaign, chosen), device_);
    };
    if (campaign_.varied.keys.empty()) {
        Place& case_place = place(task.case_index);
        return evaluate_in(campaign_, case_place.chosen, case_place.stand,
                           genome);
    }
    Genome plain = genome;
    const Campaign varied = at_keys(campaign_, plain);
    const Case chosen = cases(varied).at(task.case_index);
    Stand stand(varied, chosen);
    return arranged_outcome(evaluate_in(varied, chosen, stand, plain),
                            stand.schema(task.is_final), schema(task));
}

}  // namespace ideotype
