// SPDX-License-Identifier: Apache-2.0
#include "spec/crop_reader.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "spec/files.hpp"
#include "spec/nodes.hpp"
#include "spec/table_reader.hpp"
#include "spec/tables.hpp"

namespace ideotype {

bool is_table_of_leaves(const std::string& file, const std::string& named_by,
                        const Location& named_at, const Problems& problems) {
    if (std::filesystem::path(file).extension() != ".csv") return false;
    problems.add({named_at, named_by, ProblemCode::file,
                  fmt::format("{} is a table (but a plant is given as a crop "
                              "file); make a crop file of it: ideotype fit {}",
                              file, file)});
    return true;
}

void CropReader::read_key(const toml::node& baseline, const std::string& key) {
    if (const toml::table* table = baseline.as_table())
        return read(*table, file_);
    const bool is_path = baseline.is_string();
    if (!is_path || source_ != TextSource::file)
        return problems_.add(
            {location(baseline.source(), file_), key, ProblemCode::wrong_type,
             fmt::format(
                 "{} is {} (expected: {}); write {}", key, kind(baseline),
                 is_path ? "the plant itself" : "path or table",
                 is_path ? fmt::format("it as [{}]", key)
                         : fmt::format("for example {} = \"crops/mine.toml\"",
                                       key.substr(key.find('.') + 1)))});
    read_file(path_from(file_, *baseline.value<std::string>()), key,
              location(baseline.source(), file_));
}

void CropReader::read(const toml::table& table, const std::string& file) {
    crop_.growth.reset();
    crop_.grain.reset();
    // The bounds of the default traits do not apply to other traits.
    if (table.contains("trait")) crop_.bounds.clear();
    KnownNames unknown;
    unknown.passes_over_others = source_ == TextSource::history;
    const TableReader crop_reader(file, of_crop_, unknown),
        shared(file, problems_, unknown);
    // In campaigns, [field.variation] states the within-line variation, so that
    // [variation] of a crop file does not change it.
    constexpr Table variation = table_of<CropSpec, &CropSpec::variation>(
        "variation", crop_variation_table);
    std::vector<std::string> tables;
    for (const auto& all : {crop_table.tables(), std::span(&variation, 1),
                            crop_leaves_table.tables()})
        for (const Table& each : all) tables.emplace_back(each.name);
    crop_reader.read_keys(
        table, {std::string(crop_table.section), crop_table.keys(), &crop_},
        tables);
    for (const Table& each : crop_table.tables())
        crop_reader.read_table(table, each, each.name, &crop_);
    crop_reader.read_table(table, variation, variation.name, &crop_);
    // Campaigns may contain these tables too.
    for (const Table& each : crop_leaves_table.tables())
        shared.read_table(table, each, each.name, &crop_);
    note_leaves(table, file, crop_);
    for (Leaf& leaf : crop_.baseline.leaves)
        if (leaf.insertion_angle == 0 && leaf.curvature == 0)
            measure_midrib(leaf);
    stack_internodes(crop_.baseline);
    crop_.is_known = true;
}

void CropReader::read_file(const std::string& file, const std::string& named_by,
                           const Location& named_at) {
    const auto text = text_of(file, named_by, named_at, problems_);
    if (!text || is_table_of_leaves(file, named_by, named_at, problems_))
        return;
    if (const auto table = parse_toml(*text, file, problems_))
        read(*table, file);
}

void note_leaves(const toml::table& top, const std::string& file,
                 CropSpec& crop) {
    if (const toml::table* leaves = top["photosynthesis"].as_table())
        for (const auto& [key, value] : *leaves)
            crop.leaf_files[std::string(key.str())] =
                location(value.source(), file).file;
}

}  // namespace ideotype
