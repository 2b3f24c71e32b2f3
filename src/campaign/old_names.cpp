// SPDX-License-Identifier: Apache-2.0
#include "old_names.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "nodes.hpp"

namespace ideotype {

namespace {

struct Renaming {
    std::string_view section;  //!< or the key of a list, for its values
    std::string_view was;
    std::string_view is;         //!< dotted if it is in a table there
    std::string_view if_true{};  //!< what true has become, as TOML
    std::string_view if_false{};
    std::string_view also{};  //!< an entry that goes with it, as TOML
};

//! All names that version 0.2 changed. `ideotype migrate`, the messages and
//! the campaigns in histories of format 1.0 know them from here.
constexpr Renaming renamings[] = {
    {"top", "evolution", "search"},
    {"traits.free", "inclination", "insertion_angle"},
    {"field", "cut", "border_rows"},
    {"plant.bounds", "inclination", "insertion_angle"},
    {"plant", "stalk", "organs", "[\"stalk\"]", "[]"},
    {"constraints", "length_step", "length.step"},
    {"constraints", "width_step", "width.step"},
    {"constraints", "inclination_step", "insertion_angle.step"},
    {"constraints", "insertion_angle_step", "insertion_angle.step"},
    {"constraints", "erect_top", "insertion_angle.falling"},
    {"stalk", "diameter", "base_diameter", "", "", "leaf_base = \"axis\""},
    {"blade", "fold", "folding_angle"},
    {"blade", "droop_exponent", "curvature_exponent"},
    {"leaf", "inclination", "insertion_angle"},
    {"leaf", "droop", "curvature"}};

class Renamer {
  public:
    explicit Renamer(const std::string& file) : file_(file) {}

    //! Renames what is in the node of this dotted name.
    void visit(toml::node& node, const std::string& name) {
        if (toml::array* array = node.as_array())
            for (toml::node& element : *array) visit(element, name);
        if (toml::value<std::string>* text = node.as_string())
            rename_value(*text, name);
        if (toml::table* table = node.as_table()) {
            rename_keys(*table, name.empty() ? "top" : name);
            for (auto&& [key, value] : *table)
                visit(value, name.empty()
                                 ? std::string(key.str())
                                 : fmt::format("{}.{}", name, key.str()));
        }
    }

    std::vector<OldName> found;

  private:
    static bool is_in(const Renaming& renaming, std::string_view name) {
        constexpr std::string_view plant = "plant.baseline.";
        if (name.starts_with(plant)) name.remove_prefix(plant.size());
        return renaming.section == name;
    }

    void rename_value(toml::value<std::string>& text, const std::string& name) {
        for (const Renaming& renaming : renamings) {
            if (!is_in(renaming, name) || text.get() != renaming.was) continue;
            add(text.source(), fmt::format("\"{}\" in {}", renaming.was, name),
                renaming, false);
            text.get() = renaming.is;
        }
    }

    void rename_keys(toml::table& table, const std::string& name) {
        for (const Renaming& renaming : renamings) {
            const auto entry = table.find(renaming.was);
            if (!is_in(renaming, name) || entry == table.end()) continue;
            const toml::source_region source = entry->first.source();
            const bool is_table = entry->second.is_table();
            const std::optional<bool> truth = entry->second.value<bool>();
            const bool is_new = move(table, entry->second, renaming, source);
            table.erase(renaming.was);
            add(source,
                is_table ? fmt::format("table '{}'", renaming.was)
                         : fmt::format("key '{}' in [{}]", renaming.was,
                                       renaming.section),
                renaming, !is_new);
            if (truth && !renaming.if_true.empty())
                found.back().value =
                    *truth ? renaming.if_true : renaming.if_false;
            found.back().also = renaming.also;
        }
    }

    //! Puts an entry where it is today; returns whether there was none.
    static bool move(toml::table& table, toml::node& value,
                     const Renaming& renaming,
                     const toml::source_region& source) {
        toml::table* owner = &table;
        std::string_view name = renaming.is;
        if (const std::size_t dot = name.find('.'); dot != name.npos) {
            const toml::key inner(name.substr(0, dot), source);
            owner = table.insert(inner, toml::table{}).first->second.as_table();
            name.remove_prefix(dot + 1);
        }
        if (!owner) return false;
        if (!renaming.also.empty())
            for (auto&& [key, more] : toml::parse(renaming.also))
                owner->insert(toml::key(key.str(), source), std::move(more));
        const toml::key key(name, source);
        if (const toml::value<bool>* truth = value.as_boolean();
            truth && !renaming.if_true.empty()) {
            const toml::table parsed = toml::parse(
                fmt::format("value = {}", truth->get() ? renaming.if_true
                                                       : renaming.if_false));
            return owner->insert(key, *parsed["value"].as_array()).second;
        }
        return owner->insert(key, std::move(value)).second;
    }

    void add(const toml::source_region& source, const std::string& what,
             const Renaming& renaming, bool is_both) {
        found.push_back({location(source, file_),
                         what,
                         std::string(renaming.was),
                         std::string(renaming.is),
                         is_both,
                         {},
                         {}});
    }

    const std::string& file_;
};

}  // namespace

bool is_before(const OldName& a, const OldName& b) {
    return std::tie(a.where.line, a.where.column) <
           std::tie(b.where.line, b.where.column);
}

std::vector<OldName> rename_entries(toml::table& top, const std::string& file) {
    Renamer renamer(file);
    renamer.visit(top, "");
    std::sort(renamer.found.begin(), renamer.found.end(), is_before);
    return renamer.found;
}

}  // namespace ideotype
