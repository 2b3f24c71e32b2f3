#include "ideotype/fidelity/probe.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "ideotype/core/hash.hpp"
#include "ideotype/run/evaluator.hpp"

namespace ideotype {

namespace {

//! A standard deviation from an estimate of its square.
Estimate root(double square, double standard_error) {
    if (!(square > 0)) return {0, std::sqrt(standard_error)};
    const double deviation = std::sqrt(square);
    return {deviation, standard_error / (2 * deviation)};
}

}  // namespace

double processor_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) +
           1e-9 * static_cast<double>(time.tv_nsec);
}

double median(std::vector<double> x) {
    if (x.empty()) return 0;
    const auto middle = x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2);
    std::nth_element(x.begin(), middle, x.end());
    return *middle;
}

Rivals rivals(const Campaign& campaign, const Case& chosen) {
    constexpr double part = 0.1;
    const Genome baseline = baseline_numbers(campaign.crop);
    const GeneSpace space = gene_space(campaign, chosen);
    Genome other = baseline;
    for (std::size_t i = 0; i < other.size(); ++i) {
        if (!space[i].is_free) continue;
        const double step = part * (space[i].upper - space[i].lower);
        const bool has_room =
            space[i].is_circular || other[i] + step <= space[i].upper;
        other[i] += has_room ? step : -step;
    }
    return {baseline, other};
}

Probe::Probe(const Variant& variant, std::size_t case_index,
             const Device& device, const Rivals& plants)
    : request_(request_of(variant, case_index, plants[0])),
      crop_(variant.campaign.crop),
      device_(device),
      rivals_(plants) {
    request_.accuracy = {request_.accuracy.paths, 2};
    request_.randomness.seed =
        derive_seed(request_.randomness.seed, "fidelity");
}

Probe::Randomised Probe::evaluate(const Genome& genome, std::uint32_t draw) {
    request_.stand = grow(crop_, genome);
    request_.randomness.generation = draw;
    const CanopyReport report =
        ideotype::evaluate(request_, device_, processor_seconds);
    const Timing& seconds = report.seconds;
    const auto paths = static_cast<double>(report.paths);
    geometry_.push_back(seconds.geometry);
    scene_.push_back(seconds.scene);
    path_.push_back(seconds.light / paths);
    paths_traced_.push_back(paths);
    seconds_ += seconds.total();
    const std::vector<double>& leaves = report.leaves_by_randomisation;
    return {leaves.front(), leaves.back()};
}

void Probe::draw() {
    const auto draw = static_cast<std::uint32_t>(draws());
    const Randomised a = evaluate(rivals_[0], draw);
    const Randomised b = evaluate(rivals_[1], draw);
    const auto append = [this](Goal goal, Randomised x) {
        means_[index(goal)].push_back((x.first + x.second) / 2);
        const double apart = x.first - x.second;
        squares_[index(goal)].push_back(apart * apart / 2);
    };
    append(Goal::value, a);
    append(Goal::difference, {b.first - a.first, b.second - a.second});
}

Scatter Probe::scatter(Goal goal) const {
    const auto n = static_cast<double>(draws());
    const Estimate within = estimate(squares_[index(goal)]);
    const double error = estimate(means_[index(goal)]).standard_error;
    // Of the means of two randomisations: both kinds of scatter.
    const double between = error * error * n;
    return {root(between - within.mean / 2,
                 std::hypot(between * std::sqrt(2 / (n - 1)),
                            within.standard_error / 2)),
            root(within.mean, within.standard_error)};
}

Cost Probe::cost() const {
    return {median(geometry_), median(scene_), median(path_),
            median(paths_traced_)};
}

}  // namespace ideotype
