#include "ideotype/search/stop_rules.hpp"

#include <algorithm>

#include "ideotype/search/order.hpp"

namespace ideotype {

namespace {

bool has_improved(const GenerationSummary& before,
                  const GenerationSummary& after, Sense sense) {
    if (before.violation > 0 || after.violation > 0)
        return after.violation < before.violation;
    return is_better(after.mean, before.mean, sense);
}

bool stagnates(const std::vector<GenerationSummary>& all, int generations,
               Sense sense) {
    if (all.size() <= static_cast<std::size_t>(generations)) return false;
    const auto improved = [&](const auto& before, const auto& after) {
        return has_improved(before, after, sense);
    };
    const auto recent = all.end() - generations;
    return !improved(*std::max_element(all.begin(), recent, improved),
                     *std::max_element(recent, all.end(), improved));
}

bool reaches(double target, const GenerationSummary& last, Sense sense) {
    return last.violation == 0 && !is_better(target, last.best, sense);
}

}  // namespace

std::optional<std::string> finished(const StopRules& rules,
                                    const Progress& progress, Sense sense) {
    const std::vector<GenerationSummary>& all = progress.generations;
    if (static_cast<int>(all.size()) >= rules.generations) return "generations";
    if (rules.target != 0 && !all.empty() &&
        reaches(rules.target, all.back(), sense))
        return "target";
    long long evaluations = 0;
    for (const GenerationSummary& each : all) evaluations += each.evaluations;
    if (rules.evaluations > 0 && evaluations >= rules.evaluations)
        return "evaluations";
    if (rules.wall_time > 0 && progress.wall_time >= rules.wall_time)
        return "wall_time";
    if (rules.stagnation > 0 && stagnates(all, rules.stagnation, sense))
        return "stagnation";
    return std::nullopt;
}

}  // namespace ideotype
