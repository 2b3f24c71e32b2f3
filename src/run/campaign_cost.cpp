// SPDX-License-Identifier: Apache-2.0
#include "campaign_cost.hpp"

#include <algorithm>
#include <limits>

#include "ideotype/light/device.hpp"
#include "run/evaluator.hpp"
#include "run/progress.hpp"

namespace ideotype {

//! Uses the fastest of a few evaluations. The first evaluation fills caches,
//! and other processes may use the core.
CampaignCost::CampaignCost(const Campaign& campaign, const Case& chosen)
    : population(campaign.search.population),
      generations(campaign.stop.generations),
      finalists(1 + campaign.final_rule.candidates) {
    CanopyEvaluator evaluator(campaign, Device::supported_isas().back());
    // One measurement is enough if it takes longer than this [s].
    constexpr double long_time = 1;
    const auto measure = [&](int times, Task task) {
        task.case_index = static_cast<std::uint32_t>(chosen.index);
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < times && !(i > 0 && least > long_time); ++i) {
            const double began = now();
            evaluator.evaluate(task, baseline_genome(campaign));
            least = std::min(least, now() - began);
        }
        return least;
    };
    usual = measure(3, {});
    Task last;
    last.is_final = true;
    final = measure(1, last);
}

double CampaignCost::of_case(int workers) const {
    const int rounds = (population + workers - 1) / workers;
    const int final_rounds = (finalists + workers - 1) / workers;
    return usual * static_cast<double>(generations) * rounds +
           final * final_rounds;
}

double CampaignCost::of_cases(std::size_t cases, int workers) const {
    const double all = static_cast<double>(cases) * of_case(1) / workers;
    return std::max(all, of_case(workers));
}

}  // namespace ideotype
