// SPDX-License-Identifier: Apache-2.0
#include "ideotype/campaign/migration.hpp"

#include <algorithm>
#include <set>

#include "ideotype/core/file.hpp"
#include "measured_plant.hpp"
#include "old_names.hpp"
#include "reader.hpp"
#include "report.hpp"
#include "syntax.hpp"

namespace ideotype {

namespace {

//! The byte at a place whose column counts characters.
std::size_t offset(const std::string& text, const Location& where) {
    // A byte order mark has no column.
    std::size_t at =
        where.line == 1 && text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    for (int line = 1; line < where.line; ++line) at = text.find('\n', at) + 1;
    const auto continues = [&](std::size_t byte) {
        return byte < text.size() &&
               (static_cast<unsigned char>(text[byte]) & 0xC0) == 0x80;
    };
    for (int column = 1; column < where.column; ++column) do
            ++at;
        while (continues(at));
    return at;
}

//! The new name after the entry that goes with it, on a line of its own if the
//! old name begins one.
std::string with_company(const std::string& text, std::size_t at,
                         const OldName& name) {
    if (name.also.empty()) return name.is;
    const std::size_t line = text.rfind('\n', at) + 1;
    const std::string before = text.substr(line, at - line);
    const bool is_first = before.find_first_not_of(" \t") == before.npos;
    return name.also + (is_first ? "\n" + before : ", ") + name.is;
}

//! Whether the old name stands there as it is, perhaps quoted, and has been
//! replaced.
bool replace(std::string& text, const OldName& name) {
    const std::size_t at = text.find_first_not_of(
        "\"'", std::min(offset(text, name.where), text.size()));
    const std::size_t end = text.find_first_not_of(
        "abcdefghijklmnopqrstuvwxyz_", std::min(at, text.size()));
    if (at == std::string::npos || text.substr(at, end - at) != name.was)
        return false;
    if (!name.value.empty()) {
        const std::size_t value = text.find_first_of("tf", end);
        text.replace(value, text[value] == 't' ? 4 : 5, name.value);
    }
    text.replace(at, name.was.size(), with_company(text, at, name));
    return true;
}

}  // namespace

Migration migrated(const std::string& text, const std::string& file) {
    Migration result{file, text, {}, ""};
    std::set<std::string> ambiguous;
    // Dotted keys may have an old name in several lines, of which each pass
    // sees one.
    for (bool is_first = true, is_changed = true; is_changed;
         is_first = false) {
        Report report;
        std::optional<toml::table> table =
            parse_toml(result.text, file, report);
        report.throw_if_any();
        result.plant_file = plant_path(*table, file);
        std::vector<OldName> names = rename_entries(*table, file);
        is_changed = false;
        // From the end, so that places stay as they are.
        std::reverse(names.begin(), names.end());
        for (const OldName& name : names) {
            if (is_first && name.is_both) ambiguous.insert(name.what);
            if (ambiguous.count(name.what) != 0 || !replace(result.text, name))
                continue;
            result.changes.push_back(name);
            is_changed = true;
        }
    }
    std::sort(result.changes.begin(), result.changes.end(), is_before);
    return result;
}

std::vector<Migration> read_migrations(const std::string& path) {
    const std::string text = read_text(path);
    std::vector<Migration> result{migrated(text, path)};
    const std::string plant = result[0].plant_file;
    // A table has no old names; who checks the campaign tells what cannot be
    // read.
    if (is_measured(plant)) return result;
    const FileText read = read_file(plant, most_input_bytes);
    if (read.is_there) result.push_back(migrated(read.text, plant));
    return result;
}

}  // namespace ideotype
