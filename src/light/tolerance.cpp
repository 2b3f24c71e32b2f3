#include "ideotype/light/tolerance.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "ideotype/light/report.hpp"

namespace ideotype {

namespace {

//! Of a trial at least: with so many the error is known to a fifth.
constexpr int trial_randomisations = 16;

//! Trials have randomisations that no result has.
constexpr std::uint32_t first_of_trials = 1u << 16;

//! A trial with fewer paths than the result over this is followed by another.
constexpr double longest_step = 8;

//! Of the first trial, and of the result: one path for each source too.
int fewest(const Accuracy& accuracy, std::size_t sources) {
    int paths = fewest_paths;
    while (paths < static_cast<int>(sources)) paths *= 2;
    return std::min(paths, accuracy.paths);
}

//! Relative standard error of the leaves' light; 0 if that is certain,
//! infinite if no path has met a leaf.
double relative_error(const std::vector<Tally>& tallies) {
    const Estimate found = absorbed_by_leaves(tallies);
    if (found.standard_error == 0) return 0;
    return found.mean > 0 ? found.standard_error / found.mean
                          : std::numeric_limits<double>::infinity();
}

//! A trial that underestimates the error leads to too few paths. The expected
//! error stays within the tolerance if all estimates are multiplied by the
//! mean of sqrt(v / X), X from a chi-square distribution with v degrees of
//! freedom: 1 + 3 / (4 v) and a little.
double caution(int randomisations) {
    return 1 + 0.8 / (randomisations - 1);
}

//! How many paths per randomisation a tolerance asks for.
//! @param trials randomisations of each trial
//! @param error relative error of the n-th trial, with so many paths
double enough_paths(const Accuracy& accuracy, int trials, int first,
                    const std::function<double(int, std::uint32_t)>& error) {
    const double wanted = accuracy.tolerance / caution(trials) *
                          std::sqrt(1. * accuracy.randomisations / trials);
    int paths = first;
    for (std::uint32_t n = 0;; ++n) {
        // Scrambled nets converge a little faster than independent paths.
        const double excess = error(paths, n) / wanted;
        const double enough = paths * excess * excess;
        const double next = std::isfinite(enough) ? enough / longest_step
                                                  : paths * longest_step;
        if (next <= paths || next >= accuracy.paths) {
            // Nothing is known more finely than to one path.
            const double coarsest =
                1 / (accuracy.tolerance * accuracy.randomisations);
            return std::max(enough, coarsest);
        }
        paths = static_cast<int>(next);
    }
}

}  // namespace

Simulation simulate_to_tolerance(
    const Scene& scene, const std::vector<Group>& groups, const Optics& optics,
    const Illumination& illumination, const Accuracy& accuracy,
    const Randomness& randomness, const Layers& layers) {
    const auto trace = [&](int paths, int randomisations,
                           const Randomness& numbers) {
        return simulate(scene, groups, optics, illumination,
                        {paths, randomisations}, numbers, layers);
    };
    if (!(accuracy.tolerance > 0) || illumination.sources.empty())
        return {trace(accuracy.paths, accuracy.randomisations, randomness),
                accuracy.paths, false};

    const int trials = std::max(trial_randomisations, accuracy.randomisations);
    const auto error_of_trial = [&](int paths, std::uint32_t n) {
        Randomness numbers = randomness;
        numbers.first_randomisation += (n + 1) * first_of_trials;
        return relative_error(trace(paths, trials, numbers));
    };
    const int least = fewest(accuracy, illumination.sources.size());
    const double enough = enough_paths(accuracy, trials, least, error_of_trial);
    const int paths = static_cast<int>(
        std::clamp<double>(std::ceil(enough), least, accuracy.paths));
    Simulation result{trace(paths, accuracy.randomisations, randomness), paths,
                      false};
    result.is_capped = enough > accuracy.paths &&
                       relative_error(result.tallies) > accuracy.tolerance;
    return result;
}

}  // namespace ideotype
