// SPDX-License-Identifier: Apache-2.0
#include "table_reader.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "spec/nodes.hpp"
#include "spec/removed_keys.hpp"
#include "spec/tables.hpp"
#include "spec/values.hpp"

namespace ideotype {

namespace {

std::string place_of(const std::string& section) {
    if (section == spec_table.section) return "at the top of the file";
    if (section == crop_table.section) return "at the top of the crop file";
    return "in [" + section + ']';
}

bool is_of_crop(const std::string& section) {
    return std::ranges::any_of(documented_tables(), [&](const auto& each) {
        return each.section == section && each.description->is_of_crop;
    });
}

//! Returns the name of a key as users know it.
std::string name_in(const std::string& section, const std::string& key,
                    const Problems& problems) {
    return problems.name_of(key).value_or(
        section == spec_table.section ? key : section + '.' + key);
}

//! Returns the sections of the same file that contain a key of this name.
std::vector<std::string> owners(const std::string& name,
                                const std::string& section) {
    std::vector<std::string> places;
    for (const Documented& table : documented_tables())
        if (table.section != section && find_key(table.section, name) &&
            table.description->is_of_crop == is_of_crop(section))
            places.push_back(place_of(table.section));
    return places;
}

//! Returns advice on an unknown key: the known key that was probably meant.
std::string advice(const std::string& name, const std::string& nearest,
                   const std::string& section,
                   const std::vector<std::string>& known) {
    const std::string places =
        fmt::format("{}", fmt::join(owners(name, section), " or "));
    if (!nearest.empty() && !places.empty())
        return fmt::format("did you mean '{}', or does it belong {}?", nearest,
                           places);
    if (!nearest.empty()) return fmt::format("did you mean '{}'?", nearest);
    if (!places.empty()) return fmt::format("it belongs {}", places);
    return fmt::format("use one of {}", fmt::join(known, ", "));
}

//! Returns the names of a record's tables that are not also names of keys.
std::vector<std::string> names_of_tables(const Description& description,
                                         void* record) {
    std::vector<std::string> names;
    for (const Table& table : description.tables())
        if (table.entry_name)
            for (std::size_t i = 0; i < table.size(record); ++i)
                names.push_back(table.entry_name(table.at(record, i)));
        else if (std::ranges::find(description.keys(),
                                   std::string_view(table.name),
                                   &Key::name) == description.keys().end())
            names.emplace_back(table.name);
    return names;
}

//! Returns the keys of a table to which Description::others applies.
std::vector<std::string> names_of_others(
    const toml::table& table, const Description& description,
    const std::vector<std::string>& tables) {
    std::vector<std::string> names;
    if (!description.others) return names;
    for (const auto& [key, value] : table)
        if (std::ranges::count(tables, key.str()) == 0 &&
            std::ranges::count(description.keys(), key.str(), &Key::name) == 0)
            names.emplace_back(key.str());
    return names;
}

//! Returns the full name in messages of a table inside a section.
std::string inside(const std::string& section, const std::string& name) {
    const bool is_file =
        section == spec_table.section || section == crop_table.section;
    return is_file || section.empty() ? name : section + '.' + name;
}

}  // namespace

Location TableReader::where(const toml::node& node) const {
    return location(node.source(), file_);
}

TableReader TableReader::in(const Table& table, std::size_t entry,
                            void* record) const {
    if (table.entry_name) return in(table.entry_name(record));
    if (table.is_list) return in(fmt::format("{}[{}]", table.name, entry));
    return in(table.name);
}

void TableReader::read(const toml::table& top, const Description& description,
                       void* record) const {
    read_record(top, description, std::string(description.section), record);
}

void TableReader::read_record(const toml::table& table,
                              const Description& description,
                              const std::string& section, void* record) const {
    std::vector<std::string> known = names_of_tables(description, record);
    const std::vector<std::string> others =
        names_of_others(table, description, known);
    known.insert(known.end(), others.begin(), others.end());
    read_keys(table, {section, description.keys(), record}, known);
    for (const std::string& name : others) {
        Key key = *description.others;
        key.name = name.c_str();
        const toml::node& node = *table.get(name);
        problems_.locate(name, where(node));
        read_value(node, section,
                   {key, description.place_of_other(record, name)}, known_,
                   problems_);
    }
    for (const Table& child : description.tables())
        read_table(table, child, inside(section, child.name), record);
}

void TableReader::read_keys(const toml::table& table, const Section& section,
                            const std::vector<std::string>& tables) const {
    const std::set<std::string> misspelt =
        report_unknown(table, section, tables);
    for (std::size_t i = 0; i < section.keys.size(); ++i) {
        const Key& key = section.keys[i];
        const toml::node* node = table.get(key.name);
        problems_.locate(key.name, where(node ? *node : table));
        if (node && table.contains(key.excludes))
            problems_.add(key.name, ProblemCode::contradiction,
                          "{} excludes {}",
                          name_in(section.name, key.excludes, problems_),
                          name_in(section.name, key.name, problems_));
        else if (node)
            read_value(*node, section.name, section[i], known_, problems_);
        else if (misspelt.contains(key.name))
            problems_.spoil(key.name);
        else if (is_required(key, known_) && !table.contains(key.unless))
            problems_.add(
                key.name, ProblemCode::missing,
                "missing key '{}' {} (it has no default); add {} = {}",
                key.name, place_of(section.name), key.name,
                key.initial.example);
    }
}

void TableReader::read_table(const toml::table& top, const Table& table,
                             const std::string& section, void* parent) const {
    if (table.text) return;
    if (table.entry_name) {
        for (std::size_t i = 0; i < table.size(parent); ++i) {
            void* const record = table.at(parent, i);
            const std::string& name = table.entry_name(record);
            const toml::node* const node = top.get(name);
            const std::string own_section =
                section.substr(0, section.rfind('.') + 1) + name;
            const auto tables = node ? entries(*node, table, own_section)
                                     : std::vector<const toml::table*>{};
            for (const toml::table* const each : tables)
                in(name).read_record(*each, *table.description, own_section,
                                     record);
            if (tables.empty())
                in(name).locate(*table.description, record, where(top));
        }
        return;
    }
    const toml::node* node = top.get(table.name);
    if (!node) report_missing(top, table, parent);
    auto tables = node ? entries(*node, table, section)
                       : std::vector<const toml::table*>{};
    // With more entries, checking them against each other would take too long.
    if (tables.size() > table.most) {
        problems_.add_at(
            where(*tables[table.most]), table.name, ProblemCode::out_of_range,
            "there are {} tables [[{}]] (the limit is {}); remove some",
            tables.size(), table.name, table.most);
        tables.resize(table.most);
    }
    // Existing records are defaults; those of the file replace them.
    if (node && table.clear && !table.keeps_records) table.clear(parent);
    if (node && table.resize) table.resize(parent, tables.size());
    for (std::size_t i = 0; i < tables.size(); ++i) {
        void* const record = table.at(parent, i);
        KnownNames known = table.names ? table.names(record) : known_;
        known.passes_over_others = known_.passes_over_others;
        TableReader(file_, in(table, i, record).problems_, known)
            .read_record(*tables[i], *table.description, section, record);
    }
    if (tables.empty()) locate(table, parent, where(top));
}

void TableReader::locate(const Table& table, void* parent,
                         const Location& place) const {
    if (table.text) return;
    for (std::size_t i = 0; i < table.size(parent); ++i) {
        void* const record = table.at(parent, i);
        in(table, i, record).locate(*table.description, record, place);
    }
}

void TableReader::locate(const Description& description, void* record,
                         const Location& place) const {
    for (const Key& key : description.keys()) problems_.locate(key.name, place);
    for (const Table& table : description.tables())
        locate(table, record, place);
}

std::vector<const toml::table*> TableReader::entries(
    const toml::node& node, const Table& table,
    const std::string& section) const {
    if (const toml::table* one = node.as_table()) return {one};
    const auto refuse = [&](const toml::node& wrong, const std::string& how) {
        problems_.add_at(where(wrong), section.substr(section.rfind('.') + 1),
                         ProblemCode::wrong_type, "{} is {} (expected: {}",
                         section, kind(wrong), how);
    };
    const std::string lists =
        fmt::format("tables); write [[{}]] before the keys of each", section);
    std::vector<const toml::table*> tables;
    const toml::array* array = node.as_array();
    if (!table.is_list)
        refuse(node, fmt::format("one table); write [{}] once", section));
    else if (!array || (array->empty() && !table.is_optional))
        refuse(node, lists);
    else
        for (const toml::node& element : *array) {
            if (element.is_table())
                tables.push_back(element.as_table());
            else
                refuse(element, lists);
        }
    return tables;
}

void TableReader::report_missing(const toml::table& top, const Table& table,
                                 const void* parent) const {
    // Existing records are defaults.
    if (table.is_optional || top.contains(table.unless) ||
        (table.is_list && table.size(parent) > 0))
        return;
    std::vector<std::string> needed;
    for (const Key& key : table.description->keys())
        if (key.initial.is_required) needed.emplace_back(key.name);
    if (!needed.empty())
        problems_.add_at(
            where(top), table.name, ProblemCode::missing,
            "missing table [{}] (it has no default); add it with {}",
            table.name, fmt::join(needed, ", "));
}

std::set<std::string> TableReader::report_unknown(
    const toml::table& table, const Section& section,
    const std::vector<std::string>& tables) const {
    std::vector<std::string> keys;
    for (const Key& key : section.keys) keys.emplace_back(key.name);
    std::vector<std::string> known = keys;
    known.insert(known.end(), tables.begin(), tables.end());
    std::set<std::string> misspelt;
    for (const auto& [key, value] : table) {
        const std::string name(key.str());
        const Location place = location(key.source(), file_);
        if (std::ranges::count(known, name) > 0) continue;
        if (known_.passes_over_others && place.file == file_) {
            const std::string path = inside(section.name, name);
            if (!has_former_default(path, value)) problems_.pass_over(path);
            continue;
        }
        const bool is_table = value.is_table() || value.is_array_of_tables();
        const std::string nearest = nearest_name(name, is_table ? known : keys);
        misspelt.insert(nearest);
        problems_.add_at(place, name, ProblemCode::unknown_key,
                         "unknown {} '{}' {} (it would be ignored); {}",
                         is_table ? "table" : "key", name,
                         place_of(section.name),
                         advice(name, nearest, section.name, known));
    }
    return misspelt;
}

}  // namespace ideotype
