// SPDX-License-Identifier: Apache-2.0
#include "sampling.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"
#include "ideotype/core/hash.hpp"

namespace ideotype {

Accuracy accuracy_of(const Task& task, const Campaign& campaign) {
    if (!task.is_final) return campaign.sampling;
    Accuracy accuracy = campaign.final_rule.sampling;
    accuracy.fields = accuracy.randomisations;
    return accuracy;
}

Randomness randomness_of(const Task& task, const Campaign& campaign,
                         const Case& chosen) {
    if (task.is_final) return {derive_seed(chosen.seed, "final")};
    if (campaign.has_light_by_row)
        return {chosen.seed, task.generation,
                task.slot * static_cast<std::uint32_t>(
                                campaign.sampling.randomisations),
                true};
    return {chosen.seed, task.generation};
}

Sampling sampling_of(const Task& task, const Campaign& campaign,
                     const Case& chosen) {
    return {accuracy_of(task, campaign), randomness_of(task, campaign, chosen)};
}

Sampling sampling_of(const SamplingRequest& request, const Campaign& campaign,
                     const Case& chosen) {
    constexpr double largest = 0.05;
    constexpr int most_paths = 1 << 20;
    Task task;
    task.generation = request.generation;
    task.is_final = request.is_final;
    Case own = chosen;
    if (request.seed) own.seed = derive_seed(*request.seed, own.name);
    Sampling sampling = sampling_of(task, campaign, own);
    if (!request.tolerance) return sampling;
    if (!(*request.tolerance > 0 && *request.tolerance <= largest))
        throw Error(fmt::format("the tolerance is {} (a relative standard "
                                "error); it must be above 0 and at most {}",
                                *request.tolerance, largest),
                    ExitCode::usage);
    Accuracy& accuracy = sampling.accuracy;
    constexpr int fewest = 8;  // fewest that test a tolerance
    accuracy.randomisations = std::max(accuracy.randomisations, fewest);
    if (request.is_final) accuracy.fields = accuracy.randomisations;
    accuracy.paths = std::max(accuracy.paths, most_paths);
    accuracy.tolerance = *request.tolerance;
    return sampling;
}

}  // namespace ideotype
