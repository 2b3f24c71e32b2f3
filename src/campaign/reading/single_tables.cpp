// SPDX-License-Identifier: Apache-2.0
// Reads files of photosynthesis and of a climate that no campaign names.
#include "campaign/checks/checks.hpp"
#include "campaign/schema/leaf_tables.hpp"
#include "files.hpp"
#include "nodes.hpp"
#include "reader.hpp"
#include "tables.hpp"

namespace ideotype {

namespace {

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
