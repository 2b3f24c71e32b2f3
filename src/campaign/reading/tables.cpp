// SPDX-License-Identifier: Apache-2.0
#include "tables.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/schema/keys.hpp"
#include "nodes.hpp"
#include "values.hpp"

namespace ideotype {

namespace {

std::string place(const std::string& section) {
    if (section == "top") return "at the top of the file";
    if (section == "crop file") return "at the top of the crop file";
    return "in [" + section + ']';
}

bool is_of_plant_file(const std::string& section) {
    for (const char* own : {"crop file", "stalk", "sheath", "petiole", "blade",
                            "growth", "leaf", "organ", "trait", "bounds"})
        if (section == own) return true;
    return false;
}

//! Returns the sections of the same file that have a key of this name.
std::vector<std::string> owners(const std::string& name,
                                const std::string& section) {
    std::vector<std::string> places;
    for (const KeyInfo& key : campaign_keys())
        if (key.name == name && key.section != section &&
            is_of_plant_file(key.section) == is_of_plant_file(section))
            places.push_back(place(key.section));
    return places;
}

//! Returns advice on the known key that an unknown key may stand for.
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

//! A key that versions after 0.2.3 no longer have, and its replacement.
struct GoneKey {
    std::string section, name, instead;
};

const std::vector<GoneKey> gone_keys{
    {"light", "first_tolerance", "light.tolerance"},
    {"search", "window", "search.streams"},
    {"search", "smallest_step", "search.optimizer = \"auto\""},
    {"search", "restarts", "search.optimizer = \"auto\""},
    {"search", "adapts_learning_rates", "search.optimizer = \"auto\""},
    {"stop", "stagnation", "stop.no_gain"},
    {"stop", "target", "stop.evaluations"}};

struct FormerName {
    std::string section, was, is;
};

const std::vector<FormerName> former_names{
    {"top", "evolution", "search"},
    {"field", "cut", "border_rows"},
    {"stalk", "diameter", "base_diameter"},
    {"blade", "droop_exponent", "curvature_exponent"},
    {"blade", "fold", "folding_angle"},
    {"leaf", "droop", "curvature"},
    {"leaf", "inclination", "insertion_angle"}};

//! Returns the name that an unknown name most likely stands for, or "".
std::string meant_name(const std::string& section, const std::string& name,
                       const std::vector<std::string>& known) {
    for (const FormerName& former : former_names)
        if (former.section == section && former.was == name) return former.is;
    return nearest_name(name, known);
}

}  // namespace

Location TableReader::where(const toml::node& node) const {
    return location(node.source(), file_);
}

TableReader TableReader::in(const Table& table, std::size_t entry) const {
    return {file_, table.resize || table.is_first_of_list
                       ? problems_.in(table.name, entry)
                       : problems_.in(table.name)};
}

void TableReader::read(const toml::table& table, const Section& section,
                       const std::vector<Table>& children) const {
    const std::set<std::string> misspelt =
        report_unknown(table, section, children);
    for (const Key& key : section.keys) {
        const toml::node* node = table.get(key.name);
        problems_.locate(key.name, where(node ? *node : table));
        if (node)
            read_value(*node, section.name, key, problems_);
        else if (misspelt.contains(key.name))
            problems_.spoil(key.name);
        else if (key.is_required && !table.contains(key.unless))
            problems_.add(key.name,
                          "missing key '{}' {} (it has no default); add {} = "
                          "{}",
                          key.name, place(section.name), key.name, key.example);
    }
}

void TableReader::read(const toml::table& parent, const Table& table) const {
    const toml::node* node = parent.get(table.name);
    if (!node) report_missing(parent, table);
    auto found =
        node ? entries(*node, table) : std::vector<const toml::table*>{};
    // Checking so many entries against each other would take too long.
    if (found.size() > table.most) {
        problems_.add(where(*found[table.most]),
                      "there are {} tables [[{}]] (the limit is {}); remove "
                      "some",
                      found.size(), table.name, table.most);
        found.resize(table.most);
    }
    if (node && table.resize) table.resize(found.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        const TableReader entry = in(table, i);
        entry.read(*found[i], table.section(i), table.children);
        for (const Table& child : table.children) entry.read(*found[i], child);
    }
    if (found.empty()) locate(table, where(parent));
}

void TableReader::locate(const Table& table, const Location& place) const {
    for (std::size_t i = 0; i < table.size(); ++i)
        for (const Key& key : table.section(i).keys)
            in(table, i).problems_.locate(key.name, place);
    for (const Table& child : table.children) in(table, 0).locate(child, place);
}

std::vector<const toml::table*> TableReader::entries(const toml::node& node,
                                                     const Table& table) const {
    if (const toml::table* one = node.as_table()) return {one};
    const auto refuse = [&](const toml::node& found, const std::string& how) {
        problems_.add(where(found), "{} is {} (expected: {}", table.name,
                      kind(found), how);
    };
    const std::string lists = fmt::format(
        "tables); write [[{}]] before the keys of each", table.name);
    std::vector<const toml::table*> tables;
    const toml::array* array = node.as_array();
    if (!table.resize)
        refuse(node, fmt::format("one table); write [{}] once", table.name));
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

void TableReader::report_missing(const toml::table& parent,
                                 const Table& table) const {
    // Existing entries are the default.
    if (table.is_optional || (table.resize && table.size() > 0)) return;
    if (table.resize) table.resize(1);
    std::vector<std::string> needed;
    for (const Key& key : table.section(0).keys)
        if (key.is_required) needed.push_back(key.name);
    if (table.resize) table.resize(0);
    if (!needed.empty())
        problems_.add(where(parent),
                      "missing table [{}] (it has no default); add it with {}",
                      table.name, fmt::join(needed, ", "));
}

bool TableReader::is_gone(const std::string& section, const toml::key& key,
                          const toml::node& value) const {
    for (const GoneKey& gone : gone_keys) {
        if (gone.section != section || gone.name != key.str()) continue;
        // Histories may keep keys of their search, which is over; but another
        // tolerance would change the evaluation of a plant.
        const bool is_off = gone.name == "smallest_step" ||
                            (value.value_or(0.) == 0 && !value.value_or(false));
        const bool is_history = file_.ends_with(".h5") && section != "light";
        if (!is_off && !is_history)
            problems_.add(location(key.source(), file_),
                          "{}.{} is a key of versions up to 0.2.3; use {}",
                          section, gone.name, gone.instead);
        return true;
    }
    return false;
}

std::set<std::string> TableReader::report_unknown(
    const toml::table& table, const Section& section,
    const std::vector<Table>& children) const {
    std::vector<std::string> keys;
    for (const Key& key : section.keys) keys.push_back(key.name);
    std::vector<std::string> known = keys;
    for (const Table& child : children) known.push_back(child.name);
    std::set<std::string> misspelt;
    for (const auto& [key, value] : table) {
        const std::string name(key.str());
        if (std::ranges::count(known, name) > 0 ||
            is_gone(section.name, key, value))
            continue;
        const bool is_table = value.is_table() || value.is_array_of_tables();
        const std::string nearest =
            meant_name(section.name, name, is_table ? known : keys);
        misspelt.insert(nearest);
        problems_.add(location(key.source(), file_),
                      "unknown {} '{}' {} (nothing would read it); {}",
                      is_table ? "table" : "key", name, place(section.name),
                      advice(name, nearest, section.name, known));
    }
    return misspelt;
}

}  // namespace ideotype
