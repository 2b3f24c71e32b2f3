// SPDX-License-Identifier: Apache-2.0
#include "stop_rules.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

constexpr double certain = 2;  //!< number of standard errors

//! Returns whether no significant rise is seen in a line through the last
//! means, or in the hypervolume of several objectives.
bool gains_nothing(const std::vector<GenerationSummary>& all, int generations,
                   Sense sense) {
    IDEOTYPE_EXPECT(generations > 2);
    if (all.size() < static_cast<std::size_t>(generations)) return false;
    const std::span last(all.end() - generations, all.end());
    const auto is_feasible = [](const GenerationSummary& each) {
        return each.violation == 0 && std::isfinite(each.mean);
    };
    if (!std::all_of(last.begin(), last.end(), is_feasible)) return false;
    const GenerationSummary& now = last.back();
    if (!std::isnan(now.hypervolume))
        return now.hypervolume - last.front().hypervolume <=
               certain * now.hypervolume_standard_error;
    const double n = generations;
    double mean = 0;
    for (const GenerationSummary& each : last) mean += each.mean / n;
    double xx = 0, xy = 0, yy = 0, x = -(n - 1) / 2;
    for (const GenerationSummary& each : last) {
        const double y = each.mean - mean;
        xx += x * x;
        xy += x * y;
        yy += y * y;
        ++x;
    }
    const double slope = xy / xx;
    const double scatter = std::max(yy - slope * xy, 0.0) / (n - 2);
    const double gain = sense == Sense::maximise ? slope : -slope;
    return gain <= certain * std::sqrt(scatter / xx);
}

}  // namespace

std::optional<std::string> finished(const StopRules& rules,
                                    const Progress& progress, Sense sense) {
    IDEOTYPE_EXPECT(!(progress.wall_time < 0));
    const std::vector<GenerationSummary>& all = progress.generations;
    if (static_cast<int>(all.size()) >= rules.generations)
        return all_generations;
    long long evaluations = 0;
    for (const GenerationSummary& each : all) evaluations += each.evaluations;
    if (rules.evaluations > 0 && evaluations >= rules.evaluations)
        return "evaluations";
    if (rules.wall_time > 0 && progress.wall_time >= rules.wall_time)
        return "wall_time";
    if (rules.no_gain > 0 && gains_nothing(all, rules.no_gain, sense))
        return "no_gain";
    return std::nullopt;
}

}  // namespace ideotype
