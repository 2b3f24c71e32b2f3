// SPDX-License-Identifier: Apache-2.0
#include "ideotype/fidelity/probe.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "ideotype/canopy/quantities.hpp"
#include "ideotype/core/hash.hpp"
#include "ideotype/stand/stand.hpp"

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
    : objective_(aims(variant.campaign).front().quantity),
      request_(request_of(variant, case_index, plants[0])),
      crop_(variant.campaign.crop),
      device_(device),
      rivals_(plants) {
    request_.accuracy = {request_.accuracy.paths, variant.randomisations};
    request_.randomness.seed =
        derive_seed(request_.randomness.seed, "fidelity");
}

std::vector<double> Probe::evaluate(const Genome& genome, std::uint32_t draw) {
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
    return measure_objective(objective_, report).by_randomisation;
}

void Probe::draw() {
    const auto draw = static_cast<std::uint32_t>(draws());
    const std::vector<double> a = evaluate(rivals_[0], draw);
    std::vector<double> b = evaluate(rivals_[1], draw);
    for (std::size_t r = 0; r < a.size(); ++r) b[r] -= a[r];
    append(Goal::value, a);
    append(Goal::difference, b);
}

void Probe::append(Goal goal, const std::vector<double>& values) {
    const Estimate found = estimate(values);
    means_[index(goal)].push_back(found.mean);
    variances_[index(goal)].push_back(found.standard_error *
                                      found.standard_error *
                                      static_cast<double>(values.size()));
}

Scatter Probe::scatter(Goal goal) const {
    const auto n = static_cast<double>(draws());
    const Estimate within = estimate(variances_[index(goal)]);
    const int r = request_.accuracy.randomisations;
    const double error = estimate(means_[index(goal)]).standard_error;
    // Of the means of randomisations: both kinds of scatter.
    const double between = error * error * n;
    return {root(between - within.mean / r,
                 std::hypot(between * std::sqrt(2 / (n - 1)),
                            within.standard_error / r)),
            root(within.mean, within.standard_error)};
}

Cost Probe::cost() const {
    return {median(geometry_), median(scene_), median(path_),
            median(paths_traced_)};
}

}  // namespace ideotype
