// SPDX-License-Identifier: Apache-2.0
#include "tables.hpp"

#include <algorithm>

#include "spec/writer.hpp"

namespace ideotype {

namespace {

void append(std::vector<Documented>& documented, const Description& description,
            const std::string& prefix) {
    for (const Table& table : description.tables()) {
        const std::string section = prefix + table.name;
        // Skip tables of crop files, which are documented separately, and
        // tables of components that other sections describe.
        if (table.description->is_of_crop ||
            std::ranges::count(documented, table.description,
                               &Documented::description) > 0 ||
            (!prefix.empty() &&
             std::ranges::count(spec_table.tables(), table.description,
                                &Table::description) > 0))
            continue;
        documented.push_back({section, &table, table.description});
        append(documented, *table.description, section + '.');
    }
}

}  // namespace

const std::vector<Documented>& documented_tables() {
    static const std::vector<Documented> tables = [] {
        std::vector<Documented> documented{
            {std::string(spec_table.section), nullptr, &spec_table}};
        append(documented, spec_table, "");
        documented.push_back(
            {std::string(crop_table.section), nullptr, &crop_table});
        for (const Table& table : crop_table.tables())
            documented.push_back({table.name, &table, table.description});
        return documented;
    }();
    return tables;
}

std::string default_of(const std::string& section, const Key& key) {
    const auto table =
        std::ranges::find(documented_tables(), section, &Documented::section);
    return default_text(key, table->description->usual());
}

const Key* find_key(const std::string& section, const std::string& name) {
    for (const Documented& table : documented_tables()) {
        if (table.section != section) continue;
        const auto keys = table.description->keys();
        const auto key =
            std::ranges::find(keys, std::string_view(name), &Key::name);
        if (key != keys.end()) return &*key;
    }
    return nullptr;
}

}  // namespace ideotype
