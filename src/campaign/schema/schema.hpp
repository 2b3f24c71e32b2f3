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

#include "campaign/draft.hpp"
#include "keys.hpp"

namespace ideotype {

//! The place of an enumeration, which is written by the names of its values.
struct Choice {
    std::function<std::string()> get;
    std::function<void(const std::string&)> set;
    std::vector<std::string> names;
};

//! Returns the place of an enumeration.
//! @param names beside its values, in the order of messages
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

//! The place of the value of a key, which also fixes its type. None: the value
//! has a form of its own and is read and written by hand.
using Target =
    std::variant<std::monostate, std::string*, std::uint64_t*, int*, long long*,
                 double*, std::optional<double>*, bool*, Date*,
                 std::vector<glm::dvec2>*, std::vector<Date>*, Range*,
                 std::vector<double>*, std::vector<std::string>*,
                 std::optional<Column>*, Choice>;

//! A unit that numbers are given in by mistake, and what it is in the key's.
struct MistakenUnit {
    const char* name;
    double value;
};

//! Stands for one number or text, or a list of any length.
inline constexpr std::size_t any_count = ~std::size_t{0};

//! One key, bound to the place of its value. docs/campaign_files.md declares
//! its type, unit, range and default; parsing and the canonical text use them.
struct Key {
    Key(const std::string& key, Target place, const KeyInfo& declared);

    //! Lengths above the range may have been given in other units.
    Key& in_metres(const std::vector<MistakenUnit>& others = {
                       {"centimetres", 0.01}});
    //! Allows one of these texts.
    Key& one_of(const std::vector<std::string>& names);
    //! Makes it a list, or one number alone, that is written if it has any.
    Key& optional_list();
    //! Leaves it out of resolved campaigns where that is not so.
    Key& written_if(bool is_so);
    //! Says that it trades speed for accuracy, where that is so.
    //! @param values that `fidelity` tries, the most accurate last
    Key& trades(const std::vector<double>& values, bool is_so = true);

    //! Returns whether the key is a local time, which is kept in hours.
    bool is_clock() const { return type == "local time"; }
    //! Returns whether the key may be text such as "1h30m", kept in
    //! seconds.
    bool is_duration() const { return type.starts_with("number or \""); }

    std::string name;
    Target value;
    std::string type, unit;
    double lower = 0, upper = 0;  //!< limits of numbers; none if equal
    std::string range;            //!< in words, if it is no numbers or texts
    std::vector<std::string> choices;  //!< texts that are allowed; none: any
    std::string example;               //!< as TOML, shown in messages
    bool is_required = false;
    bool is_any_text = false;  //!< not only a name
    bool is_written = true;    //!< in resolved campaigns
    std::size_t count = 0;     //!< count of the numbers of a list; 0: any
    //! Units that a number above the range may have been given in.
    std::vector<MistakenUnit> mistaken{};
    std::vector<double> accuracy{};  //!< see trades()
    //! A key of the same table beside which this one is not required.
    std::string unless{};
};

//! The keys of one table.
struct Section {
    //! @param places of the values of keys
    //! @param like section of the documentation that declares them
    Section(std::string table,
            const std::vector<std::pair<std::string, Target>>& places,
            const std::string& like = "");

    void add(const std::string& key, Target place) {
        keys.emplace_back(key, std::move(place), key_info(name, key));
    }

    //! The key of this name.
    Key& operator[](const std::string& key);

    std::string name;
    std::vector<Key> keys;
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

//! Returns the keys before the first table.
Section top_section(Campaign& campaign);

//! [site] and [climate] of a file that has nothing else; names may be left
//! out.
std::vector<Table> climate_file_tables(Campaign& campaign);

//! Returns all tables of a campaign in the order of its resolved text.
std::vector<Table> campaign_tables(Draft& draft);

//! Returns the keys of a crop file, or of [plant.baseline], before the first
//! table.
Section plant_file_section(Plant& plant);

//! Returns the names of all organs besides leaves that plants may have.
std::vector<std::string> all_organs(const Plant& plant);

//! Returns all tables of a crop file.
std::vector<Table> plant_tables(Draft& draft);

//! Returns the tables of a crop file that campaigns have too, which go before
//! it.
std::vector<Table> crop_defaults(Draft& draft);

//! Returns the keys of a file of measured lines, before its first table.
Section lines_section(MeasuredLines& known);
//! Returns all tables of such a file.
std::vector<Table> lines_tables(MeasuredLines& known);

// Parts of the tables of a campaign and of a crop file.
Section site_section(Site& site);
Section day_section(Named<DaySpan>& day);
Section climate_section(Named<Climate>& named);
Section weather_section(SiteWeather& weather);
//! Returns the keys of how plants of a field, or of a component, differ.
Section variation_section(PlantVariation& variation, const std::string& name);
Section photosynthesis_section(PhotosynthesisTable& table);
//! Returns the optics of plants in each waveband, and in a campaign those of
//! the soil.
Table optics_table(Campaign& campaign, bool has_soil);
//! Returns the place of the rule of bounds; none where a table has them.
Target place_of_rule(Draft& draft);
//! Returns the bounds of each trait of the crop, as a table of [plant] or
//! [component].
Table own_bounds_table(Draft& draft, const std::string& parent);
Table plant_table(Draft& draft);
Table feasibility_table(Draft& draft);
//! Returns the tables of panels and objects.
std::vector<Table> object_tables(Campaign& campaign);
//! Returns the tables [light] and [objective].
std::vector<Table> measured_tables(Draft& draft);
//! Returns the table of constraints, with a table in it for each trait that has
//! any.
Table constraints_table(Constraints& constraints);
//! Returns the tables of searches and studies, with tables in them for each key
//! that is varied, and those of how a run ends and works.
std::vector<Table> run_tables(Draft& draft);

inline constexpr std::size_t most_components = 20;
inline constexpr std::size_t most_leaves = 40;
inline constexpr std::size_t most_organs = 40;
inline constexpr std::size_t most_traits = 100;
inline constexpr std::size_t most_entries = 10'000;  //!< of an axis
inline constexpr std::size_t most_cases = 100'000;

//! Returns the value of a key as canonical TOML: shortest text that reads back
//! to the same value.
std::string toml_text(const Key& key);

//! Returns a local clock time [h] as TOML: "07:00:00".
std::string clock_text(double hours);

//! Returns a range such as `-90 .. 90 deg`.
std::string range_text(const Key& key);

}  // namespace ideotype
