#include "ideotype/search/stop_rules.hpp"

#include <algorithm>

namespace ideotype {

namespace {

bool stagnates(const std::vector<double>& mean, int generations) {
    if (mean.size() <= static_cast<std::size_t>(generations)) return false;
    const auto recent = mean.end() - generations;
    return *std::max_element(recent, mean.end()) <=
           *std::max_element(mean.begin(), recent);
}

}  // namespace

std::optional<std::string> finished(const StopRules& rules,
                                    const Progress& progress) {
    const auto generations = static_cast<int>(progress.mean.size());
    if (generations >= rules.generations) return "generations";
    if (rules.target > 0 && !progress.best.empty() &&
        progress.best.back() >= rules.target)
        return "target";
    if (rules.evaluations > 0 && progress.evaluations >= rules.evaluations)
        return "evaluations";
    if (rules.wall_time > 0 && progress.wall_time >= rules.wall_time)
        return "wall_time";
    if (rules.stagnation > 0 && stagnates(progress.mean, rules.stagnation))
        return "stagnation";
    return std::nullopt;
}

}  // namespace ideotype
