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
    return std::visit(
        [&](const auto& value) -> std::optional<std::vector<double>> {
            using Value = std::remove_cvref_t<decltype(value)>;
            if constexpr (std::is_same_v<Value, double*> ||
                          std::is_same_v<Value, int*> ||
                          std::is_same_v<Value, long long*>) {
                return std::vector{static_cast<double>(*value)};
            } else if constexpr (std::is_same_v<Value,
                                                std::optional<double>*> ||
                                 std::is_same_v<Value, std::optional<int>*>) {
                if (!*value) return std::vector<double>{};
                return std::vector{static_cast<double>(**value)};
            } else if constexpr (std::is_same_v<Value, std::vector<double>*>) {
                if (key.key.values.count == any_count) return *value;
            }
            return std::nullopt;
        },
        key.value);
}

bool is_integer(const BoundKey& key) {
    return std::holds_alternative<int*>(key.value) ||
           std::holds_alternative<long long*>(key.value) ||
           std::holds_alternative<std::optional<int>*>(key.value);
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
