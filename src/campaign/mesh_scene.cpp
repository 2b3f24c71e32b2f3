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

namespace ideotype {

namespace {

//! The optical numbers of a material in the bands that its table names.
struct Entry {
    MeshScene::Matter matter;
    std::vector<std::string> names;
    const toml::table* table;
};

class SceneReader {
  public:
    SceneReader(const std::string& file, const Problems& problems)
        : file_(file), problems_(problems) {
        scene_.file = file;
    }

    MeshScene read(const toml::table& top) {
        for (const auto& [key, node] : top)
            if (key.str() != "soil_albedo" && key.str() != "material" &&
                key.str() != "component")
                add(key, std::string(key.str()), ProblemCode::unknown_key,
                    "unknown key '{}' (nothing would read it); use "
                    "soil_albedo, [[material]] and [[component]]",
                    key.str());
        for (const toml::table* each : entries(top, "material"))
            read_material(*each);
        // Assimilation is computed from the first band.
        std::stable_partition(
            scene_.bands.begin(), scene_.bands.end(),
            [](const std::string& band) { return band == "par"; });
        for (Entry& each : entries_) order(each);
        read_soil(top);
        for (const toml::table* each : entries(top, "component"))
            read_component(*each);
        if (scene_.components.empty()) scene_.components = {{"all", {""}}};
        return std::move(scene_);
    }

  private:
    template <class Place, class... Args>
    void add(const Place& place, const std::string& key, ProblemCode code,
             fmt::format_string<Args...> text, Args&&... args) {
        problems_.add_at(location(place.source(), file_), key, code, text,
                         std::forward<Args>(args)...);
    }

    std::vector<const toml::table*> entries(const toml::table& top,
                                            const std::string& name) {
        std::vector<const toml::table*> all;
        const toml::node* node = top.get(name);
        if (!node && name == "material")
            add(top, name, ProblemCode::missing,
                "there is no [[material]] (surfaces need reflectance and "
                "transmittance); write [[material]] with groups = \"leaf\" and "
                "par = [0.05, 0.05]");
        if (!node) return all;
        if (const toml::array* array = node->as_array())
            for (const toml::node& each : *array)
                if (each.is_table()) all.push_back(each.as_table());
        if (all.empty())
            add(*node, name, ProblemCode::wrong_type,
                "{} is {} (expected: tables); write [[{}]] before the keys of "
                "each",
                name, kind(*node), name);
        return all;
    }

    //! Reads prefixes of group names: a text or a list of texts.
    std::vector<std::string> read_groups(const toml::table& table,
                                         const std::string& in,
                                         const std::string& initial) {
        std::vector<std::string> groups;
        const toml::node* node = table.get("groups");
        if (!node) {
            if (initial.empty())
                add(table, in + ".groups", ProblemCode::missing,
                    "{} has no groups (what the names of its groups begin "
                    "with); add groups = \"maize_leaf\"",
                    in);
            return {initial};
        }
        const auto take = [&](const toml::node& text) {
            if (const auto found = text.value<std::string>())
                groups.push_back(*found);
            else
                add(text, in + ".groups", ProblemCode::wrong_type,
                    "{}.groups is {} (expected: a text or a list of texts); "
                    "write groups = \"maize_leaf\"",
                    in, kind(text));
        };
        if (const toml::array* list = node->as_array())
            for (const toml::node& each : *list) take(each);
        else
            take(*node);
        return groups;
    }

    //! Reads a fraction of light; returns NaN if it is not a fraction.
    double read_part(const toml::node& node, const std::string& what) {
        const std::optional<double> part = node.value<double>();
        if (part && *part >= 0 && *part <= 1) return *part;
        add(node, what,
            part ? ProblemCode::out_of_range : ProblemCode::wrong_type,
            "{} is {} (a part of light from 0 to 1); write a decimal number "
            "such as 0.05",
            what, part ? fmt::format("{}", *part) : kind(node));
        return 0;
    }

    void read_material(const toml::table& table) {
        Entry entry{{}, {}, &table};
        entry.matter.groups = read_groups(table, "material", "");
        for (const auto& [key, node] : table) {
            const std::string band(key.str());
            if (band == "groups") continue;
            entry.names.push_back(band);
            if (std::ranges::count(scene_.bands, band) == 0)
                scene_.bands.push_back(band);
            entry.matter.bands.push_back(read_band(node, band));
        }
        entries_.push_back(std::move(entry));
    }

    Material read_band(const toml::node& node, const std::string& band) {
        const std::string name = "material." + band;
        const toml::array* list = node.as_array();
        if (!list || list->size() < 2 || list->size() > 3) {
            add(node, name, ProblemCode::wrong_type,
                "{} is {} (expected: reflectance and transmittance, or "
                "reflectance of the upper and the lower face and "
                "transmittance); write {} = [0.06, 0.03]",
                name, kind(node), band);
            return {};
        }
        std::vector<double> parts;
        for (const toml::node& each : *list)
            parts.push_back(read_part(each, name));
        const double reflected = std::max(parts[0], parts[parts.size() - 2]);
        // Decimal fractions such as 0.7 + 0.3 may exceed 1 by rounding.
        if (reflected + parts.back() > 1 + 1e-12)
            add(node, name, ProblemCode::contradiction,
                "{} sends on {} of the light (more than all); reflectance and "
                "transmittance sum to 1 at most",
                name, reflected + parts.back());
        return parts.size() == 2 ? Material(parts[0], parts[1])
                                 : Material(parts[0], parts[1], parts[2]);
    }

    //! Puts the bands of a material into the order of the scene's bands.
    void order(Entry& entry) {
        MeshScene::Matter matter{std::move(entry.matter.groups)};
        for (const std::string& band : scene_.bands) {
            const auto found = std::ranges::find(entry.names, band);
            if (found == entry.names.end()) {
                add(*entry.table, "material." + band, ProblemCode::missing,
                    "the material of groups {} has no {} (another material "
                    "has); add {} = [0.06, 0.03]",
                    fmt::join(matter.groups, ", "), band, band);
                matter.bands.emplace_back();
            } else {
                matter.bands.push_back(
                    entry.matter.bands[static_cast<std::size_t>(
                        found - entry.names.begin())]);
            }
        }
        scene_.materials.push_back(std::move(matter));
    }

    void read_soil(const toml::table& top) {
        const toml::node* node = top.get("soil_albedo");
        scene_.soil_albedo.assign(scene_.bands.size(), usual_soil_albedo[0]);
        if (!node) {
            if (scene_.bands.size() > 1)
                add(top, "soil_albedo", ProblemCode::missing,
                    "there is no soil_albedo (the soil reflects in each band); "
                    "add soil_albedo = {{ {} = 0.1 }}",
                    fmt::join(scene_.bands, " = 0.1, "));
            return;
        }
        const toml::table* by_band = node->as_table();
        if (!by_band) {
            scene_.soil_albedo.assign(scene_.bands.size(),
                                      read_part(*node, "soil_albedo"));
            return;
        }
        for (const auto& [key, each] : *by_band)
            if (std::ranges::count(scene_.bands, key.str()) == 0)
                add(key, "soil_albedo." + std::string(key.str()),
                    ProblemCode::unknown_key,
                    "soil_albedo.{} names no band (the materials have {}); "
                    "remove it",
                    key.str(), fmt::join(scene_.bands, ", "));
        for (std::size_t b = 0; b < scene_.bands.size(); ++b) {
            const std::string& band = scene_.bands[b];
            if (const toml::node* each = by_band->get(band))
                scene_.soil_albedo[b] = read_part(*each, "soil_albedo." + band);
            else
                add(*node, "soil_albedo." + band, ProblemCode::missing,
                    "soil_albedo has no {0} (a band of the materials); add {0} "
                    "= 0.1",
                    band);
        }
    }

    void read_component(const toml::table& table) {
        MeshScene::Kind kind;
        if (const auto name = table["name"].value<std::string>())
            kind.name = *name;
        if (!is_name(kind.name))
            add(table, "component.name", ProblemCode::missing,
                "a component has no name (letters, digits, _ and -); add name "
                "= \"maize\"");
        for (const MeshScene::Kind& other : scene_.components)
            if (other.name == kind.name)
                add(table, "component.name", ProblemCode::duplicate,
                    "component.name is \"{}\" (already used); give each a name "
                    "of its own",
                    kind.name);
        kind.groups = read_groups(table, "component", kind.name);
        for (const auto& [key, node] : table)
            if (key.str() != "name" && key.str() != "groups" &&
                key.str() != "photosynthesis")
                add(key, "component." + std::string(key.str()),
                    ProblemCode::unknown_key,
                    "unknown key '{}' in [[component]] (nothing would read "
                    "it); use name, groups or photosynthesis",
                    key.str());
        if (const toml::node* node = table.get("photosynthesis"))
            kind.photosynthesis = read_leaves(*node);
        scene_.components.push_back(std::move(kind));
    }

    std::optional<Photosynthesis> read_leaves(const toml::node& node) {
        const toml::table* table = node.as_table();
        if (!table) {
            add(node, "component.photosynthesis", ProblemCode::wrong_type,
                "photosynthesis is {} (expected: a table); write "
                "photosynthesis = {{ model = \"hyperbola\", amax = 50 }}",
                kind(node));
            return std::nullopt;
        }
        if (scene_.bands.empty() || scene_.bands.front() != "par")
            add(node, "component.photosynthesis", ProblemCode::contradiction,
                "there is photosynthesis, but no band \"par\" (which leaves "
                "assimilate); name a band of the materials par");
        PhotosynthesisSpec leaves = photosynthesis_of_meshes();
        const Problems own =
            problems_.in("component", scene_.components.size());
        TableReader(file_, own.in("photosynthesis"), nothing_known)
            .read_keys(*table, {"photosynthesis", photosynthesis_table.keys(),
                                &leaves});
        check_photosynthesis(leaves, 0, own);
        return to_photosynthesis(leaves);
    }

    const std::string& file_;
    const Problems& problems_;
    MeshScene scene_;
    std::vector<Entry> entries_;
};

//! Reads the text of a file that has the given tables and no others.
//! @param tables tables, each with the path of its keys for problems
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
                            "there is no table [{0}] (this file is read for "
                            "it); write [{0}] and its keys",
                            table.name);
    }
}

//! Returns the keys of a table without the need of a name.
std::vector<Key> nameless(const Description& description) {
    std::vector<Key> keys(description.keys().begin(), description.keys().end());
    keys.front().initial.is_required = false;
    return keys;
}

}  // namespace

Photosynthesis read_photosynthesis(const std::string& path) {
    PhotosynthesisSpec table = photosynthesis_of_meshes();
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
    // A file of a climate has no table [optics], so line 1 stands for it.
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
    const std::string text = read_text(path);
    Problems problems;
    MeshScene scene;
    if (const auto top = parse_toml(text, path, problems))
        scene = SceneReader(path, problems).read(*top);
    problems.throw_if_any();
    return scene;
}

}  // namespace ideotype
