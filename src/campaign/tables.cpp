#include "tables.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ideotype/campaign/keys.hpp"
#include "nodes.hpp"
#include "values.hpp"

namespace ideotype {

namespace {

std::string place(const std::string& section) {
    if (section == "top") return "at the top of the file";
    if (section == "plant file") return "at the top of the plant file";
    return "in [" + section + ']';
}

bool is_of_plant_file(const std::string& section) {
    return section == "plant file" || section == "stalk" ||
           section == "blade" || section == "leaf";
}

//! Sections of the same file that have a key of this name.
std::vector<std::string> owners(const std::string& name,
                                const std::string& section) {
    std::vector<std::string> places;
    for (const KeyInfo& key : campaign_keys())
        if (key.name == name && key.section != section &&
            is_of_plant_file(key.section) == is_of_plant_file(section))
            places.push_back(place(key.section));
    return places;
}

//! What an unknown key may have been meant to be.
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

}  // namespace

Location TableReader::where(const toml::node& node) const {
    return location(node.source(), file_);
}

void TableReader::read(const toml::table& table, const Section& section,
                       const std::vector<std::string>& children) {
    const std::set<std::string> misspelt =
        report_unknown(table, section, children);
    for (const Key& key : section.keys) {
        const toml::node* node = table.get(key.name);
        const void* id = address(key.value);
        report_.locate(id, where(node ? *node : table));
        if (node) {
            read_value(*node, section.name, key, report_);
        } else if (misspelt.count(key.name) != 0) {
            report_.spoil(id);
        } else if (key.is_required) {
            report_.add(id, fmt::format("missing key '{}' {} (it has no "
                                        "default); add {} = {}",
                                        key.name, place(section.name), key.name,
                                        key.example));
        }
    }
}

void TableReader::read_child(const toml::table& parent, const std::string& name,
                             const Section& section) {
    const toml::node* node = parent.get(name);
    if (node && !node->is_table())
        report_.add(
            where(*node),
            fmt::format("{} is {} (expected: one table); write [{}] once", name,
                        kind(*node), section.name));
    const bool requires_any =
        std::any_of(section.keys.begin(), section.keys.end(),
                    [](const Key& key) { return key.is_required; });
    if (!node && requires_any) report_missing(parent, name, section);
    if (!node || !node->is_table()) {
        for (const Key& key : section.keys)
            report_.locate(address(key.value), where(parent));
        return;
    }
    read(*node->as_table(), section);
}

std::vector<const toml::table*> TableReader::entries(const toml::table& parent,
                                                     const std::string& name) {
    const toml::node* node = parent.get(name);
    if (!node) return {};
    if (const toml::table* table = node->as_table()) return {table};
    std::vector<const toml::table*> tables;
    const auto refuse = [&](const toml::node& found) {
        report_.add(where(found),
                    fmt::format("{} is {} (expected: tables); write [[{}]] "
                                "before the keys of each",
                                name, kind(found), name));
    };
    if (!node->is_array() || node->as_array()->empty()) {
        refuse(*node);
        return {};
    }
    for (const toml::node& element : *node->as_array()) {
        if (element.is_table())
            tables.push_back(element.as_table());
        else
            refuse(element);
    }
    return tables;
}

void TableReader::report_missing(const toml::table& parent,
                                 const std::string& name,
                                 const Section& section) {
    std::vector<std::string> needed;
    for (const Key& key : section.keys)
        if (key.is_required) needed.push_back(key.name);
    report_.add(where(parent),
                fmt::format("missing table [{}] (it has no default); add it "
                            "with {}",
                            name, fmt::join(needed, ", ")));
}

std::set<std::string> TableReader::report_unknown(
    const toml::table& table, const Section& section,
    const std::vector<std::string>& children) {
    std::vector<std::string> keys;
    for (const Key& key : section.keys) keys.push_back(key.name);
    std::vector<std::string> known = keys;
    known.insert(known.end(), children.begin(), children.end());
    std::set<std::string> misspelt;
    for (const auto& [key, value] : table) {
        const std::string name(key.str());
        if (std::find(known.begin(), known.end(), name) != known.end())
            continue;
        const bool is_table = value.is_table() || value.is_array_of_tables();
        const std::string nearest = nearest_name(name, is_table ? known : keys);
        misspelt.insert(nearest);
        report_.add(
            location(key.source(), file_),
            fmt::format("unknown {} '{}' {} (nothing would read it); "
                        "{}",
                        is_table ? "table" : "key", name, place(section.name),
                        advice(name, nearest, section.name, known)));
    }
    return misspelt;
}

}  // namespace ideotype
