// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "draft.hpp"

namespace ideotype {

//! The place of an enumeration, which is written by the names of its values.
struct Choice {
    std::function<std::string()> get;
    std::function<void(const std::string&)> set;
};

//! Names beside the values of an enumeration, in the order of messages.
template <class Enum>
using ValueNames = std::vector<std::pair<std::string, Enum>>;

//! The place of the value of a key, which also fixes its type. None: the value
//! has a form of its own and is read and written by hand.
using Target =
    std::variant<std::monostate, std::string*, std::uint64_t*, int*, long long*,
                 double*, std::optional<double>*, bool*, Date*,
                 std::vector<glm::dvec2>*, std::vector<Date>*, Range*,
                 std::vector<double>*, std::vector<std::string>*,
                 std::optional<Column>*, Choice>;

//! The form in which a number is written.
enum class Notation {
    plain,
    clock,     //!< TOML local time, kept as hours
    duration,  //!< seconds, "1h30m" or "HH:MM:SS", kept as seconds
};

//! A unit that numbers are given in by mistake, and what it is in the key's.
struct MistakenUnit {
    const char* name;
    double value;
};

//! The least and the greatest value of a number, and its unit; the same twice:
//! any number will do.
struct Bounds {
    double lower = 0, upper = 0;
    std::string unit{};
};

//! Stands for one number or text, or a list of any length.
inline constexpr std::size_t any_count = ~std::size_t{0};

//! One key, bound to the place of its value. This is the only declaration of
//! a key: parsing, the canonical text and the documentation all use it.
struct Key {
    //! It has no default; messages show the example, as TOML.
    Key& required(const std::string& shown);
    //! Messages show the example, as TOML.
    Key& like(const std::string& shown);
    //! The documentation tells this default.
    Key& defaults(const std::string& words);
    //! The documentation and messages tell this range.
    Key& allows(const std::string& words);
    //! The documentation and messages tell this type.
    Key& of_type(const std::string& words);
    //! Numbers above the bounds, which are lengths [m], may have been given in
    //! other units.
    Key& in_metres(const std::vector<MistakenUnit>& others = {
                       {"centimetres", 0.01}});
    //! One of these texts.
    Key& one_of(const std::vector<std::string>& texts);
    //! One number or text, or a list of them.
    Key& or_list(const std::string& words = "");
    //! A list that is written only if there is anything in it.
    Key& optional_list(const std::string& words, const std::string& default_is,
                       const std::string& shown);
    //! Resolved campaigns have it only where that is so.
    Key& written_if(bool is_so);
    //! A number that trades speed for accuracy, where that is so.
    Key& trades(const std::vector<double>& values, bool is_so = true);

    std::string name;
    Target value;
    Bounds bounds;
    std::string meaning;
    bool is_required = false;
    Notation notation = Notation::plain;
    //! Units that a number above the range may have been given in.
    std::vector<MistakenUnit> mistaken{};
    std::size_t count = 0;     //!< of the numbers of a list; 0: any
    bool is_any_text = false;  //!< not only a name
    bool is_written = true;    //!< in resolved campaigns
    //! The texts that are allowed; none: any name.
    std::vector<std::string> choices{};
    //! Values that `fidelity` tries, the most accurate last; none: the key is
    //! no matter of accuracy.
    std::vector<double> accuracy{};
    std::string example{};  //!< as TOML, shown in messages
    //! A key of the same table beside which this one is not required.
    std::string unless{};
    //! Words for the documentation that can't be had from the above.
    std::string type{}, range{}, initial{};
};

// Names end up in the names of files and as fixed-length text in them.
inline constexpr auto name_range = "at most 64 letters, digits, _ and -";
inline constexpr auto date_range = "1950-01-01 .. 2100-12-31";

//! The keys of one table.
struct Section {
    std::string name;
    std::vector<Key> keys{};

    //! Declares a key whose value is kept at this place.
    template <class Value>
    Key& add(const std::string& key, Value& value, const std::string& meaning) {
        return keys.emplace_back(Key{key, &value, {}, meaning});
    }
    template <class Value>
    Key& add(const std::string& key, Value& value, const Bounds& bounds,
             const std::string& meaning) {
        return keys.emplace_back(Key{key, &value, bounds, meaning});
    }

    //! Declares a key whose value is one of an enumeration.
    template <class Enum>
    requires std::is_enum_v<Enum> Key& add(
        const std::string& key, Enum& value,
        const std::type_identity_t<ValueNames<Enum>>& names,
        const std::string& meaning) {
        Choice choice{[=, &value] {
                          for (const auto& [text, each] : names)
                              if (each == value) return text;
                          return std::string();
                      },
                      [=, &value](const std::string& given) {
                          for (const auto& [text, each] : names)
                              if (text == given) value = each;
                      }};
        Key& added = keys.emplace_back(Key{key, choice, {}, meaning});
        for (const auto& each : names) added.choices.push_back(each.first);
        return added;
    }

    //! Declares a key whose value is read and written by hand.
    Key& add_by_hand(const std::string& key, const std::string& type,
                     const std::string& meaning);
    //! Declares the rule of bounds, which a table may stand in the place of.
    Key& add_rule(std::string& rule, const std::vector<std::string>& rules,
                  const std::string& meaning);
    //! Declares a name, which may stand in the name of a file.
    Key& add_name(const std::string& key, std::string& value,
                  const std::string& meaning);
    //! Declares a path relative to the campaign file.
    Key& add_path(const std::string& key, std::string& value,
                  const std::string& example, const std::string& meaning);
    //! Declares how exactly light is counted.
    Key& add_paths(Accuracy& accuracy, const std::string& meaning);
    Key& add_randomisations(Accuracy& accuracy);
};

//! A table that is written once, or any number of times as [[name]].
struct Table {
    //! There may be no entry.
    Table& optional();
    //! Nothing of it needs to be written where that is so.
    Table& left_out_if(bool is_so);
    //! There are so many entries at most.
    Table& at_most(std::size_t entries);
    //! Adds a table in this one, under a name that need not be its section's.
    Table& with(Table child, const std::string& child_name);

    std::string name;
    std::function<Section(std::size_t)> section;  //!< of an entry
    std::function<std::size_t()> size;
    //! Makes all entries again. None if there is one entry.
    std::function<void(std::size_t)> resize;
    std::vector<Table> children{};  //!< tables in it, if there is one entry
    bool is_default = false;        //!< nothing of it needs to be written
    bool is_optional = false;       //!< there may be no entry
    std::size_t most = 1000;        //!< entries
    //! The paths of its keys are those of the first of a list, "site[0]".
    bool is_first_of_list = false;
};

//! Returns a table that is written once.
Table one_table(const Section& section);

//! Returns the tables [[name]], one for each record.
template <class Record>
Table list_of_tables(const std::string& name,
                     const std::function<Section(Record&)>& section_of,
                     std::vector<Record>& records) {
    return {name,
            [&records, section_of](std::size_t i) {
                return section_of(records.at(i));
            },
            [&records] { return records.size(); },
            [&records](std::size_t n) { records.assign(n, Record{}); }};
}

//! The keys before the first table.
Section top_section(Campaign& campaign);

//! [site] and [climate] of a file that has nothing else; names may be left
//! out.
std::vector<Table> climate_file_tables(Campaign& campaign);

//! All tables of a campaign in the order of its resolved text.
std::vector<Table> campaign_tables(Draft& draft);

//! The keys of a crop file, or of [plant.baseline], before the first table.
Section plant_file_section(Plant& plant);

//! The names of all organs besides leaves that plants may have.
std::vector<std::string> all_organs(const Plant& plant);

//! All tables of a crop file.
std::vector<Table> plant_tables(Draft& draft);

//! The tables of a crop file that campaigns have too, which go before it.
std::vector<Table> crop_defaults(Draft& draft);

//! The keys of a file of measured lines, before its first table.
Section lines_section(MeasuredLines& known);
//! All tables of such a file.
std::vector<Table> lines_tables(MeasuredLines& known);

// Parts of the tables of a campaign and of a crop file.
Section site_section(Site& site);
Section day_section(Named<DaySpan>& day);
Section climate_section(Named<Climate>& named);
Section weather_section(SiteWeather& weather);
//! The keys of how plants of a field, or of a component, differ.
Section variation_section(PlantVariation& variation, const std::string& name);
Section photosynthesis_section(PhotosynthesisTable& table);
//! The optics of plants in both bands, and in a campaign those of the soil.
Table optics_table(Campaign& campaign, bool has_soil);
//! The bounds of each trait of the crop, as a table of [plant] or [component].
Table own_bounds_table(Draft& draft, const std::string& parent);
Table plant_table(Draft& draft);
Table feasibility_table(Draft& draft);
//! The tables of panels and objects.
std::vector<Table> object_tables(Campaign& campaign);
//! The tables [light] and [objective].
std::vector<Table> measured_tables(Draft& draft);
//! The table of constraints, with a table in it for each trait that has any.
Table constraints_table(Constraints& constraints);
//! The tables of searches and studies, with tables in them for each key that
//! is varied, and those of how a run ends and works.
std::vector<Table> run_tables(Draft& draft);

inline constexpr std::size_t most_components = 20;
inline constexpr std::size_t most_leaves = 40;
inline constexpr std::size_t most_organs = 40;
inline constexpr std::size_t most_traits = 100;
inline constexpr std::size_t most_entries = 10'000;  //!< of an axis
inline constexpr std::size_t most_cases = 100'000;

//! The value of a key as canonical TOML: shortest text that reads back to
//! the same value.
std::string toml_text(const Key& key);

//! A local clock time [h] as TOML: "07:00:00".
std::string clock_text(double hours);

//! `-90 .. 90 deg`
std::string range_text(const Key& key);

//! Returns the kind of value that a user has to write for this key, such as
//! "integer".
std::string type_text(const Key& key);

}  // namespace ideotype
