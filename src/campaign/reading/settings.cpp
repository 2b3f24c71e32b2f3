// SPDX-License-Identifier: Apache-2.0
#include "settings.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "nodes.hpp"

namespace ideotype {

namespace {

//! TOML recurses by the parts of a key; keys of campaigns have at most 4.
constexpr auto most_dots = 8;

std::optional<toml::table> parsed(const std::string& text,
                                  const std::string& name) {
    try {
        return toml::parse(text, name);
    } catch (const toml::parse_error&) {
        return std::nullopt;
    }
}

//! Returns a table with the one key that a setting contains.
std::optional<toml::table> read(const std::string& setting,
                                const std::string& name) {
    const std::size_t end = setting.find('=');
    if (end == std::string::npos) return std::nullopt;
    const std::string key = setting.substr(0, end);
    const std::string value = setting.substr(end + 1);
    if (std::count(key.begin(), key.end(), '.') > most_dots ||
        setting.find('\n') != std::string::npos)
        return std::nullopt;
    if (auto table = parsed(key + " = " + value, name)) return table;
    std::string quoted;
    for (const char c : value) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return parsed(key + " = \"" + quoted + '"', name);
}

class Merger {
  public:
    Merger(const std::string& name, const Problems& problems)
        : name_(name), problems_(problems) {}

    void merge(toml::table& into, toml::table& from, const std::string& path) {
        for (auto&& [key, node] : from) {
            const std::string name =
                path.empty() ? std::string(key.str())
                             : fmt::format("{}.{}", path, key.str());
            toml::table* const given = node.as_table();
            toml::table* const known =
                given ? table_at(into[key.str()].node(), name) : nullptr;
            if (known)
                merge(*known, *given, name);
            else if (!is_refused_)
                // A moved node still has the place where it was read.
                node.visit([&, at = key](auto& value) {
                    into.insert_or_assign(at, std::move(value));
                });
        }
    }

  private:
    //! Returns the table itself, or the only table of a list.
    toml::table* table_at(toml::node* node, const std::string& name) {
        if (!node) return nullptr;
        if (toml::table* const table = node->as_table()) return table;
        toml::array* const list = node->as_array();
        if (!list || !list->is_homogeneous<toml::table>()) return nullptr;
        if (list->size() == 1) return list->front().as_table();
        is_refused_ = true;
        problems_.add(Location{name_},
                      fmt::format("there are {} tables [[{}]] (it is not clear "
                                  "which one is meant); change the file",
                                  list->size(), name));
        return nullptr;
    }

    const std::string& name_;
    const Problems& problems_;
    bool is_refused_ = false;
};

}  // namespace

void apply_settings(const std::vector<std::string>& settings,
                    toml::table& campaign, const Problems& problems) {
    for (const std::string& setting : settings) {
        const std::string name = std::string(command_line_mark) + setting;
        problems.open(name);
        if (auto table = read(setting, name))
            Merger(name, problems).merge(campaign, *table, "");
        else
            problems.add(
                Location{name},
                "this is not a key with its value (as a campaign file has "
                "them); write for example --set search.optimizer=random");
    }
}

}  // namespace ideotype
