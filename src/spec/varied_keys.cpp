// SPDX-License-Identifier: Apache-2.0
#include "varied_keys.hpp"

#include <algorithm>

#include "ideotype/core/contract.hpp"
#include "spec/tables.hpp"

namespace ideotype {

std::vector<VariableKey> variable_keys(Spec& spec) {
    std::vector<VariableKey> keys;
    const auto add = [&](const Description& description, void* record,
                         const std::string& prefix) {
        for (const Table& table : description.tables()) {
            const std::size_t count = table.size(record);
            if (!table.is_variable || count == 0) continue;
            const std::string section = prefix + table.name;
            void* const first = table.at(record, 0);
            for (const Key& key : table.description->keys())
                keys.push_back({section,
                                section + '.' + key.name,
                                {key, key.place(first)},
                                count,
                                !table.is_written || table.is_written(record)});
        }
    };
    add(spec_table, &spec, "");
    if (spec.plant.crop.is_known)
        add(crop_table, &spec.plant.crop, "plant.baseline.");
    return keys;
}

void set_key(Spec& spec, const std::string& key, double value) {
    const std::vector<VariableKey> keys = variable_keys(spec);
    const auto variable = std::ranges::find(keys, key, &VariableKey::name);
    IDEOTYPE_EXPECT(variable != keys.end());
    if (double* const* number = std::get_if<double*>(&variable->key.value))
        **number = value;
    else
        *std::get<std::vector<double>*>(variable->key.value) = {value};
}

void complete_factors(Spec& spec) {
    if (spec.search.keys.empty() && spec.sensitivity.keys.empty()) return;
    const std::vector<VariableKey> keys = variable_keys(spec);
    for (std::vector<KeyFactor>* factors :
         {&spec.search.keys, &spec.sensitivity.keys})
        for (KeyFactor& factor : *factors) {
            const auto variable =
                std::ranges::find(keys, factor.key, &VariableKey::name);
            if (variable == keys.end()) continue;
            const auto numbers = numbers_of(variable->key);
            if (!numbers || numbers->size() > 1) continue;
            const char* const unit = variable->key.key.values.unit;
            factor.unit = *unit ? unit : "1";
            factor.value = numbers->empty()
                               ? (factor.range.lower + factor.range.upper) / 2
                               : numbers->front();
        }
}

}  // namespace ideotype
