// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "commands.hpp"
#include "spec/tables.hpp"
#include "spec/writer.hpp"

namespace ideotype {

namespace {

//! Converts the name of a value to its placeholder in a help text.
std::string upper_case(std::string text) {
    for (char& c : text)
        c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

//! Declares an option that takes one value for each name.
CLI::Option* add_given(CLI::App& command, const std::string& key,
                       const std::vector<std::string>& names,
                       const std::string& meaning, GivenKeys& given) {
    return command
        .add_option_function<std::vector<std::string>>(
            option_of_key(key),
            [&given, key](const std::vector<std::string>& words) {
                given[key].assign(words.begin(), words.end());
            },
            meaning)
        ->type_name(upper_case(fmt::format("{}", fmt::join(names, " "))))
        ->type_size(static_cast<int>(names.size()))
        ->expected(1)
        ->allow_extra_args(false);
}

//! Returns the meaning of a key and its allowed values.
std::string about(const Key& key) {
    const std::string range = range_text(key);
    return range == "-" ? key.meaning
                        : fmt::format("{} ({})", key.meaning, range);
}

}  // namespace

std::string option_of_key(const std::string& key) {
    std::string option = "--" + key;
    std::ranges::replace(option, '_', '-');
    return option;
}

void declare_mesh_keys(CLI::App& command, GivenKeys& given) {
    MeshSpec types;
    for (const Table& table : mesh_table.tables()) {
        std::vector<std::string> names, meanings;
        for (const Key& key : table.description->keys()) {
            names.emplace_back(key.name);
            meanings.push_back(about(key));
        }
        add_given(
            command, table.name, names,
            fmt::format("{}: {}", table.meaning, fmt::join(meanings, ", ")),
            given);
    }
    for (const Key& key : mesh_table.keys()) {
        if (std::holds_alternative<bool*>(key.place(&types))) {
            command.add_flag_callback(
                option_of_key(key.name),
                [&given, name = key.name] { given[name] = {true}; },
                key.meaning);
            continue;
        }
        CLI::Option* const option =
            add_given(command, key.name, {key.values.type}, about(key), given);
        if (!key.initial.words)
            option->default_str(default_text(key, mesh_table.usual()));
    }
}

}  // namespace ideotype
