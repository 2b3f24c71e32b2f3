// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ideotype/core/text.hpp"
#include "spec/mesh_spec.hpp"
#include "spec/table_reader.hpp"

namespace ideotype {

namespace {

template <class... Value>
bool is_any_of(const Target& target) {
    return (std::holds_alternative<Value>(target) || ...);
}

std::optional<std::int64_t> whole_number_of(const std::string& text) {
    std::int64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc{} || rest != end) return std::nullopt;
    return number;
}

std::optional<toml::date> date_of(const std::string& text) {
    const std::optional<Date> date = to_date(text);
    if (!date) return std::nullopt;
    return toml::date(date->year, date->month, date->day);
}

//! Converts given values to TOML, so that they are read like values from a
//! file.
class GivenTable {
  public:
    GivenTable(const GivenKeys& given, const Problems& problems)
        : given_(given), problems_(problems) {
        for (const Key& key : mesh_table.keys()) add(key);
        for (const Table& table : mesh_table.tables()) add(table);
    }

    const toml::table& toml() const { return toml_; }

  private:
    std::string name(const char* key) const { return *problems_.name_of(key); }

    void add(const Key& key) {
        const auto values = given_.find(key.name);
        if (values == given_.end()) return;
        if (values->second.size() != 1)
            problems_.add(key.name, ProblemCode::wrong_type,
                          "{} takes one value", name(key.name));
        else
            put({key, key.place(&types_)}, values->second.front(), problems_,
                toml_);
    }

    void add(const Table& table) {
        const auto given = given_.find(table.name);
        if (given == given_.end()) return;
        table.resize(&types_, 1);
        const Section section{table.name, table.description->keys(),
                              table.at(&types_, 0)};
        toml::table values;
        const std::size_t count = section.keys.size();
        for (std::size_t i = 0; i < std::min(count, given->second.size()); ++i)
            put(section[i], given->second[i], problems_.in(table.name), values);
        if (given->second.size() != count) {
            std::vector<std::string> names;
            for (const Key& key : section.keys) names.emplace_back(key.name);
            problems_.add(table.name, ProblemCode::wrong_type,
                          "{} takes {} values: {}", name(table.name), count,
                          fmt::join(names, ", "));
        }
        toml_.insert_or_assign(table.name, std::move(values));
    }

    //! Inserts a value into a table. A text is first converted to the type of
    //! the key.
    static void put(const BoundKey& key, const GivenValue& value,
                    const Problems& problems, toml::table& table) {
        const char* const name = key.key.name;
        const auto insert = [&](const auto& one) {
            table.insert_or_assign(name, one);
        };
        const auto insert_if = [&](const auto& parsed, const char* expected) {
            if (parsed) return insert(*parsed);
            problems.add(name, ProblemCode::wrong_type, "{} is {} (not a {}",
                         *problems.name_of(name), std::get<std::string>(value),
                         expected);
        };
        const auto* const text = std::get_if<std::string>(&value);
        if (!text)
            std::visit(insert, value);
        else if (is_any_of<double*, std::optional<double>*>(key.value))
            insert_if(parse_number(*text), "number); correct it");
        else if (is_any_of<int*, long long*, std::uint64_t*>(key.value))
            insert_if(whole_number_of(*text), "whole number); correct it");
        else if (is_any_of<Date*>(key.value))
            insert_if(date_of(*text), "date); write it as YYYY-MM-DD");
        else
            insert(*text);
    }

    const GivenKeys& given_;
    const Problems& problems_;
    MeshSpec types_;  //!< record that determines the types of values
    toml::table toml_;
};

}  // namespace

MeshSpec read_mesh_spec(const GivenKeys& given, KeyNaming naming) {
    const Problems problems(naming);
    const GivenTable table(given, problems);
    problems.throw_wrong_usage();
    MeshSpec spec;
    TableReader("", problems, nothing_known)
        .read(table.toml(), mesh_table, &spec);
    problems.throw_wrong_usage();
    return spec;
}

}  // namespace ideotype
