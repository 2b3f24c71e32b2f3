// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include <fmt/format.h>

#include "campaign/schema/schema.hpp"
#include "files.hpp"
#include "nodes.hpp"
#include "reader.hpp"
#include "tables.hpp"

namespace ideotype {

namespace fs = std::filesystem;

void CropReader::read_key(const toml::node& baseline, const std::string& key) {
    if (const toml::table* table = baseline.as_table())
        return read_crop(*table, file_);
    const bool is_path = baseline.is_string();
    if (!is_path || source_ == PlantSource::table)
        return problems_.add(
            location(baseline.source(), file_),
            "{} is {} (expected: {}); write {}", key, kind(baseline),
            is_path ? "the plant itself" : "path or table",
            is_path ? fmt::format("it as [{}]", key)
                    : fmt::format("for example {} = \"crops/mine.toml\"",
                                  key.substr(key.find('.') + 1)));
    read_plant_file(path_from(file_, *baseline.value<std::string>()), key,
                    location(baseline.source(), file_));
}

void CropReader::read_crop(const toml::table& table, const std::string& file) {
    draft_.has_growth = table.contains("growth");
    // The bounds of the usual traits do not apply to other traits.
    if (table.contains("trait")) draft_.bounds.clear();
    Plant& plant = draft_.campaign.crop.baseline;
    const TableReader tables(file, of_crop_), shared(file, problems_);
    std::vector<Table> own = plant_tables(draft_);
    const std::vector<Table> defaults = crop_defaults(draft_);
    // Campaigns have this table as [field.variation], so that a crop's own
    // variation changes no campaign.
    draft_.crop_variation.reset();
    CropVariation unused;
    if (table.contains("variation")) draft_.crop_variation.emplace();
    own.push_back(one_table(crop_variation_section(draft_.crop_variation
                                                       ? *draft_.crop_variation
                                                       : unused))
                      .optional());
    std::vector<Table> all = own;
    all.insert(all.end(), defaults.begin(), defaults.end());
    tables.read(table, plant_file_section(plant), all);
    for (const Table& part : own) tables.read(table, part);
    // Campaigns also have these tables.
    for (const Table& part : defaults) shared.read(table, part);
    note_leaves(table, file);
    for (Leaf& leaf : plant.leaves)
        if (leaf.insertion_angle == 0 && leaf.curvature == 0)
            measure_midrib(leaf);
    stack_internodes(plant);
    draft_.is_crop_known = true;
}

void CropReader::note_leaves(const toml::table& top, const std::string& file) {
    if (const toml::table* leaves = top["photosynthesis"].as_table())
        for (const auto& [key, value] : *leaves)
            draft_.leaf_files[std::string(key.str())] =
                location(value.source(), file).file;
}

void CropReader::read_plant_file(const std::string& file,
                                 const std::string& named_by,
                                 const Location& named_at) {
    const auto text = text_of(file, named_by, named_at, problems_);
    if (text && !is_table_of_leaves(file, named_at)) read_crop(*text, file);
}

bool CropReader::is_table_of_leaves(const std::string& file,
                                    const Location& named_at) {
    if (fs::path(file).extension() != ".csv") return false;
    problems_.add(named_at,
                  "{} is a table (a plant is a crop file here); make a crop "
                  "file of it: ideotype fit {}",
                  file, file);
    return true;
}

void CropReader::read_crop(const std::string& text, const std::string& file) {
    if (const auto table = parse_toml(text, file, problems_))
        read_crop(*table, file);
}

}  // namespace ideotype
