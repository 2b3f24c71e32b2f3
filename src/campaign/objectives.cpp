// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "campaign.hpp"
#include "ideotype/canopy/quantities.hpp"

namespace ideotype {

namespace {

//! Returns the objective of this name, with its component if it names one.
ObjectiveEntry to_objective(const std::string& name, Sense sense,
                            const std::vector<std::string>& components) {
    const std::size_t dot = name.find('.');
    if (dot == std::string::npos) return {name, name, {}, sense};
    const auto found = std::ranges::find(components, name.substr(0, dot));
    return {name, name.substr(dot + 1),
            static_cast<std::size_t>(found - components.begin()), sense};
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
    std::vector<ObjectiveEntry> all;
    for (const std::string& each : campaign.maximised)
        all.push_back(to_objective(each, Sense::maximise, components));
    for (const std::string& each : campaign.minimised)
        all.push_back(to_objective(each, Sense::minimise, components));
    return all;
}

std::vector<double> component_weights(const Campaign& campaign) {
    if (campaign.sole.empty()) return campaign.weights;
    std::vector<double> weights;
    for (const double alone : campaign.sole) weights.push_back(1 / alone);
    return weights;
}

std::string unit_of(const Campaign& campaign, const std::string& quantity) {
    const std::vector<ObjectiveEntry> all = objectives_of(campaign);
    const bool is_ratio =
        !campaign.sole.empty() &&
        std::ranges::any_of(all, [&](const ObjectiveEntry& objective) {
            return objective.quantity == quantity;
        });
    return is_ratio ? "1" : unit_of(quantity);
}

}  // namespace ideotype
