// SPDX-License-Identifier: Apache-2.0
#include "files.hpp"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "campaign/checks/checks.hpp"
#include "campaign/schema/leaf_tables.hpp"
#include "ideotype/core/file.hpp"
#include "nodes.hpp"
#include "reader.hpp"
#include "tables.hpp"

namespace ideotype {

namespace {

namespace fs = std::filesystem;

//! Returns what to do about a missing file: name another file of its folder
//! with a similar name, or else the given words.
std::string remedy_for(const fs::path& missing, const std::string& otherwise) {
    std::vector<std::string> names;
    std::error_code none;
    for (const auto& entry :
         fs::directory_iterator(fs::absolute(missing).parent_path(), none))
        if (entry.path().extension() == ".toml")
            names.push_back(entry.path().stem().string());
    // Folders have no defined order, but advice must.
    std::sort(names.begin(), names.end());
    const std::string near = nearest_name(missing.stem().string(), names);
    return near.empty() ? otherwise : "did you mean '" + near + ".toml'?";
}

//! Reads the text of a file that has the given tables and no others.
void read_tables(const std::string& text, const std::string& file,
                 const std::vector<Table>& all, const Problems& problems) {
    const auto top = parse_toml(text, file, problems);
    if (!top) return;
    const TableReader tables(file, problems);
    tables.read(*top, Section(file, {}), all);
    for (const Table& table : all)
        if (top->contains(table.name))
            tables.read(*top, table);
        else
            problems.add(Location{file, 1, 1},
                         "there is no table [{0}] (this file is read for it); "
                         "write [{0}] and its keys",
                         table.name);
}

}  // namespace

std::string path_from(const std::string& file, const std::string& path) {
    return (fs::path(file).parent_path() / path)
        .lexically_normal()
        .generic_string();
}

std::string read_text(const std::string& path) {
    FileText file = read_file(path, most_input_bytes);
    if (!file.is_there)
        throw Error(file.refusal(path) + "; " +
                    remedy_for(path, "name a file that can be read"));
    return std::move(file.text);
}

std::optional<std::string> text_of(const std::string& file,
                                   const std::string& named_by,
                                   const Location& named_at,
                                   const Problems& problems) {
    FileText read = read_file(file, most_input_bytes);
    if (read.is_there) return std::move(read.text);
    problems.add(named_at, "{} (named by {}); {}", read.refusal(file), named_by,
                 remedy_for(file, "give a path relative to this file"));
    return std::nullopt;
}

Photosynthesis read_photosynthesis(const std::string& path) {
    PhotosynthesisTable table = photosynthesis_of_meshes();
    Problems problems;
    read_tables(read_text(path), path,
                {one_table(photosynthesis_section(table))}, problems);
    check_photosynthesis(table, 0, problems);
    problems.throw_if_any();
    return to_photosynthesis(table);
}

SeasonLight read_climate(const std::string& path) {
    Draft draft;
    Problems problems;
    Campaign& campaign = draft.campaign;
    campaign.sites.assign(1, {});
    campaign.climates.assign(1, {});
    // A file of a climate has no table [optics], so line 1 stands for it.
    problems.locate("optics.par_fraction", {path, 1, 1});
    read_tables(read_text(path), path, climate_file_tables(campaign), problems);
    read_weathers(path, PlantSource::file_or_table, draft, problems);
    problems.throw_if_any();
    Case chosen;
    chosen.site = campaign.sites.front();
    chosen.day_name = campaign.climates.front().name;
    return {light_of(campaign, chosen), problems.warnings()};
}

}  // namespace ideotype
