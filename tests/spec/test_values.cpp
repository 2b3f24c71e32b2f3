// SPDX-License-Identifier: Apache-2.0
// Documents and schema follow from the tables of keys and are written by a
// command, so that they cannot show that a default or a range is wrong. These
// tests state both a second time.
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

void append(std::vector<Declared>& all, const std::string& section,
            const Description& description) {
    for (const Key& key : description.keys())
        all.push_back({section, &key, description.usual()});
}

//! Returns all keys of campaigns, crop files, and `light` with its scenes.
std::vector<Declared> declared_keys() {
    std::vector<Declared> all;
    for (const Documented& table : documented_tables())
        append(all, table.section, *table.description);
    for (const Description* table : {&mesh_table, &mesh_scene_table}) {
        const std::string top = table == &mesh_table ? "light mesh" : "scene";
        append(all, top, *table);
        for (const Table& part : table->tables())
            append(all, top + ' ' + part.name, *part.description);
    }
    return all;
}

//! Returns a range and a default as the record has them; names of quantities
//! are those that the library declares.
std::string stated(const Declared& each) {
    return fmt::format(
        "{} | {}",
        each.key->values.known ? "quantities" : range_text(*each.key),
        default_text(*each.key, each.usual));
}

//! Returns the numbers of the default that a record of all defaults has.
std::vector<double> default_numbers(const Declared& each) {
    if (!each.usual || each.key->initial.is_required) return {};
    // Places are not constant, but nothing is written there.
    const Target place = each.key->place(const_cast<void*>(each.usual));
    std::vector<double> all;
    std::visit(
        [&](const auto& value) {
            using Value = std::remove_cvref_t<decltype(value)>;
            if constexpr (std::is_same_v<Value, Range*>)
                all = {value->lower, value->upper};
            else if constexpr (std::is_same_v<Value, std::vector<double>*>)
                all = *value;
            else if constexpr (std::is_same_v<Value, std::optional<double>*> ||
                               std::is_same_v<Value, std::optional<int>*>) {
                if (*value) all = {static_cast<double>(**value)};
            } else if constexpr (std::is_same_v<Value, double*> ||
                                 std::is_same_v<Value, int*> ||
                                 std::is_same_v<Value, long long*>)
                all = {static_cast<double>(*value)};
        },
        place);
    return all;
}

//! Limits that values of a unit, or of a quantity by the end of its name, have
//! in nature or by the definition of the quantity.
struct Natural {
    const char* end;  //!< end of the name of a key, or its unit after a space
    double lower, upper;
    bool is_whole;  //!< whether every value between the limits must be allowed
};
constexpr Natural natural[] = {
    // Shares of the light that comes to a surface.
    {"reflectance", 0, 1, true},
    {"transmittance", 0, 1, true},
    {"albedo", 0, 1, true},
    // Places on Earth, from the Dead Sea (-430 m) to Mount Everest (8849 m),
    // and the clocks of all time zones (UTC-12 to UTC+14).
    {".latitude", -90, 90, true},
    {".longitude", -180, 180, true},
    {".utc_offset", -12, 14, true},
    {".elevation", -1000, 10000, false},
    // Full turns, and two turns of a twisted blade.
    {".row_direction", 0, 360, true},
    {".twist", -720, 720, false},
    {" deg", -720, 720, false},
    // Plants are lower than 10 m and stand less than a kilometre apart.
    {"leaf.length", 0, 10, false},
    {"leaf.width", 0, 1, false},
    {"height", 0, 1000, false},
    {" m", -100000, 100000, false},
    // Biology ends below freezing and at 60 deg C (temperatures of stages).
    {".base", -20, 60, false},
    {".cap", -20, 60, false},
    // Quantum yields are below 1/8, that of C3 leaves without losses (two
    // photosystems, four electrons), and curvatures of responses 0 to 1.
    {".phi", 0, 0.2, false},
    {".alpha", 0, 0.2, false},
    {".theta", 0, 1, true},
    {".beta", 0, 1, true},
    // From the least CO2 of any use to a closed chamber with tenfold air.
    {".co2", 0, 10000, false},
    // Building a gram of tissue takes at least a gram of glucose.
    {".construction", 1, 10, false},
    {"correlations", -1, 1, true},
    // A year has 366 days, a day 1440 min.
    {"light.dates", 1, 366, true},
    {".step_minutes", 1, 1440, false},
};

}  // namespace

TEST(KeyValues, AreThoseOfTheRecordThatNoCommandWrites) {
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
    for (const Declared& each : declared_keys()) {
        const auto found = record.extract(each.name());
        EXPECT_EQ(stated(each), found.empty() ? "no line" : found.mapped())
            << each.name() << ": the table of src/spec/tables and the line of "
            << "tests/data/keys.txt differ. Look up the source of the value, "
               "and correct by hand the one that is wrong; the line is\n"
            << each.name() << " | " << stated(each);
    }
    for (const auto& [name, values] : record)
        ADD_FAILURE() << name << " in tests/data/keys.txt is no key";
}

TEST(KeyValues, OfDefaultsLieInTheirRanges) {
    std::size_t numbers = 0;
    const auto expect_in_range = [&](const Declared& each, double value) {
        EXPECT_GE(value, each.key->values.lower) << each.name();
        EXPECT_LE(value, each.key->values.upper) << each.name();
        ++numbers;
    };
    for (const Declared& each : declared_keys()) {
        if (!each.has_limits()) continue;
        const std::vector<double> usual = default_numbers(each);
        const auto& [words, example, is_required] = each.key->initial;
        // The record has a mark where words say what follows from other keys.
        if (!words)
            for (const double value : usual) expect_in_range(each, value);
        for (const char* text : {words, example}) {
            if (!text) continue;
            char* end = nullptr;
            const double value = std::strtod(text, &end);
            // Clock times and shares of other keys are in no unit of the key.
            if (end == text || *end == ':' ||
                std::string_view(end).starts_with(" amax"))
                continue;
            expect_in_range(each, value);
            if (text == words && *end == '\0' && usual.size() == 1) {
                EXPECT_EQ(value, usual[0]) << each.name();
            }
        }
    }
    EXPECT_GT(numbers, 150u);
}

TEST(KeyValues, HaveLimitsThatTheirQuantitiesHaveInNature) {
    std::set<std::string_view> used;
    for (const Declared& each : declared_keys()) {
        if (!each.has_limits()) continue;
        const std::string name = each.name();
        const std::string unit = fmt::format(" {}", each.key->values.unit);
        for (const Natural& limit : natural) {
            const bool is_unit = *limit.end == ' ';
            if (is_unit ? unit != limit.end : !name.ends_with(limit.end))
                continue;
            used.insert(limit.end);
            EXPECT_GE(each.key->values.lower, limit.lower) << name;
            EXPECT_LE(each.key->values.upper, limit.upper) << name;
            if (!limit.is_whole) continue;
            EXPECT_EQ(each.key->values.lower, limit.lower) << name;
            EXPECT_EQ(each.key->values.upper, limit.upper) << name;
        }
    }
    for (const Natural& limit : natural)
        EXPECT_TRUE(used.contains(limit.end)) << limit.end << " is no key";
}

//! Keys of the same name and unit mean the same in each table, but for those of
//! plants of another kind, which may be left out, and for measures of organs.
TEST(KeyValues, OfTheSameKeyAreTheSameInAllTables) {
    std::map<std::string, Declared> first;
    for (const Declared& each : declared_keys()) {
        const std::string name = each.key->name;
        static const std::set<std::string> shared{
            "utc_offset",  "paths",        "randomisations", "density",
            "maintenance", "construction", "capacity",       "soil_albedo"};
        if (!shared.contains(name) || !each.has_limits() ||
            each.section.starts_with("light mesh"))
            continue;
        const auto [found, is_new] =
            first.emplace(name + ' ' + each.key->values.unit, each);
        if (is_new) continue;
        EXPECT_EQ(each.key->values.lower, found->second.key->values.lower)
            << each.name();
        EXPECT_EQ(each.key->values.upper, found->second.key->values.upper)
            << each.name();
    }
    EXPECT_GT(first.size(), 5u);
}

}  // namespace ideotype
