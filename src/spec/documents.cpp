// SPDX-License-Identifier: Apache-2.0
#include "documents.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"
#include "spec/writer.hpp"

namespace ideotype {

namespace {

//! Describes the limits, the allowed texts or the range of a key.
std::string range_of(const Key& key) {
    Key without_unit = key;
    without_unit.values.unit = "";
    return range_text(without_unit);
}

std::string row_of(const Key& key, const void* usual) {
    const std::string example = key.initial.example;
    return fmt::format(
        "| `{}` | {} | {} | {} | {}{} | {} |\n", key.name, key.values.type,
        *key.values.unit ? key.values.unit : "-", range_of(key),
        default_text(key, usual), example.empty() ? "" : ", such as " + example,
        key.meaning);
}

}  // namespace

std::string markdown_of(const Documented& table) {
    std::string text =
        "| key | type | unit | range | default | meaning |\n"
        "|---|---|---|---|---|---|\n";
    for (const Key& key : table.description->keys())
        text += row_of(key, table.description->usual());
    return text;
}

std::string with_key_tables(const std::string& text) {
    const std::string begin = "<!-- keys: ", end = "<!-- end of keys -->";
    std::string result;
    std::size_t done = 0, tables = 0;
    const std::vector<Documented>& documented = documented_tables();
    for (std::size_t at; (at = text.find(begin, done)) != text.npos;) {
        const std::size_t name = at + begin.size();
        const std::size_t line = text.find('\n', name);
        const std::string section =
            text.substr(name, text.find(" -->", name) - name);
        const auto table =
            std::ranges::find(documented, section, &Documented::section);
        const std::size_t last = text.find(end, name);
        if (table == documented.end() || last == text.npos)
            throw Error("there are no keys of \"" + section +
                        "\", or no end of their table");
        result += text.substr(done, line + 1 - done) + '\n' +
                  markdown_of(*table) + '\n';
        done = last;
        ++tables;
    }
    if (tables < documented.size())
        throw Error(fmt::format("{} of {} tables of keys have marks", tables,
                                documented.size()));
    return result + text.substr(done);
}

}  // namespace ideotype
