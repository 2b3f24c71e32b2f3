// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "campaign.hpp"

namespace ideotype {

namespace {

//! Dotted names and values in the order of a resolved text, in which every line
//! is a header or a key.
using Entries = std::vector<std::pair<std::string, std::string>>;

//! AxisNames of the entries that a case has on each axis.
using AxisNames = std::map<std::string, std::set<std::string>>;

AxisNames names_of(const Case& chosen) {
    AxisNames names;
    for (const Case& each : scenarios(chosen)) {
        names["site"].insert(each.site_name);
        for (const char* axis : {"day", "climate"})
            names[axis].insert(each.day_name);
        names["spacing"].insert(each.spacing_name);
        names["traits"].insert(each.trait_set_name);
    }
    return names;
}

//! Returns whether a case includes a list's entry that has these keys.
bool is_part(const std::string& list, const Entries& keys,
             const AxisNames& names) {
    const auto matches = [&](const std::string& axis, const char* key) {
        return std::ranges::any_of(keys, [&](const auto& entry) {
            return entry.first == key && entry.second.size() > 2 &&
                   names.at(axis).contains(
                       entry.second.substr(1, entry.second.size() - 2));
        });
    };
    if (list == "weather")
        return matches("site", "site") && matches("climate", "climate");
    return !names.contains(list) || matches(list, "name");
}

Entries entries(const std::string& resolved, const AxisNames& names) {
    Entries result, keys;
    std::map<std::string, int> used;
    std::string list, prefix;
    const auto end_table = [&] {
        if (!list.empty() && is_part(list, keys, names)) {
            // An axis that is not over scenarios keeps one entry.
            const bool is_one =
                names.contains(list) && names.at(list).size() == 1;
            prefix = is_one ? list + '.'
                            : fmt::format("{}[{}].", list, used[list]++);
        } else if (!list.empty()) {
            keys.clear();
        }
        for (auto& [name, value] : keys)
            result.emplace_back(prefix + name, std::move(value));
        keys.clear();
    };
    std::istringstream lines(resolved);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t equals = line.find(" = ");
        if (line.starts_with("[")) {
            end_table();
            const bool is_list = line.starts_with("[[");
            list = is_list ? line.substr(2, line.find(']') - 2) : "";
            prefix = is_list ? "" : line.substr(1, line.find(']') - 1) + '.';
        } else if (equals != std::string::npos) {
            keys.emplace_back(line.substr(0, equals), line.substr(equals + 3));
        }
    }
    end_table();
    // The number of replicates, and the time that workers may take, do not
    // change the results of a case.
    std::erase_if(result, [](const auto& entry) {
        return entry.first == "replicates" ||
               entry.first.starts_with("parallel.");
    });
    return result;
}

const std::string* find(const Entries& entries, const std::string& name) {
    const auto found = std::ranges::find_if(
        entries, [&](const auto& entry) { return entry.first == name; });
    return found == entries.end() ? nullptr : &found->second;
}

//! Returns a value as it stands, or shortened if it has a season's numbers.
std::string shown(const std::string& value) {
    constexpr std::size_t longest = 80;
    if (value.size() <= longest) return value;
    return fmt::format("{}... ({} characters)", value.substr(0, longest / 2),
                       value.size());
}

}  // namespace

std::vector<std::string> differences(const std::string& was,
                                     const std::string& is,
                                     const Case& chosen) {
    if (was == is) return {};
    const AxisNames names = names_of(chosen);
    const Entries before = entries(was, names);
    const Entries after = entries(is, names);
    std::vector<std::string> lines;
    for (const auto& [name, value] : before) {
        const std::string* now = find(after, name);
        if (!now)
            lines.push_back(
                fmt::format("{} was {}, is absent", name, shown(value)));
        else if (*now != value)
            lines.push_back(fmt::format("{} was {}, is {}", name, shown(value),
                                        shown(*now)));
    }
    for (const auto& [name, value] : after)
        if (!find(before, name))
            lines.push_back(
                fmt::format("{} was absent, is {}", name, shown(value)));
    return lines;
}

}  // namespace ideotype
