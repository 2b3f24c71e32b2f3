// SPDX-License-Identifier: Apache-2.0
#include "tables.hpp"

#include <algorithm>

#include "spec/writer.hpp"

namespace ideotype {

namespace {

void append(std::vector<Documented>& all, const Description& description,
            const std::string& prefix) {
    for (const Table& table : description.tables()) {
        const std::string section = prefix + table.name;
        // Crop files have sections of their own, and components have tables
        // that other sections describe, perhaps later ones.
        if (table.description->is_of_crop ||
            std::ranges::count(all, table.description,
                               &Documented::description) > 0 ||
            (!prefix.empty() &&
             std::ranges::count(spec_table.tables(), table.description,
                                &Table::description) > 0))
            continue;
        all.push_back({section, &table, table.description});
        append(all, *table.description, section + '.');
    }
}

}  // namespace

const std::vector<Documented>& documented_tables() {
    static const std::vector<Documented> tables = [] {
        std::vector<Documented> all{
            {std::string(spec_table.section), nullptr, &spec_table}};
        append(all, spec_table, "");
        all.push_back({std::string(crop_table.section), nullptr, &crop_table});
        for (const Table& table : crop_table.tables())
            all.push_back({table.name, &table, table.description});
        return all;
    }();
    return tables;
}

std::string default_of(const std::string& section, const Key& key) {
    const auto found =
        std::ranges::find(documented_tables(), section, &Documented::section);
    return default_text(key, found->description->usual());
}

const Key* find_key(const std::string& section, const std::string& name) {
    for (const Documented& each : documented_tables()) {
        if (each.section != section) continue;
        const auto keys = each.description->keys();
        const auto found =
            std::ranges::find(keys, std::string_view(name), &Key::name);
        if (found != keys.end()) return &*found;
    }
    return nullptr;
}

}  // namespace ideotype
