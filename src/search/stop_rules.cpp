// SPDX-License-Identifier: Apache-2.0
#include "stop_rules.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

constexpr double certain = 2;  //!< standard errors

//! Returns whether there is no significant rise, neither in a regression line
//! through the last means nor in the hypervolume, if there are several
//! objectives.
bool gains_nothing(const std::vector<GenerationSummary>& summaries,
                   int generations, Sense sense) {
    IDEOTYPE_EXPECT(generations > 2);
    if (summaries.size() < static_cast<std::size_t>(generations)) return false;
    const std::span last(summaries.end() - generations, summaries.end());
    const auto is_feasible = [](const GenerationSummary& summary) {
        return summary.violation == 0 && std::isfinite(summary.mean);
    };
    if (!std::all_of(last.begin(), last.end(), is_feasible)) return false;
    const GenerationSummary& now = last.back();
    if (!std::isnan(now.hypervolume))
        return now.hypervolume - last.front().hypervolume <=
               certain * now.hypervolume_standard_error;
    // Fit a line to the means by least squares. The standard error of its slope
    // follows from the scatter of the means.
    const double n = generations;
    double mean = 0;
    for (const GenerationSummary& summary : last) mean += summary.mean / n;
    double xx = 0, xy = 0, yy = 0, x = -(n - 1) / 2;
    for (const GenerationSummary& summary : last) {
        const double y = summary.mean - mean;
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
    const std::vector<GenerationSummary>& generations = progress.generations;
    if (static_cast<int>(generations.size()) >= rules.generations)
        return all_generations;
    long long evaluations = 0;
    for (const GenerationSummary& summary : generations)
        evaluations += summary.evaluations;
    if (rules.evaluations > 0 && evaluations >= rules.evaluations)
        return "evaluations";
    if (rules.wall_time > 0 && progress.wall_time >= rules.wall_time)
        return "wall_time";
    if (rules.no_gain > 0 && gains_nothing(generations, rules.no_gain, sense))
        return "no_gain";
    return std::nullopt;
}

}  // namespace ideotype
