// SPDX-License-Identifier: Apache-2.0
#include "section.hpp"

#include <string_view>

#include "ideotype/crop/measures.hpp"
#include "spec/tables.hpp"

namespace ideotype {

KnownNames names_of(const CropSpec& crop) {
    KnownNames known;
    // If the crop could not be read, its traits are unknown.
    if (crop.is_known)
        for (const TraitEntry& each : crop.traits)
            known.traits.push_back(each.trait.name);
    known.rules = rule_names(crop);
    known.organs = all_organs(crop.baseline);
    return known;
}

std::vector<std::string> allowed_texts(const Key& key,
                                       const KnownNames& known) {
    switch (key.values.names) {
        case Names::traits:
            return known.traits;
        case Names::rules:
            return known.rules;
        case Names::organs:
            return known.organs;
        case Names::objectives:
            if (!known.objectives.empty()) return known.objectives;
            break;
        case Names::none:
            break;
    }
    if (key.values.known) return key.values.known();
    if (key.enumeration) return key.enumeration();
    std::vector<std::string> texts;
    for (const char* const text : key.values.texts)
        if (text) texts.emplace_back(text);
    return texts;
}

bool is_required(const Key& key, const KnownNames& known) {
    return key.initial.is_required &&
           !(key.values.names == Names::traits && known.may_free_nothing);
}

std::optional<std::vector<double>> numbers_of(const BoundKey& key) {
    const Form form = key.key.values.form;
    if (form == Form::clock || form == Form::duration) return std::nullopt;
    if (const auto* number = std::get_if<double*>(&key.value))
        return std::vector{**number};
    const auto* list = std::get_if<std::vector<double>*>(&key.value);
    if (list && key.key.values.count == any_count) return **list;
    return std::nullopt;
}

std::vector<Key> own_bounds_keys(const CropSpec& crop) {
    std::vector<Key> keys;
    Plant plant = crop.baseline;
    for (const TraitEntry& entry : crop.traits) {
        Key& key = keys.emplace_back(own_bounds_table.keys().front());
        key.name = entry.trait.name.c_str();
        if (entry.sets.empty()) continue;
        const auto measure = find_measure(plant, entry.sets.front());
        if (!measure) continue;
        const auto& [lower, upper] = measure->limits;
        const char* const type = key.values.type;
        key.values = std::string_view(measure->unit) == "m"
                         ? metres(lower, upper)
                         : within(lower, upper, measure->unit);
        key.values.type = type;
    }
    return keys;
}

}  // namespace ideotype
