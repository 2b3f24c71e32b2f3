// SPDX-License-Identifier: Apache-2.0
#include "ideotype/crop/measures.hpp"

#include <string_view>

namespace ideotype {

namespace {

//! Calls visit(owner, is_of_leaves, declared measures, parts) for each kind of
//! part of a plant.
template <class Visit>
void for_each_kind(Plant& plant, const Visit& visit) {
    std::vector<Leaf*> leaves;
    leaves.reserve(plant.leaves.size());
    for (Leaf& leaf : plant.leaves) leaves.push_back(&leaf);
    visit("leaf", true, leaf_measures, leaves);
    visit("blade", false, blade_measures, std::array{&plant.blade});
    visit("stalk", false, stalk_measures, std::array{&plant.stalk});
    visit("stalk", false, tissue_measures<Stalk>, std::array{&plant.stalk});
    visit("sheath", false, sheath_measures, std::array{&plant.sheath});
    visit("sheath", false, tissue_measures<Sheath>, std::array{&plant.sheath});
    visit("petiole", false, petiole_measures, std::array{&plant.petiole});
    for (Organ& organ : plant.organs) {
        visit(organ.name, false, organ_measures, std::array{&organ});
        visit(organ.name, false, tissue_measures<Organ>, std::array{&organ});
    }
}

template <class Part, class Parts>
MeasureInfo describe(const std::string& name, const Measure<Part>& measure,
                     bool is_of_leaves, const Parts& parts) {
    MeasureInfo info{name,
                     measure.unit,
                     measure.limits,
                     is_of_leaves,
                     std::string_view(measure.name) == "azimuth",
                     {}};
    info.values.reserve(parts.size());
    for (Part* part : parts) info.values.push_back(&(part->*measure.value));
    return info;
}

}  // namespace

std::optional<MeasureInfo> find_measure(Plant& plant, const std::string& name) {
    std::optional<MeasureInfo> info;
    const std::size_t dot = name.find('.');
    if (dot == name.npos) return info;
    const std::string_view part = std::string_view(name).substr(0, dot);
    const std::string_view key = std::string_view(name).substr(dot + 1);
    for_each_kind(plant, [&](std::string_view owner, bool is_of_leaves,
                             const auto& declared, const auto& parts) {
        if (owner != part) return;
        for (const auto& measure : declared)
            if (measure.name == key)
                info = describe(name, measure, is_of_leaves, parts);
    });
    return info;
}

std::vector<MeasureInfo> measures(Plant& plant) {
    std::vector<MeasureInfo> infos;
    for_each_kind(plant, [&](const std::string& owner, bool is_of_leaves,
                             const auto& declared, const auto& parts) {
        for (const auto& measure : declared)
            infos.push_back(describe(owner + '.' + measure.name, measure,
                                     is_of_leaves, parts));
    });
    return infos;
}

std::vector<std::string> measure_names(Plant plant) {
    std::vector<std::string> names;
    for (const MeasureInfo& each : measures(plant)) names.push_back(each.name);
    return names;
}

bool follows_internodes(const Plant& plant, const std::string& measure) {
    return (measure == "leaf.insertion_height" || measure == "stalk.height") &&
           !plant.leaves.empty() && plant.leaves.back().internode > 0;
}

}  // namespace ideotype
