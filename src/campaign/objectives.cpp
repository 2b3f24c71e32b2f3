// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include "campaign.hpp"
#include "ideotype/canopy/quantities.hpp"
#include "ideotype/crop/measures.hpp"

namespace ideotype {

namespace {

ObjectiveEntry to_objective(const std::string& name, Sense sense,
                            const std::vector<std::string>& components) {
    const std::size_t dot = name.find('.');
    if (dot == std::string::npos) return {name, name, {}, sense};
    const auto position = std::ranges::find(components, name.substr(0, dot));
    return {name, name.substr(dot + 1),
            static_cast<std::size_t>(position - components.begin()), sense};
}

constexpr double circle = 360;

//! Returns the excess of a value over its limit, relative to the limit.
double excess(double value, double limit) {
    return std::max(0.0, value - limit) / limit;
}

double excess(double value, const Range& allowed) {
    double sum = excess(value, allowed.upper);
    if (value < allowed.lower) sum += (allowed.lower - value) / allowed.lower;
    return sum;
}

//! Returns the absolute difference of two values; for directions [deg], along
//! the shorter arc.
double distance(double a, double b, bool is_direction) {
    const double apart = std::abs(a - b);
    if (!is_direction) return apart;
    const double rest = std::fmod(apart, circle);
    return std::min(rest, circle - rest);
}

double step_excess(const std::vector<double>& leaves, double limit,
                   bool is_direction) {
    double sum = 0;
    for (std::size_t i = 1; limit > 0 && i < leaves.size(); ++i)
        sum += excess(distance(leaves[i], leaves[i - 1], is_direction), limit);
    return sum;
}

//! Returns the sum of all increases from one leaf to the next, relative to the
//! range.
double rise(const std::vector<double>& leaves, const Range& limits) {
    double sum = 0;
    for (std::size_t i = 1; i < leaves.size(); ++i)
        sum += std::max(0.0, leaves[i] - leaves[i - 1]) /
               (limits.upper - limits.lower);
    return sum;
}

//! Returns the azimuth of the plane from which alternating (distichous) leaves
//! deviate least, by their largest deviation. After every other leaf is turned
//! by 180 deg, it is the middle of the smallest arc that includes all leaves.
double plane(std::vector<double> leaves) {
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        leaves[i] =
            std::fmod(leaves[i] + (i % 2 == 0 ? 0 : circle / 2), circle);
        if (leaves[i] < 0) leaves[i] += circle;
    }
    std::sort(leaves.begin(), leaves.end());
    double first = leaves.front(), length = leaves.back() - leaves.front();
    for (std::size_t i = 1; i < leaves.size(); ++i) {
        const double other = circle - (leaves[i] - leaves[i - 1]);
        if (other >= length) continue;
        first = leaves[i];
        length = other;
    }
    return first + length / 2;
}

double distichous_excess(const std::vector<double>& azimuths, double limit) {
    if (!(limit > 0) || azimuths.empty()) return 0;
    const double middle = plane(azimuths);
    double sum = 0;
    for (std::size_t i = 0; i < azimuths.size(); ++i)
        sum += excess(
            distance(azimuths[i], middle + (i % 2 == 0 ? 0 : circle / 2), true),
            limit);
    // Ignore rounding errors, since leaves may be exactly at the limit.
    constexpr double rounding = 1e-12;
    return sum > rounding ? sum : 0;
}

//! Returns the excess over a range, relative to the limit or, if the limit is
//! 0, to the range of the measure.
double range_excess(const std::vector<double>& leaves,
                    const TraitConstraint& limit, const Range& limits) {
    const std::size_t count = limit.highest > 0
                                  ? static_cast<std::size_t>(limit.highest)
                                  : leaves.size();
    const double width = limits.upper - limits.lower;
    const auto beyond = [&](double distance, double from) {
        return std::max(0.0, distance) / (from != 0 ? std::abs(from) : width);
    };
    double sum = 0;
    for (std::size_t i = leaves.size() - std::min(count, leaves.size());
         i < leaves.size(); ++i)
        sum += beyond(leaves[i] - limit.range.upper, limit.range.upper) +
               beyond(limit.range.lower - leaves[i], limit.range.lower);
    return sum;
}

double violation(const TraitConstraint& limit, const MeasureInfo& measure) {
    std::vector<double> leaves;
    for (const double* value : measure.values) leaves.push_back(*value);
    double sum = step_excess(leaves, limit.step, measure.is_direction);
    sum +=
        excess(std::accumulate(leaves.begin(), leaves.end(), 0.0), limit.total);
    sum += range_excess(leaves, limit, measure.limits);
    if (limit.is_falling) sum += rise(leaves, measure.limits);
    return sum + distichous_excess(leaves, limit.distichous);
}

}  // namespace

std::vector<std::string> component_names(const Campaign& campaign) {
    std::vector<std::string> names{campaign.crop.baseline.name};
    for (const ComponentEntry& each : campaign.components)
        names.push_back(each.name);
    return names;
}

std::vector<ObjectiveEntry> objectives_of(const Campaign& campaign) {
    const std::vector<std::string> components = component_names(campaign);
    std::vector<ObjectiveEntry> objectives;
    for (const std::string& each : campaign.spec.objective.maximised)
        objectives.push_back(to_objective(each, Sense::maximise, components));
    for (const std::string& each : campaign.spec.objective.minimised)
        objectives.push_back(to_objective(each, Sense::minimise, components));
    return objectives;
}

std::vector<double> component_weights(const Campaign& campaign) {
    if (campaign.spec.objective.sole.empty())
        return campaign.spec.objective.weights;
    std::vector<double> weights;
    for (const double alone : campaign.spec.objective.sole)
        weights.push_back(1 / alone);
    return weights;
}

std::string unit_of(const Campaign& campaign, const std::string& quantity) {
    const std::vector<ObjectiveEntry> objectives = objectives_of(campaign);
    const bool is_ratio =
        !campaign.spec.objective.sole.empty() &&
        std::ranges::any_of(objectives, [&](const ObjectiveEntry& objective) {
            return objective.quantity == quantity;
        });
    return is_ratio ? "1" : unit_of(quantity);
}

std::string unit_of(const Campaign& campaign, const ObjectiveEntry& objective) {
    return campaign.spec.objective.across == Across::probability &&
                   !campaign.spec.objective.over.empty()
               ? "1"
               : unit_of(campaign, objective.quantity);
}

bool asks_for(const Campaign& campaign, bool (*is_of)(const std::string&)) {
    return std::ranges::any_of(objectives_of(campaign), is_of,
                               &ObjectiveEntry::quantity) ||
           std::ranges::any_of(campaign.search.axes, is_of,
                               &AtlasAxis::quantity);
}

double violation(const Constraints& constraints,
                 const std::vector<Trait>& traits, const Plant& plant,
                 double lai) {
    double sum = excess(lai, constraints.lai);
    if (constraints.traits.empty()) return sum;
    Plant measured = plant;
    for (const TraitConstraint& limit : constraints.traits) {
        const auto trait = std::ranges::find(traits, limit.trait, &Trait::name);
        sum +=
            violation(limit, *find_measure(measured, trait->measures.front()));
    }
    return sum;
}

}  // namespace ideotype
