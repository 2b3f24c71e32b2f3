// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>

#include "ideotype/climate/sun.hpp"
#include "ideotype/climate/weather.hpp"
#include "ideotype/core/enum_names.hpp"
#include "ideotype/core/range.hpp"
#include "spec/toml_value.hpp"

//! Files are described by constant tables with one line for each key. The line
//! states the member that stores the value, and the key's name, range, default
//! and meaning. Reading, canonical text, documentation and the JSON Schema are
//! generated from these tables.
namespace ideotype {

//! The address of an enumeration value that is written by name.
struct Choice {
    void* value;
    std::string (*get)(const void* value);
    void (*set)(void* value, const std::string& name);
};

//! The address of the value of a key, which also determines its type.
//! std::monostate: special code reads and writes the value.
using Target =
    std::variant<std::monostate, std::string*, std::uint64_t*, int*, long long*,
                 double*, std::optional<double>*, std::optional<int>*,
                 std::optional<std::string>*, bool*, Date*,
                 std::vector<glm::dvec2>*, std::vector<Date>*, Range*,
                 std::vector<double>*, std::vector<std::string>*,
                 std::vector<TomlValue>*, std::optional<Column>*, Choice>;

//! A value without an address, for which special code exists.
struct ByHand {};

//! Formats of values that the type does not determine.
enum class Form {
    plain,
    name,      //!< text that may be part of a file name
    path,      //!< path, relative to the file
    clock,     //!< local time, stored in hours
    duration,  //!< number of seconds, or text such as "1h30m"
    source,    //!< path of a file, or the file's content as a table
    rule,      //!< text, or a table of the same name
};

//! Kinds of names that other parts of a file define.
enum class Names { none, traits, rules, organs, objectives };

//! The count of a list of any length. A single value may replace the list.
inline constexpr std::size_t any_count = ~std::size_t{0};

//! A unit that users may use by mistake, expressed in the unit of the key.
struct MistakenUnit {
    const char* name = nullptr;
    double value = 0;
};

//! The values that a key accepts.
struct Values {
    double lower = 0, upper = 0;  //!< limits; unlimited if equal
    const char* unit = "";        //!< unit; "": none
    const char* type = nullptr;   //!< type in words; null: type of the member
    const char* range = nullptr;  //!< range in words
    Form form = Form::plain;
    std::size_t count = 0;               //!< length of a list; 0: any length
    std::array<const char*, 5> texts{};  //!< allowed texts; none: any text
    std::vector<std::string> (*known)() = nullptr;  //!< allowed texts
    Names names = Names::none;  //!< kind of names that are allowed
    bool is_by_leaf = false;    //!< whether a list has one value per leaf
    bool is_filled = false;     //!< whether a list must not be empty
    std::array<MistakenUnit, 2>
        mistaken{};  //!< units suspected if a number is above the range
};

//! The default of a key, as documents describe it.
struct Default {
    const char* words =
        nullptr;  //!< default in words; null: default of the record
    const char* example = "";  //!< example as TOML for messages
    bool is_required = false;
};

//! Values of an accuracy key that `fidelity` tries, the most accurate last.
using Trial = std::array<double, 5>;

//! Returns whether a condition holds for a record.
template <class Record, bool (*condition)(const Record&)>
bool holds(const void* record) {
    return condition(*static_cast<const Record*>(record));
}

//! The declaration of a key. Its value is stored in a member of a record, a
//! struct of any type.
struct Key {
    const char* name = "";
    Values values{};
    Default initial{};
    const char* meaning = "";
    //! Returns the address of the value in a record.
    Target (*place)(void* record) = nullptr;
    const void* record = nullptr;  //!< identifies the type of records
    //! Returns the names of an enumeration's values.
    std::vector<std::string> (*enumeration)() = nullptr;
    const char* unless = "";    //!< table that makes this key optional
    const char* excludes = "";  //!< key of the table that excludes this key
    //! Whether texts omit the key if it has its default.
    bool is_quiet = false;
    //! Returns whether texts contain the key; null: always.
    bool (*is_written)(const void* record) = nullptr;
    Trial trial{};
    bool (*has_trial)(const void* record) = nullptr;  //!< none: always
    //! Whether searches may vary the key, in a table of which they may not vary
    //! all keys.
    bool is_variable = false;

    constexpr Key with(auto Key::*member, auto value) const {
        Key key = *this;
        key.*member = value;
        return key;
    }
    constexpr Key or_by(const char* other) const {
        return with(&Key::unless, other);
    }
    constexpr Key excluding(const char* other) const {
        return with(&Key::excludes, other);
    }
    //! Lets searches and studies vary the key.
    constexpr Key variable() const { return with(&Key::is_variable, true); }
    //! Makes texts omit the key if it has its default.
    constexpr Key quiet() const { return with(&Key::is_quiet, true); }
    //! Writes the key only if a condition holds.
    template <class Record, bool (*condition)(const Record&)>
    constexpr Key written_if() const {
        return with(&Key::is_written, &holds<Record, condition>);
    }
    //! Marks an accuracy key, which trades speed for accuracy.
    constexpr Key trades(Trial values_to_try) const {
        return with(&Key::trial, values_to_try);
    }
    //! Marks an accuracy key, but only where a condition holds.
    template <class Record, bool (*condition)(const Record&)>
    constexpr Key trades(Trial values_to_try) const {
        return trades(values_to_try)
            .with(&Key::has_trial, &holds<Record, condition>);
    }
};

// Ranges: short names for use in tables.
constexpr Values any_value{};
constexpr Values within(double lower, double upper, const char* unit = "") {
    return {.lower = lower, .upper = upper, .unit = unit};
}
constexpr Values unlimited(const char* unit) {
    return {.unit = unit};
}
//! A length in metres, which users may give in centimetres or inches by
//! mistake.
constexpr Values metres(double lower, double upper) {
    return {.lower = lower,
            .upper = upper,
            .unit = "m",
            .mistaken = {MistakenUnit{"centimetres", 0.01}}};
}
constexpr Values metres_or_inches(double lower, double upper) {
    Values values = metres(lower, upper);
    values.mistaken[1] = {"inches", 0.0254};
    return values;
}
//! A list of numbers, or a single number.
constexpr Values number_or_list(double lower, double upper,
                                const char* unit = "") {
    return {.lower = lower,
            .upper = upper,
            .unit = unit,
            .type = "number or list",
            .count = any_count,
            .is_filled = true};
}
constexpr Values by_leaf(double lower, double upper, const char* unit = "") {
    Values values = number_or_list(lower, upper, unit);
    values.type = "number or list by leaf";
    values.is_by_leaf = true;
    values.is_filled = false;
    return values;
}
//! A list of numbers; a single number may replace a list with one item.
constexpr Values numbers(double lower, double upper, const char* unit = "",
                         const char* type = nullptr) {
    return {.lower = lower,
            .upper = upper,
            .unit = unit,
            .type = type,
            .count = any_count};
}
template <class... Text>
constexpr Values texts(Text... allowed) {
    return {.texts = {allowed...}};
}
constexpr Values words(const char* range) {
    return {.range = range};
}
constexpr Values from_file(Names names, const char* range) {
    return {.range = range, .names = names};
}
constexpr Values name_text{.range = "at most 64 letters, digits, _ and -",
                           .form = Form::name};
constexpr Values file_path{
    .type = "path", .range = "relative to this file", .form = Form::path};

// Defaults: short names for use in tables.
constexpr Default usual(const char* example = "") {
    return {nullptr, example};
}
constexpr Default required(const char* example) {
    return {nullptr, example, true};
}
constexpr Default by(const char* words, const char* example = "") {
    return {words, example};
}
constexpr Default none(const char* example = "") {
    return {"none", example};
}

//! The record type of a member.
template <class Member>
struct OwnerOf;
template <class Record, class Value>
struct OwnerOf<Value Record::*> {
    using type = Record;
};
template <class Record, class Value>
struct OwnerOf<Value Record::*const> {
    using type = Record;
};

namespace detail {

//! A variable for each record type; its address identifies the type.
template <class Record>
inline constexpr char mark = 0;

//! Returns the part of a record that a path of members and array indices leads
//! to.
template <auto First, auto... Rest>
auto& member(auto& record) {
    auto& part = [&]() -> auto& {
        if constexpr (std::is_member_pointer_v<decltype(First)>)
            return record.*First;
        else
            return record[First];
    }
    ();
    if constexpr (sizeof...(Rest) > 0)
        return member<Rest...>(part);
    else
        return part;
}

template <class Value>
struct Plain {
    using type = Value;
};
template <class Value>
struct Plain<std::optional<Value>> {
    using type = Value;
};

template <class Value>
inline constexpr bool is_enum = std::is_enum_v<typename Plain<Value>::type>;

//! Returns the address of a value as a Target.
template <class Value>
Target target(Value& value) {
    if constexpr (std::is_same_v<Value, ByHand>) {
        return std::monostate();
    } else if constexpr (is_enum<Value>) {
        using Enum = typename Plain<Value>::type;
        return Choice{&value,
                      [](const void* place) -> std::string {
                          const Value& now = *static_cast<const Value*>(place);
                          for (const auto& each : enum_names<Enum>)
                              if (now == each.value) return each.name;
                          return "";
                      },
                      [](void* place, const std::string& name) {
                          for (const auto& each : enum_names<Enum>)
                              if (name == each.name)
                                  *static_cast<Value*>(place) = each.value;
                      }};
    } else {
        return &value;
    }
}

//! Returns the name of a value type in messages and documents.
template <class Value>
constexpr const char* type_of() {
    using Inner = typename Plain<Value>::type;
    if constexpr (std::is_same_v<Inner, bool>) return "true or false";
    if constexpr (std::is_integral_v<Inner>) return "integer";
    if constexpr (std::is_floating_point_v<Inner>) return "number";
    if constexpr (std::is_same_v<Inner, Date>) return "local date";
    if constexpr (std::is_same_v<Inner, std::vector<Date>>)
        return "local date, or list of them";
    if constexpr (std::is_same_v<Inner, Range>) return "[lower, upper]";
    if constexpr (std::is_same_v<Inner, Column>) return "[column, unit]";
    if constexpr (std::is_same_v<Inner, std::vector<double>>)
        return "list of numbers";
    if constexpr (std::is_same_v<Inner, std::vector<std::string>>)
        return "list of texts";
    if constexpr (std::is_same_v<Inner, std::vector<TomlValue>>)
        return "list of values";
    if constexpr (std::is_same_v<Inner, std::vector<glm::dvec2>>)
        return "list of [out, up]";
    return "text";
}

template <class Enum>
std::vector<std::string> names_of_enum() {
    std::vector<std::string> names;
    for (const auto& each : enum_names<Enum>) names.emplace_back(each.name);
    return names;
}

}  // namespace detail

//! Declares a key.
//! @tparam Record type of the record
//! @tparam Path members and array indices that lead from the record to the
//! value
template <class Record, auto... Path>
constexpr Key key_of(const char* name, Values values, Default initial,
                     const char* meaning) {
    Key key{name, values, initial, meaning};
    key.record = &detail::mark<Record>;
    if constexpr (sizeof...(Path) == 0) {
        key.place = [](void*) -> Target { return std::monostate(); };
    } else {
        using Value = std::remove_cvref_t<decltype(detail::member<Path...>(
            std::declval<Record&>()))>;
        if (!key.values.type) key.values.type = detail::type_of<Value>();
        if constexpr (detail::is_enum<Value>)
            key.enumeration =
                &detail::names_of_enum<typename detail::Plain<Value>::type>;
        key.place = [](void* record) -> Target {
            return detail::target(
                detail::member<Path...>(*static_cast<Record*>(record)));
        };
    }
    return key;
}

//! Declares a key of the record type to which the first member belongs.
template <auto First, auto... Rest>
constexpr Key key(const char* name, Values values, Default initial,
                  const char* meaning) {
    using Owner = typename OwnerOf<decltype(First)>::type;
    return key_of<Owner, First, Rest...>(name, values, initial, meaning);
}

//! Declares a key with the record itself as value.
template <class Record>
constexpr Key itself(const char* name, Values values, Default initial,
                     const char* meaning) {
    Key key = key_of<Record>(name, values, initial, meaning);
    key.values.type = detail::type_of<Record>();
    key.place = [](void* record) {
        return detail::target(*static_cast<Record*>(record));
    };
    return key;
}

//! Names that other parts of a file define; if empty, any name is valid.
struct KnownNames {
    std::vector<std::string> traits, rules, organs, objectives;
    //! Whether trait sets may be empty, because components may be optimised
    //! instead.
    bool may_free_nothing = false;
    //! Whether unknown keys are ignored, as in histories that other versions
    //! wrote.
    bool passes_over_others = false;
};

struct Table;

//! The description of a table: its keys and the tables inside it.
struct Description {
    std::string_view section;  //!< name in documents and messages
    const Key* first = nullptr;
    std::size_t count = 0;
    const Table* first_table = nullptr;
    std::size_t table_count = 0;
    //! Returns a record in which all members have their defaults.
    const void* (*usual)() = nullptr;
    bool is_of_crop = false;  //!< whether crop files may contain the table
    //! The declaration shared by all other keys; a file chooses their names.
    //! Null: the table has no other keys.
    const Key* others = nullptr;
    //! Returns the address of the value of another key in a record.
    Target (*place_of_other)(void* record, const std::string& name) = nullptr;

    //! Declares other keys, with values stored in a map.
    template <auto map>
    constexpr Description with_others(const Key& key) const {
        Description description = *this;
        description.others = &key;
        description.place_of_other = [](void* record, const std::string& name) {
            using Owner = typename OwnerOf<decltype(map)>::type;
            return detail::target((static_cast<Owner*>(record)->*map)[name]);
        };
        return description;
    }

    std::span<const Key> keys() const { return {first, count}; }
    std::span<const Table> tables() const;
};

//! A table inside a table, with access to its records.
struct Table {
    const char* name = "";
    const Description* description = nullptr;
    //! Meaning of the table as a command-line option.
    const char* meaning = "";
    std::size_t (*size)(const void* parent) = nullptr;
    void* (*at)(void* parent, std::size_t entry) = nullptr;
    //! Changes the number of records. Null: there is always one record.
    void (*resize)(void* parent, std::size_t records) = nullptr;
    void (*clear)(void* parent) = nullptr;  //!< removes all records
    //! Returns the names that a record defines for its keys. Null: the names
    //! that the file defines.
    KnownNames (*names)(const void* record) = nullptr;
    bool keeps_records = false;  //!< whether reading keeps existing records
    bool is_list = false;        //!< whether the table is written as [[name]]
    bool is_optional = false;    //!< whether the table may be omitted
    std::size_t most = 1000;     //!< largest number of entries
    const char* unless = "";     //!< table that makes this table optional
    //! Whether searches may vary all keys of the table.
    bool is_variable = false;
    //! Whether no key of the table changes plants or their light.
    bool keeps_light = false;
    //! Returns the name of a record's table. Null: all records use the same
    //! name.
    const std::string& (*entry_name)(const void* record) = nullptr;
    bool (*is_entry_written)(const void* record) = nullptr;
    //! Returns whether texts contain the table; null: always.
    bool (*is_written)(const void* parent) = nullptr;
    //! Returns the text of a table that special code reads. Null: the text
    //! consists of the keys and tables.
    std::string (*text)(const void* parent, const std::string& name) = nullptr;

    constexpr Table with(auto Table::*member, auto value) const {
        Table table = *this;
        table.*member = value;
        return table;
    }
    constexpr Table at_most(std::size_t entries) const {
        return with(&Table::most, entries);
    }
    constexpr Table optional() const { return with(&Table::is_optional, true); }
    constexpr Table or_by(const char* other) const {
        return with(&Table::unless, other);
    }
    //! Lets searches and studies vary all keys of the table.
    constexpr Table variable() const { return with(&Table::is_variable, true); }
    //! Declares that no key of the table changes plants or their light, so that
    //! campaigns that differ in them can share it.
    constexpr Table keeping_light() const {
        return with(&Table::keeps_light, true);
    }
    template <class Parent, bool (*condition)(const Parent&)>
    constexpr Table written_if() const {
        return with(&Table::is_written, &holds<Parent, condition>);
    }
    //! Declares that the records exist before this table is read: reading
    //! updates them instead of adding new ones. Each record defines the names
    //! that its keys may use.
    template <class Record, auto function>
    constexpr Table completed_with() const {
        Table table = with(&Table::keeps_records, true);
        table.names = [](const void* record) {
            return function(*static_cast<const Record*>(record));
        };
        return table;
    }
    //! Makes each record a table with a name from the record. It is written if
    //! a condition holds. Records exist before their tables are read.
    template <auto member, auto condition>
    constexpr Table named_by() const {
        using Owner = typename OwnerOf<decltype(member)>::type;
        Table table = optional().with(&Table::is_list, false);
        table.is_entry_written = &holds<Owner, condition>;
        table.entry_name = [](const void* record) -> const std::string& {
            return static_cast<const Owner*>(record)->*member;
        };
        return table;
    }
    //! Writes the table with a function, which is passed a member of the
    //! parent.
    template <auto First, auto function>
    constexpr Table written_by() const {
        using Parent = typename OwnerOf<decltype(First)>::type;
        Table table = *this;
        table.text = [](const void* parent, const std::string& own_name) {
            return function(static_cast<const Parent*>(parent)->*First,
                            own_name);
        };
        return table;
    }
};

inline std::span<const Table> Description::tables() const {
    return {first_table, table_count};
}

//! The part of a record that a path leads to; without a path, the record
//! itself.
template <class Record, auto... Path>
struct Part {
    static auto& of(void* record) {
        if constexpr (sizeof...(Path) == 0)
            return *static_cast<Record*>(record);
        else
            return detail::member<Path...>(*static_cast<Record*>(record));
    }
    static void* at(void* record, std::size_t) { return &of(record); }
    static std::size_t size(const void*) { return 1; }
};

//! A part that is a list of records. Each of them is a table.
template <class Record, auto... Path>
struct ListPart : Part<Record, Path...> {
    using Part<Record, Path...>::of;
    static void* at(void* record, std::size_t i) { return &of(record).at(i); }
    static std::size_t size(const void* record) {
        return of(const_cast<void*>(record)).size();
    }
    static void clear(void* record) { of(record).clear(); }
    static void resize(void* record, std::size_t n) { of(record).resize(n); }
};

//! An optional part of a record.
template <class Record, auto... Path>
struct OptionalPart : Part<Record, Path...> {
    using Part<Record, Path...>::of;
    static void* at(void* record, std::size_t) { return &*of(record); }
    static std::size_t size(const void* record) {
        return of(const_cast<void*>(record)).has_value() ? 1 : 0;
    }
    static void resize(void* record, std::size_t n) {
        if (n == 0)
            of(record).reset();
        else if (!of(record))
            of(record).emplace();
    }
};

//! Declares a table. A record contains exactly one, at most one (std::optional)
//! or any number (std::vector) of them. Without a path, the keys of the table
//! are stored in the parent.
template <class Parent, auto... Path>
constexpr Table table_of(const char* name, const Description& description) {
    using One = Part<Parent, Path...>;
    using Value = std::remove_cvref_t<decltype(One::of(nullptr))>;
    Table table{name, &description};
    const auto place = [&]<class Places>(Places) {
        table.size = &Places::size;
        table.at = &Places::at;
    };
    if constexpr (requires(Value & all) { all.push_back({}); }) {
        using List = ListPart<Parent, Path...>;
        place(List());
        table.resize = &List::resize;
        table.clear = &List::clear;
        table.is_list = true;
    } else if constexpr (requires(Value & one) { one.has_value(); }) {
        using Optional = OptionalPart<Parent, Path...>;
        place(Optional());
        table.resize = &Optional::resize;
        table.is_optional = true;
    } else {
        place(One());
    }
    return table;
}

template <auto First, auto... Rest>
constexpr Table table(const char* name, const Description& description) {
    using Parent = typename OwnerOf<decltype(First)>::type;
    return table_of<Parent, First, Rest...>(name, description);
}

//! Describes a record type by its keys and the tables inside it.
template <class Record>
constexpr Description describe(std::string_view section, const auto& keys) {
    for (const Key& each : keys)
        if (each.record != &detail::mark<Record>)
            throw "a key of another type of records";
    Description description{section, std::data(keys), std::size(keys)};
    description.usual = []() -> const void* {
        static const Record record{};
        return &record;
    };
    return description;
}
template <class Record>
constexpr Description describe(std::string_view section, const auto& keys,
                               const auto& tables) {
    Description description = describe<Record>(section, keys);
    description.first_table = std::data(tables);
    description.table_count = std::size(tables);
    return description;
}

}  // namespace ideotype
