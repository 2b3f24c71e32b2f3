// SPDX-License-Identifier: Apache-2.0
#include "sampling.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"
#include "ideotype/core/hash.hpp"

namespace ideotype {

Accuracy accuracy_of(const Task& task, const Campaign& campaign) {
    constexpr double largest = 0.05;
    constexpr int most_paths = 1 << 20;
    constexpr int fewest = 8;  // fewest that test a tolerance
    Accuracy accuracy =
        task.is_final ? campaign.final_rule.sampling : campaign.sampling;
    if (task.tolerance) {
        if (!(*task.tolerance > 0 && *task.tolerance <= largest))
            throw Error(fmt::format("the tolerance is {} (a relative standard "
                                    "error); it must be above 0 and at most {}",
                                    *task.tolerance, largest),
                        ExitCode::usage);
        accuracy.randomisations = std::max(accuracy.randomisations, fewest);
        accuracy.paths = std::max(accuracy.paths, most_paths);
        accuracy.tolerance = *task.tolerance;
    }
    if (task.is_final) accuracy.fields = accuracy.randomisations;
    return accuracy;
}

Randomness randomness_of(const Task& task, const Campaign& campaign,
                         const Case& chosen) {
    const std::uint64_t seed =
        task.seed ? derive_seed(*task.seed, chosen.name) : chosen.seed;
    if (task.is_final) return {derive_seed(seed, "final")};
    if (campaign.has_light_by_row)
        return {seed, task.generation,
                task.slot * static_cast<std::uint32_t>(
                                campaign.sampling.randomisations),
                campaign.sampling.fields == 1};
    return {seed, task.generation};
}

Sampling sampling_of(const Task& task, const Campaign& campaign,
                     const Case& chosen) {
    return {accuracy_of(task, campaign), randomness_of(task, campaign, chosen)};
}

}  // namespace ideotype
