// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "campaign.hpp"
#include "spec/writer.hpp"

namespace ideotype {

namespace {

//! Dotted key names and values, in the order of a resolved text.
using Entries = std::vector<std::pair<std::string, std::string>>;

//! The names of a case's entries on each axis. With scenarios there may be
//! several.
struct EntriesOfCase {
    std::set<std::string> sites, days, spacings, trait_sets;

    explicit EntriesOfCase(const Case& chosen) {
        for (const Case& scenario : scenarios(chosen)) {
            sites.insert(scenario.site_name);
            days.insert(scenario.day_name);
            spacings.insert(scenario.spacing_name);
            trait_sets.insert(scenario.trait_set_name);
        }
    }

    //! Returns whether a list has a single entry for a case. Messages then omit
    //! the index.
    bool is_single(const std::string& list) const {
        const std::pair<const char*, std::size_t> counts[] = {
            {"site", sites.size()},
            {"day", days.size()},
            {"climate", days.size()},
            {"spacing", spacings.size()},
            {"traits", trait_sets.size()}};
        return std::ranges::any_of(counts, [&](const auto& axis) {
            return axis.first == list && axis.second == 1;
        });
    }
};

//! Returns the part of a campaign that determines the results of a case. It
//! contains only the case's entries on each axis, and neither the number of
//! replicates nor the limits of workers.
Spec part_of(Spec spec, const EntriesOfCase& entries) {
    const auto keep = [](auto& list, const std::set<std::string>& names) {
        std::erase_if(list, [&](const auto& entry) {
            return !names.contains(entry.name);
        });
    };
    keep(spec.sites, entries.sites);
    keep(spec.days, entries.days);
    keep(spec.climates, entries.days);
    keep(spec.spacings, entries.spacings);
    keep(spec.trait_sets, entries.trait_sets);
    std::erase_if(spec.weathers, [&](const SiteWeather& weather) {
        return !entries.sites.contains(weather.site) ||
               !entries.days.contains(weather.climate);
    });
    spec.replicates = Spec().replicates;
    spec.parallel = {};
    return spec;
}

//! Returns the dotted names and the values of all keys.
Entries entries_of(const Spec& spec, const EntriesOfCase& chosen) {
    Entries entries;
    std::map<std::string, int> used;
    std::string prefix;
    std::istringstream lines(resolved_text(spec));
    for (std::string line; std::getline(lines, line);) {
        const std::size_t equals = line.find(" = ");
        if (line.starts_with("[")) {
            const bool is_list = line.starts_with("[[");
            prefix = line.substr(is_list + 1U, line.find(']') - is_list - 1U);
            if (is_list && !chosen.is_single(prefix))
                prefix += fmt::format("[{}]", used[prefix]++);
            prefix += '.';
        } else if (equals != std::string::npos) {
            entries.emplace_back(prefix + line.substr(0, equals),
                                 line.substr(equals + 3));
        }
    }
    return entries;
}

const std::string* find(const Entries& entries, const std::string& name) {
    const auto match = std::ranges::find_if(
        entries, [&](const auto& entry) { return entry.first == name; });
    return match == entries.end() ? nullptr : &match->second;
}

//! Returns a value, shortened if it is as long as the weather of a season.
std::string shown(const std::string& value) {
    constexpr std::size_t longest = 80;
    if (value.size() <= longest) return value;
    return fmt::format("{}... ({} characters)", value.substr(0, longest / 2),
                       value.size());
}

}  // namespace

std::vector<std::string> differences(const Spec& was, const Spec& is,
                                     const Case& chosen) {
    const EntriesOfCase entries(chosen);
    const Entries before = entries_of(part_of(was, entries), entries);
    const Entries after = entries_of(part_of(is, entries), entries);
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
