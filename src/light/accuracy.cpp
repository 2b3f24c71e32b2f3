#include "ideotype/light/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ideotype/core/estimate.hpp"

namespace ideotype {

namespace {

//! A trial has so many paths per randomisation, and one for each source.
constexpr int fewest_paths = 32;

//! Relative standard error of the leaves' light as far as it can be known:
//! where all paths agree, it is not known to be below what one of them carries,
//! and where none has met a leaf, what leaves absorb is only known to be little
//! of all light.
double relative_error(const std::vector<Tally>& tallies, int paths) {
    std::vector<double> leaves;
    for (const Tally& tally : tallies) leaves.push_back(tally.leaves());
    const Estimate found = estimate(leaves);
    const double all =
        static_cast<double>(paths) * static_cast<double>(tallies.size());
    return found.mean > 0 ? std::max(found.standard_error / found.mean, 1 / all)
                          : 1 / std::sqrt(all);
}

//! Paths for an error to fall to a tolerance, if it falls with their square
//! root: doubled so often that it should, so at least once if it is above.
int more_paths(int paths, double error, double tolerance, int most) {
    double wanted = paths;
    const double enough = std::min<double>(
        most, paths * (error / tolerance) * (error / tolerance));
    while (wanted < enough) wanted *= 2;
    return static_cast<int>(std::min<double>(wanted, most));
}

}  // namespace

Simulation simulate_to_tolerance(
    const Scene& scene, const std::vector<Group>& groups, const Optics& optics,
    const Illumination& illumination, const Sampling& sampling,
    const Randomness& randomness, const Layers& layers) {
    const auto trace = [&](int paths, const Randomness& numbers) {
        return simulate(scene, groups, optics, illumination,
                        {paths, sampling.randomisations}, numbers, layers);
    };
    if (!(sampling.tolerance > 0) || illumination.sources.empty())
        return {trace(sampling.paths, randomness), sampling.paths, false};

    Randomness of_trial = randomness;
    of_trial.first_randomisation +=
        static_cast<std::uint32_t>(sampling.randomisations);
    int paths = fewest_paths;
    while (paths < static_cast<int>(illumination.sources.size())) paths *= 2;
    paths = std::min(paths, sampling.paths);
    double error = relative_error(trace(paths, of_trial), paths);
    for (;;) {
        paths = more_paths(paths, error, sampling.tolerance, sampling.paths);
        std::vector<Tally> tallies = trace(paths, randomness);
        error = relative_error(tallies, paths);
        const bool is_met = error <= sampling.tolerance;
        if (is_met || paths == sampling.paths)
            return {std::move(tallies), paths, !is_met};
    }
}

}  // namespace ideotype
