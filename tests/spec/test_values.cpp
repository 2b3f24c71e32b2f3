// SPDX-License-Identifier: Apache-2.0
// Documents and schema are generated from the tables of keys, so that they
// cannot reveal a wrong default or range. These tests state defaults and ranges
// a second time.
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "spec/mesh_spec.hpp"
#include "spec/tables.hpp"
#include "spec/writer.hpp"

namespace ideotype {

namespace {

struct Declared {
    std::string section;
    const Key* key = nullptr;
    const void* usual = nullptr;

    std::string name() const { return section + '.' + key->name; }
    bool has_limits() const { return key->values.lower < key->values.upper; }
};

void append(std::vector<Declared>& declared, const std::string& section,
            const Description& description) {
    for (const Key& key : description.keys())
        declared.push_back({section, &key, description.usual()});
}

//! Returns all keys of campaigns, crop files, and the scene files of `light`.
std::vector<Declared> declared_keys() {
    std::vector<Declared> declared;
    for (const Documented& table : documented_tables())
        append(declared, table.section, *table.description);
    for (const Description* table : {&mesh_table, &mesh_scene_table}) {
        const std::string top = table == &mesh_table ? "light mesh" : "scene";
        append(declared, top, *table);
        for (const Table& part : table->tables())
            append(declared, top + ' ' + part.name, *part.description);
    }
    return declared;
}

//! Returns a range and a default in the form of the record; quantities have the
//! names that the library declares.
std::string stated(const Declared& declared) {
    return fmt::format(
        "{} | {}",
        declared.key->values.known ? "quantities" : range_text(*declared.key),
        default_text(*declared.key, declared.usual));
}

//! Returns the numbers in a default, as printed in the record of all defaults.
std::vector<double> default_numbers(const Declared& declared) {
    if (!declared.usual || declared.key->initial.is_required) return {};
    // The address of a value is not const, but nothing is written to it.
    const Target place = declared.key->place(const_cast<void*>(declared.usual));
    std::vector<double> values;
    std::visit(
        [&](const auto& value) {
            using Value = std::remove_cvref_t<decltype(value)>;
            if constexpr (std::is_same_v<Value, Range*>)
                values = {value->lower, value->upper};
            else if constexpr (std::is_same_v<Value, std::vector<double>*>)
                values = *value;
            else if constexpr (std::is_same_v<Value, std::optional<double>*> ||
                               std::is_same_v<Value, std::optional<int>*>) {
                if (*value) values = {static_cast<double>(**value)};
            } else if constexpr (std::is_same_v<Value, double*> ||
                                 std::is_same_v<Value, int*> ||
                                 std::is_same_v<Value, long long*>)
                values = {static_cast<double>(*value)};
        },
        place);
    return values;
}

//! Physical limits of the values of a unit, or limits that follow from the
//! definition of a quantity, by the end of its name.
struct Natural {
    const char* end;  //!< end of the name of a key, or its unit after a space
    double lower, upper;
    bool is_whole;  //!< whether every value between the limits must be allowed
};
constexpr Natural natural[] = {
    // Fractions of the light that hits a surface.
    {"reflectance", 0, 1, true},
    {"transmittance", 0, 1, true},
    {"albedo", 0, 1, true},
    // Positions on Earth, from the Dead Sea (-430 m) to Mount Everest (8849 m),
    // and the clocks of all time zones (UTC-12 to UTC+14).
    {".latitude", -90, 90, true},
    {".longitude", -180, 180, true},
    {".utc_offset", -12, 14, true},
    {".elevation", -1000, 10000, false},
    // One full turn, and two turns for the twist of a blade.
    {".row_direction", 0, 360, true},
    {".twist", -720, 720, false},
    {" deg", -720, 720, false},
    // Plants are less than 10 m high and less than a kilometre apart.
    {"leaf.length", 0, 10, false},
    {"leaf.width", 0, 1, false},
    {"height", 0, 1000, false},
    {" m", -100000, 100000, false},
    // No growth occurs below freezing or above 60 deg C (temperatures of
    // stages).
    {".base", -20, 60, false},
    {".cap", -20, 60, false},
    // Quantum yields are at most 1/8, the value for C3 leaves without losses
    // (two photosystems, four electrons); curvatures of responses are 0 to 1.
    {".phi", 0, 0.2, false},
    {".alpha", 0, 0.2, false},
    {".theta", 0, 1, true},
    {".beta", 0, 1, true},
    // From the lowest useful CO2 concentration to that in a closed chamber with
    // tenfold air.
    {".co2", 0, 10000, false},
    // A gram of tissue requires at least a gram of glucose.
    {".construction", 1, 10, false},
    {"correlations", -1, 1, true},
    // A year has at most 366 days, a day 1440 min.
    {"light.dates", 1, 366, true},
    {".step_minutes", 1, 1440, false},
};

}  // namespace

TEST(KeyValues, MatchTheRecordedRangesAndDefaults) {
    std::map<std::string, std::string> record;
    std::ifstream file(IDEOTYPE_TEST_DATA "/keys.txt");
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        const std::size_t end = line.find(" | ");
        ASSERT_NE(end, line.npos) << line;
        EXPECT_TRUE(
            record.emplace(line.substr(0, end), line.substr(end + 3)).second)
            << "twice: " << line;
    }
    for (const Declared& declared : declared_keys()) {
        const auto entry = record.extract(declared.name());
        EXPECT_EQ(stated(declared), entry.empty() ? "no line" : entry.mapped())
            << declared.name()
            << ": the table of src/spec/tables and the line of "
            << "tests/data/keys.txt differ. Look up the source of the value, "
               "and correct by hand the one that is wrong; the line is\n"
            << declared.name() << " | " << stated(declared);
    }
    for (const auto& [name, values] : record)
        ADD_FAILURE() << name << " in tests/data/keys.txt is no key";
}

TEST(KeyValues, DefaultsLieInTheirRanges) {
    std::size_t numbers = 0;
    const auto expect_in_range = [&](const Declared& declared, double value) {
        EXPECT_GE(value, declared.key->values.lower) << declared.name();
        EXPECT_LE(value, declared.key->values.upper) << declared.name();
        ++numbers;
    };
    for (const Declared& declared : declared_keys()) {
        if (!declared.has_limits()) continue;
        const std::vector<double> usual = default_numbers(declared);
        const auto& [words, example, is_required] = declared.key->initial;
        // In the record, defaults that follow from other keys are marked.
        if (!words)
            for (const double value : usual) expect_in_range(declared, value);
        for (const char* text : {words, example}) {
            if (!text) continue;
            char* end = nullptr;
            const double value = std::strtod(text, &end);
            // Clock times, and shares of other keys, are not in the unit of the
            // key.
            if (end == text || *end == ':' ||
                std::string_view(end).starts_with(" amax"))
                continue;
            expect_in_range(declared, value);
            if (text == words && *end == '\0' && usual.size() == 1) {
                EXPECT_EQ(value, usual[0]) << declared.name();
            }
        }
    }
    EXPECT_GT(numbers, 150u);
}

TEST(KeyValues, HavePhysicalLimits) {
    std::set<std::string_view> used;
    for (const Declared& declared : declared_keys()) {
        if (!declared.has_limits()) continue;
        const std::string name = declared.name();
        const std::string unit = fmt::format(" {}", declared.key->values.unit);
        for (const Natural& limit : natural) {
            const bool is_unit = *limit.end == ' ';
            if (is_unit ? unit != limit.end : !name.ends_with(limit.end))
                continue;
            used.insert(limit.end);
            EXPECT_GE(declared.key->values.lower, limit.lower) << name;
            EXPECT_LE(declared.key->values.upper, limit.upper) << name;
            if (!limit.is_whole) continue;
            EXPECT_EQ(declared.key->values.lower, limit.lower) << name;
            EXPECT_EQ(declared.key->values.upper, limit.upper) << name;
        }
    }
    for (const Natural& limit : natural)
        EXPECT_TRUE(used.contains(limit.end)) << limit.end << " is no key";
}

//! Each of the listed keys has the same range in all tables in which it occurs
//! with the same unit, except in the tables of `light mesh`.
TEST(KeyValues, OfTheSameKeyAreTheSameInAllTables) {
    std::map<std::string, Declared> first;
    for (const Declared& declared : declared_keys()) {
        const std::string name = declared.key->name;
        static const std::set<std::string> shared{
            "utc_offset",  "paths",        "randomisations", "density",
            "maintenance", "construction", "capacity",       "soil_albedo"};
        if (!shared.contains(name) || !declared.has_limits() ||
            declared.section.starts_with("light mesh"))
            continue;
        const auto [found, is_new] =
            first.emplace(name + ' ' + declared.key->values.unit, declared);
        if (is_new) continue;
        EXPECT_EQ(declared.key->values.lower, found->second.key->values.lower)
            << declared.name();
        EXPECT_EQ(declared.key->values.upper, found->second.key->values.upper)
            << declared.name();
    }
    EXPECT_GT(first.size(), 5u);
}

}  // namespace ideotype
