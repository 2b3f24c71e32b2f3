#include "old_names.hpp"

#include <algorithm>
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
    std::string_view is;
};

//! All names that version 0.2 changed. `ideotype migrate`, the messages and
//! the campaigns in histories of format 1.0 know them from here.
constexpr Renaming renamings[] = {
    {"top", "evolution", "search"},
    {"traits.free", "inclination", "insertion_angle"},
    {"field", "cut", "border_rows"},
    {"plant.bounds", "inclination", "insertion_angle"},
    {"constraints", "inclination_step", "insertion_angle_step"},
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
            const bool is_new = table
                                    .insert(toml::key(renaming.is, source),
                                            std::move(entry->second))
                                    .second;
            table.erase(renaming.was);
            add(source,
                is_table ? fmt::format("table '{}'", renaming.was)
                         : fmt::format("key '{}' in [{}]", renaming.was,
                                       renaming.section),
                renaming, !is_new);
        }
    }

    void add(const toml::source_region& source, const std::string& what,
             const Renaming& renaming, bool is_both) {
        found.push_back({location(source, file_), what,
                         std::string(renaming.was), std::string(renaming.is),
                         is_both});
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
