// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "ideotype/campaign/campaign.hpp"

namespace ideotype {

namespace {

//! Dotted names and values in the order of a resolved text, of which every
//! line is a header or a key.
using Entries = std::vector<std::pair<std::string, std::string>>;

Entries entries(const std::string& resolved) {
    Entries result;
    std::map<std::string, int> used;
    std::string prefix;
    std::istringstream lines(resolved);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t equals = line.find(" = ");
        if (line.starts_with("[[")) {
            const std::string name = line.substr(2, line.find(']') - 2);
            prefix = fmt::format("{}[{}].", name, used[name]++);
        } else if (line.starts_with("[")) {
            prefix = line.substr(1, line.find(']') - 1) + '.';
        } else if (equals != std::string::npos) {
            result.emplace_back(prefix + line.substr(0, equals),
                                line.substr(equals + 3));
        }
    }
    return result;
}

const std::string* find(const Entries& entries, const std::string& name) {
    const auto found =
        std::find_if(entries.begin(), entries.end(),
                     [&](const auto& entry) { return entry.first == name; });
    return found == entries.end() ? nullptr : &found->second;
}

}  // namespace

namespace {

//! As it stands, but for numbers of a whole season.
std::string shown(const std::string& value) {
    constexpr std::size_t longest = 80;
    if (value.size() <= longest) return value;
    return fmt::format("{}... ({} characters)", value.substr(0, longest / 2),
                       value.size());
}

}  // namespace

std::vector<std::string> differences(const std::string& was,
                                     const std::string& is) {
    const Entries before = entries(was);
    const Entries after = entries(is);
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
