// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "draft.hpp"

namespace ideotype {

//! An enumeration, by the position of its value in a list of names.
struct Choice {
    void* value;
    std::size_t (*get)(const void*);
    void (*set)(void*, std::size_t);
};

template <class Enum>
Choice choice(Enum& value) {
    return {
        &value,
        [](const void* from) {
            return static_cast<std::size_t>(*static_cast<const Enum*>(from));
        },
        [](void* to, std::size_t position) {
            *static_cast<Enum*>(to) = static_cast<Enum>(position);
        }};
}

//! Where the value of a key is kept, which also fixes its type. None: the
//! value has a form of its own and is read and written by hand.
using Target =
    std::variant<std::monostate, std::string*, std::uint64_t*, int*, long long*,
                 double*, std::optional<double>*, bool*, Date*,
                 std::vector<glm::dvec2>*, std::vector<Date>*, Range*,
                 std::vector<double>*, std::vector<std::string>*,
                 std::optional<Column>*, Choice>;

//! The address behind a target, which identifies the value in a Problems.
const void* address(const Target& target);

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

//! Stands for one number or text, or a list of any length.
inline constexpr std::size_t any_count = ~std::size_t{0};

//! One key, bound to the place of its value. This is the only declaration of
//! a key: parsing, the canonical text and the documentation all use it.
struct Key {
    Key(std::string key_name, Target target, std::string words)
        : name(std::move(key_name)), value(target), meaning(std::move(words)) {}

    //! It has no default; messages show the example, as TOML.
    Key& required(const std::string& shown) {
        is_required = true;
        return like(shown);
    }
    Key& like(const std::string& shown) { return set(&Key::example, shown); }
    //! Bounds of numbers.
    Key& within(double least, double most, const std::string& in = "") {
        return set(&Key::lower, least)
            .set(&Key::upper, most)
            .set(&Key::unit, in);
    }
    //! Bounds of lengths [m]; numbers above may have been given in other units.
    Key& metres(double least, double most,
                const std::vector<MistakenUnit>& others = {
                    {"centimetres", 0.01}}) {
        return within(least, most, "m").set(&Key::mistaken, others);
    }
    //! The names of an enumeration's values in their order, or all texts.
    Key& one_of(const std::vector<std::string>& names) {
        return set(&Key::choices, names);
    }
    //! A number that trades speed for accuracy, where that is so.
    Key& trades(const std::vector<double>& values, bool is_so = true) {
        return set(&Key::accuracy, is_so ? values : std::vector<double>{});
    }
    template <class Value, class Given>
    Key& set(Value Key::*member, const Given& given) {
        this->*member = given;
        return *this;
    }

    std::string name;
    Target value;
    std::string meaning;
    bool is_required = false;
    Notation notation = Notation::plain;
    std::string unit;
    //! Units that a number above the range may have been given in.
    std::vector<MistakenUnit> mistaken;
    double lower = 0;
    double upper = 0;          //!< of numbers; lower == upper: none
    std::size_t count = 0;     //!< of the numbers of a list; 0: any
    bool is_any_text = false;  //!< not only a name
    bool is_written = true;    //!< in resolved campaigns
    //! The texts that are allowed; none: any name.
    std::vector<std::string> choices;
    //! Values that `fidelity` tries, the most accurate last; none: the key is
    //! no matter of accuracy.
    std::vector<double> accuracy;
    std::string example;  //!< as TOML, shown in messages
    //! A key of the same table beside which this one is not required.
    std::string unless;
    //! Words for the documentation that can't be had from the above.
    std::string type;
    std::string range;
    std::string initial;
};

//! The keys of one table.
struct Section {
    std::string name;
    std::vector<Key> keys;
};

// Names end up in the names of files and as fixed-length text in them.
inline constexpr auto name_range = "at most 64 letters, digits, _ and -";

//! A table that is written once, or any number of times as [[name]].
struct Table {
    std::string name;
    std::function<Section(std::size_t)> section;  //!< of an entry
    std::function<std::size_t()> size;
    //! Makes all entries again: values are known by their addresses from then
    //! on. None if there is one entry.
    std::function<void(std::size_t)> resize;
    std::vector<Table> children{};  //!< tables in it, if there is one entry
    bool is_default = false;        //!< nothing of it needs to be written
    bool is_optional = false;       //!< there may be no entry
    std::size_t most = 1000;        //!< entries
};

inline Table one_table(const Section& section) {
    return {section.name, [section](std::size_t) { return section; },
            [] { return std::size_t{1}; }, nullptr};
}

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

//! The keys of how plants of a field, or of a component, differ.
Section variation_section(PlantVariation& variation, const std::string& name);

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

//! The optics of plants, which soil has no part in, in both bands.
Table plant_optics_table(Campaign& campaign);

//! The tables of a crop file that campaigns have too, which go before it.
std::vector<Table> crop_defaults(Draft& draft);

// Tables of run_schema.cpp, plant_schema.cpp and object_schema.cpp.
Table plant_table(Draft& draft);
Section light_section(Campaign& campaign);
Table panel_table(Campaign& campaign);
Table object_table(Campaign& campaign);
Section objective_section(Draft& draft);
//! The bounds of each trait of the crop, as a table of [plant] or [component].
Table own_bounds_table(Draft& draft, const std::string& parent);
Section photosynthesis_section(PhotosynthesisTable& table);
//! Returns the table of photosynthesis, which campaigns without assimilation do
//! not have.
Table photosynthesis_table(Draft& draft);

//! Returns the table of constraints, with a table in it for each trait that has
//! any.
Table constraints_table(Constraints& constraints);

//! The keys of a file of measured lines, before its first table.
Section lines_section(MeasuredLines& known);
//! All tables of such a file.
std::vector<Table> lines_tables(MeasuredLines& known);
Table feasibility_table(Draft& draft);
//! Returns the table of the search, with a table in it for each key that is
//! bred.
Table search_table(Draft& draft);
//! Returns the table of a sensitivity study, with a table in it for each key
//! that is varied.
Table sensitivity_table(Draft& draft);
Section stop_section(StopRules& stop);
Section final_section(FinalRule& rule);
Section parallel_section(AnswerLimits& limits);

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
