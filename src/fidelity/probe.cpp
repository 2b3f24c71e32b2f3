#include "ideotype/fidelity/probe.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "ideotype/core/hash.hpp"
#include "ideotype/light/transport.hpp"
#include "ideotype/run/evaluator.hpp"

namespace ideotype {

namespace {

double leaves(const Tally& tally) {
    double sum = 0;
    for (const Budget& budget : tally.sources) sum += budget.leaves;
    return sum;
}

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
    const Genome baseline = to_genome(campaign.baseline);
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

Probe::Probe(Variant variant, std::size_t case_index, const Device& device,
             const Rivals& plants)
    : variant_(std::move(variant)),
      case_(case_of(variant_, case_index)),
      model_(canopy_model(variant_.campaign, case_)),
      device_(device),
      rivals_(plants) {
    const Campaign& campaign = variant_.campaign;
    if (variant_.skies == Variant::Skies::each) {
        std::vector<Source>& sources = model_.light.light.sources;
        std::erase_if(sources,
                      [](const Source& source) { return !source.direction; });
        for (const TimeStep& step : model_.light.day.steps) {
            const SunPosition sun{
                step.sun.zenith,
                step.sun.azimuth - case_.spacing.row_direction};
            sources.push_back({std::nullopt, step.par.diffuse * step.seconds,
                               SkySampler({campaign.sky_model, sun})});
        }
    }
    arrange();
}

void Probe::arrange() {
    const Illumination& day = model_.light.light;
    const int paths = variant_.campaign.sampling.paths;
    if (variant_.sky_effort == 1) {
        lights_ = {day};
        paths_ = {paths};
        return;
    }
    Illumination beam, sky;
    for (const Source& source : day.sources)
        (source.direction ? beam : sky).sources.push_back(source);
    const double share =
        std::min(0.9, variant_.sky_effort * sky.energy() / day.energy());
    const int of_sky = static_cast<int>(paths * share);
    lights_ = {beam, sky};
    paths_ = {
        std::max<int>(paths - of_sky, static_cast<int>(beam.sources.size())),
        std::max<int>(of_sky, static_cast<int>(sky.sources.size()))};
}

Probe::Randomised Probe::evaluate(const Genome& genome, std::uint32_t draw) {
    const std::uint64_t seed = derive_seed(case_.seed, "fidelity");
    const double began = processor_seconds();
    const Field field =
        build_field(model_, build_plant(model_, to_traits(genome)),
                    {seed, draw, variant_.campaign.sampling}, 0);
    const double built = processor_seconds();
    const Scene scene = build_scene(device_, field);
    const double committed = processor_seconds();
    Randomised result{};
    int traced = 0;
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const Accuracy sampling{paths_[i], 2};
        const std::vector<Tally> tallies =
            simulate(scene, field.mesh.groups, model_.optics, lights_[i],
                     sampling, {seed + i, draw, 0});
        result.first += leaves(tallies[0]);
        result.second += leaves(tallies[1]);
        traced += 2 * sampling.paths;
    }
    const double ended = processor_seconds();
    geometry_.push_back(built - began);
    scene_.push_back(committed - built);
    path_.push_back((ended - committed) / traced);
    paths_traced_.push_back(traced);
    seconds_ += ended - began;
    return result;
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
