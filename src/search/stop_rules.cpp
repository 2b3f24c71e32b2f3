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

//! Returns the mean of the means of generations that end between four fifths of
//! a number of evaluations and this number, of three generations at least.
//! Returns nothing if there are fewer, or if one is without feasible plants.
std::optional<Estimate> level(std::span<const GenerationSummary> generations,
                              double evaluations) {
    constexpr double share = 0.8;
    constexpr std::size_t fewest = 3;
    std::vector<double> means;
    std::size_t count = 0;  // of generations that end in the range
    double end = 0;
    for (const GenerationSummary& each : generations) {
        end += each.evaluations;
        if (end > evaluations) break;
        if (!(each.violation == 0 && std::isfinite(each.mean))) {
            means.clear();
            count = 0;
            continue;
        }
        means.push_back(each.mean);
        if (end > share * evaluations) ++count;
    }
    if (means.size() < fewest) return std::nullopt;
    return estimate(std::span(means).last(std::max(count, fewest)));
}

}  // namespace

std::optional<GainLeft> gain_left(
    std::span<const GenerationSummary> generations, double baseline,
    Sense sense) {
    constexpr double fewest = 250, factor = 1.02, part_of_error = 0.1;
    double evaluations = 0;
    for (const GenerationSummary& each : generations)
        evaluations += each.evaluations;
    if (evaluations < fewest || std::isnan(baseline)) return std::nullopt;
    const auto now = level(generations, evaluations);
    const auto before = level(generations, evaluations / 2);
    if (!now || !before) return std::nullopt;
    const double sign = sense == Sense::maximise ? 1 : -1;
    const double error =
        std::hypot(now->standard_error, before->standard_error);
    return GainLeft{sign * (now->mean - baseline),
                    factor * std::max(sign * (now->mean - before->mean),
                                      part_of_error * error)};
}

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
    if (rules.gain_left > 0) {
        const auto gain = gain_left(generations, progress.baseline, sense);
        if (gain && gain->so_far > 0 &&
            gain->most <= rules.gain_left * gain->so_far)
            return "gain_left";
    }
    return std::nullopt;
}

}  // namespace ideotype
