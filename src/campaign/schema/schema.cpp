// SPDX-License-Identifier: Apache-2.0
#include "schema.hpp"

#include <algorithm>

#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

//! Returns whether a documented type is the type of a value's place.
bool fits(const Target& place, const std::string& type) {
    // Beginnings of the names of types, in the order of Target's alternatives.
    static const std::vector<std::string> beginnings[] = {
        {""},
        {"text", "path"},
        {"integer"},
        {"integer"},
        {"integer"},
        {"number", "local time"},
        {"number"},
        {"true or false"},
        {"local date"},
        {"list of [out, up]"},
        {"local date, or list"},
        {"[lower, upper]"},
        {"list of numbers", "list of 6", "list of integers", "number or list"},
        {"list of texts", "text or list of texts"},
        {"[column, unit]"},
        {"text"}};
    static_assert(std::size(beginnings) == std::variant_size_v<Target>);
    return std::ranges::any_of(
        beginnings[place.index()],
        [&](const std::string& each) { return type.starts_with(each); });
}

}  // namespace

Key::Key(const std::string& key, Target place, const KeyInfo& declared)
    : name(key),
      value(std::move(place)),
      type(declared.type),
      unit(declared.unit == "-" ? "" : declared.unit),
      lower(declared.lower),
      upper(declared.upper),
      choices(declared.texts),
      example(declared.example),
      is_required(declared.is_required()),
      is_any_text(type == "path" || declared.range == "any text") {
    IDEOTYPE_EXPECT(fits(value, type));
    if (const Choice* enumeration = std::get_if<Choice>(&value)) {
        IDEOTYPE_EXPECT(choices.empty() || choices == enumeration->names);
        choices = enumeration->names;
    }
    if (lower == upper && choices.empty() && declared.range != "-")
        range = declared.range;
    if (type.find(" or list") != type.npos) count = any_count;
}

Key& Key::optional_list() {
    count = any_count;
    return written_if(!std::get<std::vector<double>*>(value)->empty());
}

Key& Key::trades(const std::vector<double>& values, bool is_so) {
    if (is_so) accuracy = values;
    return *this;
}

Section::Section(std::string table,
                 const std::vector<std::pair<std::string, Target>>& places,
                 const std::string& like)
    : name(std::move(table)) {
    const std::string& declared = like.empty() ? name : like;
    for (const auto& [key, place] : places)
        keys.emplace_back(key, place, key_info(declared, key));
}

Key& Section::operator[](const std::string& key) {
    const auto found = std::ranges::find(keys, key, &Key::name);
    IDEOTYPE_EXPECT(found != keys.end());
    return *found;
}

Table& Table::with(Table child, const std::string& child_name) {
    child.name = child_name;
    children.push_back(std::move(child));
    return *this;
}

Table one_table(const Section& section) {
    return {section.name, [section](std::size_t) { return section; },
            [] { return std::size_t{1}; }, nullptr};
}

}  // namespace ideotype
