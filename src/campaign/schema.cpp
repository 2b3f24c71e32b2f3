// SPDX-License-Identifier: Apache-2.0
#include "schema.hpp"

namespace ideotype {

Key& Key::required(const std::string& shown) {
    is_required = true;
    return like(shown);
}

Key& Key::like(const std::string& shown) {
    example = shown;
    return *this;
}

Key& Key::defaults(const std::string& words) {
    initial = words;
    return *this;
}

Key& Key::allows(const std::string& words) {
    range = words;
    return *this;
}

Key& Key::of_type(const std::string& words) {
    type = words;
    return *this;
}

Key& Key::in_metres(const std::vector<MistakenUnit>& others) {
    bounds.unit = "m";
    mistaken = others;
    return *this;
}

Key& Key::one_of(const std::vector<std::string>& texts) {
    choices = texts;
    return *this;
}

Key& Key::or_list(const std::string& words) {
    count = any_count;
    return of_type(words);
}

Key& Key::optional_list(const std::string& words, const std::string& default_is,
                        const std::string& shown) {
    return or_list(words)
        .defaults(default_is)
        .like(shown)
        .written_if(!std::get<std::vector<double>*>(value)->empty());
}

Key& Key::written_if(bool is_so) {
    is_written = is_so;
    return *this;
}

Key& Key::trades(const std::vector<double>& values, bool is_so) {
    if (is_so) accuracy = values;
    return *this;
}

Key& Section::add_by_hand(const std::string& key, const std::string& words,
                          const std::string& meaning) {
    return keys.emplace_back(Key{key, {}, {}, meaning})
        .of_type(words)
        .allows("-");
}

Key& Section::add_rule(std::string& rule, const std::vector<std::string>& rules,
                       const std::string& meaning) {
    const Target place = rule.empty() ? Target{} : &rule;
    return keys.emplace_back(Key{"bounds", place, {}, meaning})
        .of_type("text or table")
        .defaults("\"traits\"")
        .one_of(rules);
}

Key& Section::add_name(const std::string& key, std::string& value,
                       const std::string& meaning) {
    return add(key, value, meaning).allows(name_range);
}

Key& Section::add_path(const std::string& key, std::string& value,
                       const std::string& example, const std::string& meaning) {
    Key& path = add(key, value, meaning)
                    .of_type("path")
                    .like(example)
                    .allows("relative to this file")
                    .defaults("none");
    path.is_any_text = true;
    return path;
}

Table& Table::optional() {
    is_optional = true;
    return *this;
}

Table& Table::left_out_if(bool is_so) {
    is_default = is_so;
    return *this;
}

Table& Table::at_most(std::size_t entries) {
    most = entries;
    return *this;
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

Section top_section(Campaign& campaign) {
    Section keys{"top"};
    keys.add_name("name", campaign.name, "names the folder of the histories")
        .required("\"ames\"");
    keys.add("seed", campaign.seed, "of all random numbers")
        .allows("0 .. 2^63-1");
    keys.add("replicates", campaign.replicates, {1, 1000},
             "evolutions with seeds of their own, per combination of the axes");
    return keys;
}

}  // namespace ideotype
