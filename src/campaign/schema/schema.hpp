// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "campaign/draft.hpp"
#include "keys.hpp"

namespace ideotype {

//! The place of an enumeration whose values are written by their names.
struct Choice {
    std::function<std::string()> get;
    std::function<void(const std::string&)> set;
    std::vector<std::string> names;
};

//! Returns the place of an enumeration.
//! @param names names beside the values, in the order of messages
template <class Enum>
Choice choice(Enum& value,
              const std::vector<std::pair<std::string, Enum>>& names) {
    Choice place{[=, &value] {
                     for (const auto& [name, each] : names)
                         if (each == value) return name;
                     return std::string();
                 },
                 [=, &value](const std::string& text) {
                     for (const auto& [name, each] : names)
                         if (text == name) value = each;
                 },
                 {}};
    for (const auto& each : names) place.names.push_back(each.first);
    return place;
}

//! The place of the value of a key, which also fixes the type of the value.
//! None: the value has a form of its own and is read and written by hand.
using Target =
    std::variant<std::monostate, std::string*, std::uint64_t*, int*, long long*,
                 double*, std::optional<double>*, bool*, Date*,
                 std::vector<glm::dvec2>*, std::vector<Date>*, Range*,
                 std::vector<double>*, std::vector<std::string>*,
                 std::optional<Column>*, Choice>;

//! A unit in which numbers are given by mistake, in units of the key.
struct MistakenUnit {
    const char* name;
    double value;
};

//! The count of a list of any length, or of one number or text.
inline constexpr std::size_t any_count = ~std::size_t{0};

//! One key, bound to the place of its value. docs/campaign_files.md declares
//! its type, unit, range and default; parsing and the canonical text use them.
struct Key {
    Key(const std::string& key, Target place, const KeyInfo& declared);

    //! Recognises lengths above the range that may be in other units.
    Key& in_metres(const std::vector<MistakenUnit>& others = {
                       {"centimetres", 0.01}}) {
        return mistaken = others, *this;
    }
    //! Allows only these texts.
    Key& one_of(const std::vector<std::string>& names) {
        return choices = names, *this;
    }
    //! Makes the value a list or a single number, written only if not empty.
    Key& optional_list();
    //! Writes the key in resolved campaigns only if a condition holds.
    Key& written_if(bool is_so) { return is_written = is_so, *this; }
    //! Marks a key that trades speed for accuracy, if a condition holds.
    //! @param values values that `fidelity` tries, the most accurate last
    Key& trades(const std::vector<double>& values, bool is_so = true);

    //! Returns whether the key is a local time, stored in hours.
    bool is_clock() const { return type == "local time"; }
    //! Returns whether the key may be text such as "1h30m", in seconds.
    bool is_duration() const { return type.starts_with("number or \""); }

    std::string name;
    Target value;
    std::string type, unit;
    double lower = 0, upper = 0;  //!< limits; none if equal
    std::string range;            //!< range in words, if not numbers or texts
    std::vector<std::string> choices;  //!< allowed texts; none: any
    std::string example;               //!< example as TOML for messages
    bool is_required = false;
    bool is_any_text = false;  //!< whether texts other than names fit
    bool is_written = true;    //!< whether resolved campaigns have the key
    std::size_t count = 0;     //!< length of a list; 0: any
    std::vector<MistakenUnit> mistaken{};  //!< units of numbers above the range
    std::vector<double> accuracy{};        //!< values for `fidelity`
    std::string unless{};  //!< key of the table that makes this optional
};

//! The keys of one table.
struct Section {
    //! @param places places of the values of keys
    //! @param like section of the documentation that declares the keys
    Section(std::string table,
            const std::vector<std::pair<std::string, Target>>& places,
            const std::string& like = "");

    void add(const std::string& key, Target place) {
        keys.emplace_back(key, std::move(place), key_info(name, key));
    }

    //! Returns the key of this name.
    Key& operator[](const std::string& key);

    std::string name;
    std::vector<Key> keys;
};

//! A table that is written once, or any number of times as [[name]].
struct Table {
    //! Allows the table to have no entry.
    Table& optional() { return is_optional = true, *this; }
    //! Lets the table be left out if a condition holds.
    Table& left_out_if(bool is_so) { return is_default = is_so, *this; }
    //! Sets the largest number of entries.
    Table& at_most(std::size_t entries) { return most = entries, *this; }
    //! Adds a table inside this table, under a name of its own.
    Table& with(Table child, const std::string& child_name);

    std::string name;
    std::function<Section(std::size_t)> section;  //!< section of an entry
    std::function<std::size_t()> size;
    //! Makes a number of new entries. None if the table has exactly one entry.
    std::function<void(std::size_t)> resize;
    std::vector<Table> children{};  //!< tables inside a single entry
    bool is_default = false;        //!< whether the table may be left out
    bool is_optional = false;       //!< whether a list may be empty
    std::size_t most = 1000;        //!< largest number of entries
    bool is_first_of_list = false;  //!< whether keys have paths as "site[0]"
};

//! Returns a table that is written once.
Table one_table(const Section& section);

//! Returns the tables [[name]], one for each record.
template <class Record>
Table list_of_tables(const std::string& name, const auto& section_of,
                     std::vector<Record>& records) {
    return {name,
            [&records, section_of](std::size_t i) {
                return section_of(records.at(i));
            },
            [&records] { return records.size(); },
            [&records](std::size_t n) { records.assign(n, Record{}); }};
}

//! Returns the keys before the first table.
Section top_section(Campaign& campaign);

//! Returns [site] and [climate] of a file of only these; names may be left out.
std::vector<Table> climate_file_tables(Campaign& campaign);

//! Returns all tables of a campaign in the order of its resolved text.
std::vector<Table> campaign_tables(Draft& draft);

//! Returns the keys of a crop file or [plant.baseline] before the first table.
Section plant_file_section(Plant& plant);

//! Returns the names of all organs that plants may have besides leaves.
std::vector<std::string> all_organs(const Plant& plant);

//! Returns all tables of a crop file.
std::vector<Table> plant_tables(Draft& draft);

//! Returns the tables of both crop files and campaigns, first in a crop file.
std::vector<Table> crop_defaults(Draft& draft);

//! Returns the keys before the first table of a file of measured lines.
Section lines_section(MeasuredLines& known);
//! Returns all tables of a file of measured lines.
std::vector<Table> lines_tables(MeasuredLines& known);

// The functions below return parts of the tables of campaigns or crop files.
Section site_section(Site& site);
Section day_section(Named<DaySpan>& day);
Section climate_section(Named<Climate>& named);
Section weather_section(SiteWeather& weather);
//! Returns the keys of the variation of plants in a field or component.
Section variation_section(PlantVariation& variation, const std::string& name);
//! Returns the table of the differences between plants in a crop file.
Section crop_variation_section(CropVariation& variation);
Section photosynthesis_section(PhotosynthesisTable& table);
//! Returns the table of the optics of plants in each waveband and, in a
//! campaign, of the soil.
Table optics_table(Campaign& campaign, bool has_soil);
//! Returns the place of the rule of bounds; none if a table gives bounds.
Target place_of_rule(Draft& draft);
//! Returns the bounds of each trait as a table of [plant] or [component].
Table own_bounds_table(Draft& draft, const std::string& parent);
Table plant_table(Draft& draft);
Table feasibility_table(Draft& draft);
//! Returns the tables of panels and objects.
std::vector<Table> object_tables(Campaign& campaign);
//! Returns the tables [light] and [objective].
std::vector<Table> measured_tables(Draft& draft);
//! Returns the table of constraints, with a table in it for each limited trait.
Table constraints_table(Constraints& constraints);
//! Returns the tables of searches and studies, with tables inside for each
//! varied key, and the tables for the end and the work of a run.
std::vector<Table> run_tables(Draft& draft);

inline constexpr std::size_t most_components = 20;
inline constexpr std::size_t most_leaves = 40;
inline constexpr std::size_t most_organs = 40;
inline constexpr std::size_t most_traits = 100;
//! Most entries of an axis.
inline constexpr std::size_t most_entries = 10'000;
inline constexpr std::size_t most_cases = 100'000;

//! Returns the value of a key as canonical TOML: the shortest text from which
//! the same value is read.
std::string toml_text(const Key& key);

//! Returns the fault of a number as the value of a key, or "" if it has none.
std::string fault_of(double value, const std::string& section, const Key& key);

//! Returns a local clock time [h] as TOML: "07:00:00".
std::string clock_text(double hours);

//! Returns a range such as `-90 .. 90 deg`.
std::string range_text(const Key& key);

//! Sets a factor that check_sensitivity() has accepted to another value.
void set_key(Draft& draft, const KeyFactor& factor, double value);

//! Returns the whole campaign as canonical TOML: every key in a fixed order,
//! axes as arrays of tables, and the plant inlined.
std::string resolved_text(Draft& draft);

//! Returns the keys that trade speed for accuracy, in tables that occur once.
std::vector<AccuracyKey> accuracy_keys(Draft& draft);

//! Returns the text of a crop file with the plant of a draft.
std::string resolved_plant_text(Draft& draft);

}  // namespace ideotype
