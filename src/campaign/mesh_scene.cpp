// SPDX-License-Identifier: Apache-2.0
#include "mesh_scene.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/campaign.hpp"
#include "campaign/checks/checks.hpp"
#include "campaign/leaves.hpp"
#include "campaign/weather_reader.hpp"
#include "spec/files.hpp"
#include "spec/nodes.hpp"
#include "spec/table_reader.hpp"
#include "spec/tables.hpp"
#include "spec/values.hpp"

namespace ideotype {

namespace {

//! Reads the albedo of the soil: one number, or one for each band.
void read_soil(const toml::table& top, const std::vector<std::string>& bands,
               const TableReader& reader, const Problems& problems,
               MeshScene& scene) {
    double albedo = usual_soil_albedo[par_band];
    const toml::node* const node = top.get("soil_albedo");
    const bool is_table = node && node->is_table();
    if (is_table)
        reader.in("soil_albedo")
            .read(*node->as_table(), mesh_soil_table, &scene);
    else if (node)
        read_value(*node, "top", {mesh_scene_table.keys().front(), &albedo},
                   nothing_known, problems);
    for (const auto& [band, of_band] : scene.soil_albedo)
        problems.in("soil_albedo")
            .rule({band}, std::ranges::count(bands, band) == 0,
                  "soil_albedo.{} names no band (the materials have {}); "
                  "remove it",
                  band, fmt::join(bands, ", "));
    for (const std::string& band : bands) {
        const bool is_new = scene.soil_albedo.emplace(band, albedo).second;
        problems.rule(
            {"soil_albedo"},
            is_new && (is_table || (!node && bands.size() > 1)),
            "soil_albedo has no {0} (a band of the materials); add {0} = 0.1",
            band);
    }
}

void check_component(const std::vector<MeshScene::Component>& components,
                     std::size_t i, const std::vector<std::string>& bands,
                     const Problems& problems) {
    const MeshScene::Component& one = components[i];
    const auto same = [&](const auto& other) { return other.name == one.name; };
    problems.rule(
        {"name"}, std::any_of(components.begin(), components.begin() + i, same),
        "component.name is \"{}\" (already used); give each a different name",
        one.name);
    if (!one.photosynthesis) return;
    problems.in("photosynthesis")
        .rule({"model"}, bands.empty() || bands.front() != "par",
              "there is photosynthesis, but no band \"par\" (which leaves "
              "assimilate); name a band of the materials par");
    check_photosynthesis(*one.photosynthesis, 0, problems);
}

//! Reads a file that may contain only the given tables.
//! @param tables path of each table's keys for problems, and the table
void read_tables(const std::string& text, const std::string& file,
                 const std::vector<std::pair<std::string, Section>>& tables,
                 const Problems& problems) {
    const auto top = parse_toml(text, file, problems);
    if (!top) return;
    const TableReader reader(file, problems, nothing_known);
    std::vector<std::string> names;
    for (const auto& [at, table] : tables) names.push_back(table.name);
    reader.read_keys(*top, {file, {}}, names);
    for (const auto& [at, table] : tables) {
        const toml::node* const node = top->get(table.name);
        if (node && node->is_table())
            reader.in(at).read_keys(*node->as_table(), table);
        else
            problems.add_at(Location{file, 1, 1}, table.name,
                            ProblemCode::missing,
                            "there is no table [{0}] (for which this file is "
                            "read); write [{0}] and its keys",
                            table.name);
    }
}

//! Returns the keys of a table, among which the name is optional.
std::vector<Key> nameless(const Description& description) {
    std::vector<Key> keys(description.keys().begin(), description.keys().end());
    keys.front().initial.is_required = false;
    return keys;
}

}  // namespace

Photosynthesis read_photosynthesis(const std::string& path) {
    MeshLeaves table;
    const Problems problems;
    read_tables(read_text(path), path,
                {{"photosynthesis",
                  {"photosynthesis", photosynthesis_table.keys(), &table}}},
                problems);
    check_photosynthesis(table, 0, problems);
    problems.throw_if_any();
    return to_photosynthesis(table);
}

SeasonLight read_climate(const std::string& path) {
    Spec spec;
    const Problems problems;
    spec.sites.resize(1);
    spec.climates.resize(1);
    spec.plant.crop.follows.fill(true);
    // A climate file does not contain [optics]; report problems with it at line
    // 1.
    problems.locate("optics.par_fraction", {path, 1, 1});
    const std::vector<Key> site = nameless(site_table),
                           climate = nameless(climate_table);
    read_tables(read_text(path), path,
                {{"site[0]", {"site", site, &spec.sites.front()}},
                 {"climate[0]", {"climate", climate, &spec.climates.front()}}},
                problems);
    read_weathers(path, TextSource::file, spec, problems);
    problems.throw_if_any();
    Campaign campaign;
    campaign.spec = spec;
    Case chosen;
    chosen.site = spec.sites.front();
    chosen.day_name = spec.climates.front().name;
    return {light_of(campaign, chosen), problems.warnings()};
}

MeshScene read_mesh_scene(const std::string& path) {
    const Problems problems;
    MeshScene scene;
    scene.file = path;
    if (const auto top = parse_toml(read_text(path), path, problems)) {
        const TableReader reader(path, problems, nothing_known);
        reader.read(*top, mesh_scene_table, &scene);
        const std::vector<std::string> bands = bands_of(scene.materials);
        check_materials(scene.materials, bands, "material", problems);
        if (!scene.materials.empty())
            problems.in("material", 0)
                .rule({"groups"}, bands.empty(),
                      "material has no optical properties; add par = [0.06, "
                      "0.03]");
        read_soil(*top, bands, reader, problems, scene);
        for (std::size_t i = 0; i < scene.components.size(); ++i)
            check_component(scene.components, i, bands,
                            problems.in("component", i));
    }
    problems.throw_if_any();
    for (MeshScene::Component& each : scene.components)
        if (each.groups.empty()) each.groups = {each.name};
    if (scene.components.empty()) scene.components = {{"all", {""}, {}}};
    return scene;
}

}  // namespace ideotype
