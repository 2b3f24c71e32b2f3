// SPDX-License-Identifier: Apache-2.0
#include "reader.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ideotype/canopy/quantities.hpp"
#include "spec/crop_reader.hpp"
#include "spec/files.hpp"
#include "spec/nodes.hpp"
#include "spec/table_reader.hpp"
#include "spec/tables.hpp"
#include "spec/varied_keys.hpp"

namespace ideotype {

namespace {

//! Returns whether a file is a crop file: it describes leaves but no site.
bool is_plant(const toml::table& top) {
    return top.contains("leaf") && !top.contains("site");
}

std::string month_and_day(const Date& date) {
    return fmt::format("{:02}{:02}", date.month, date.day);
}

//! Sorts the traits of a set as in the crop file, since their order in a
//! campaign has no meaning.
void sort_traits(const CropSpec& crop, TraitSet& free) {
    std::ranges::sort(free, {}, [&](const std::string& name) {
        return std::ranges::find(crop.traits, name, [](const TraitEntry& each) {
            return each.trait.name;
        });
    });
}

//! Removes leaf parameters of the crop that a campaign replaces. If the
//! campaign names another model, all are removed. If it states `amax` or
//! `rate_2000`, both are removed, since each follows from the other.
//! @param leaves table [photosynthesis] of the campaign
void drop_replaced_numbers(const toml::table& leaves, CropSpec& crop) {
    PhotosynthesisSpec& table = crop.photosynthesis;
    const auto model = leaves["model"].value<std::string>();
    const bool is_other = model && *model != name_of(table.model);
    const bool has_capacity =
        leaves.contains("amax") || leaves.contains("rate_2000");
    for (const Key& key : photosynthesis_table.keys()) {
        if (!key.values.is_by_leaf) continue;
        auto* const numbers = std::get<std::vector<double>*>(key.place(&table));
        const bool is_capacity =
            numbers == &table.amax || numbers == &table.rate_2000;
        if (!is_other && !(has_capacity && is_capacity)) continue;
        numbers->clear();
        crop.leaf_files.erase(key.name);
    }
}

//! Returns the names of all objectives, including those of components.
std::vector<std::string> objectives_of(const Spec& spec) {
    std::vector<std::string> names = objective_names();
    if (spec.components.empty()) return names;
    std::vector<std::string> components{spec.plant.crop.baseline.name};
    for (const ComponentSpec& each : spec.components)
        components.push_back(each.name);
    for (const std::string& component : components)
        for (const std::string& quantity : additive_objectives())
            names.push_back(fmt::format("{}.{}", component, quantity));
    return names;
}

//! Reads a campaign. Crops are read first, since other tables refer to their
//! traits and organs.
class SpecReader {
  public:
    SpecReader(const std::string& file, TextSource source, Spec& spec,
               const Problems& problems)
        : file_(file), source_(source), spec_(spec), problems_(problems) {}

    void read(const toml::table& top) {
        read_crops(top);
        read_tables(top);
        if (const auto lines = top["feasibility"]["lines"])
            read_lines(*lines.node());
        follow_bands();
        spec_.assimilates = top.contains("photosynthesis") || spec_.water ||
                            asks_for_assimilation(spec_);
        choose_organs();
        complete_light();
        complete_names();
    }

  private:
    //! Reads a crop from a node, and initialises the campaign's own bounds of
    //! its traits.
    //! @param bounds node of the bounds, if there is one
    void read_crop(const toml::node* crop, const toml::node* bounds,
                   const std::string& key, CropSpec& into,
                   const Problems& of_tables, const Problems& of_crop) {
        into.is_known = false;
        if (crop)
            CropReader(file_, source_, into, of_tables, of_crop)
                .read_key(*crop, key);
        for (const TraitEntry& entry : into.traits)
            into.own_bounds.push_back(entry.trait.range);
        if (bounds && bounds->is_table())
            into.rule.clear();
        else if (const auto rule =
                     bounds ? bounds->value<std::string>() : std::nullopt;
                 rule && !rule->empty())
            into.rule = *rule;
    }

    //! Reads a table of bounds that the campaign itself states.
    //! @param parent name of the table that contains it
    void read_own_bounds(const toml::table& table, const std::string& parent,
                         CropSpec& crop, const Problems& problems) {
        const std::vector<Key> keys = own_bounds_keys(crop);
        TableReader(file_, problems.in("bounds"), nothing_known)
            .read_keys(table, {parent + ".bounds", keys, crop.own_bounds.data(),
                               sizeof(Range)});
    }

    void read_crops(const toml::table& top) {
        CropSpec& crop = spec_.plant.crop;
        read_crop(top["plant"]["baseline"].node(),
                  top["plant"]["bounds"].node(), "plant.baseline", crop,
                  problems_, problems_.in("plant.baseline"));
        for (const TraitEntry& entry : crop.traits) {
            const Trait& trait = entry.trait;
            spec_.constraints.traits.push_back({trait.name});
            if (is_bred(crop, trait))
                spec_.trait_sets[0].value.push_back(trait.name);
        }
        spec_.plant.organs = organ_names(crop.baseline);
        const toml::array* const components = top["component"].as_array();
        const std::size_t count = components ? components->size() : 0;
        for (std::size_t i = 0; i < std::min(count, most_components); ++i) {
            ComponentSpec& component = spec_.components.emplace_back();
            const toml::table* const table = components->get_as<toml::table>(i);
            if (!table) continue;
            const Problems of_component = problems_.in("component", i);
            component.name = (*table)["name"].value_or<std::string>("");
            if (table->contains("mesh")) {
                component.crop.is_known = false;
                continue;
            }
            read_crop(table->get("crop"), table->get("bounds"),
                      "component.crop", component.crop, of_component,
                      of_component.in("crop"));
        }
    }

    //! Reads the tables of the campaign, which may use names that its crops
    //! define.
    void read_tables(const toml::table& top) {
        CropSpec& crop = spec_.plant.crop;
        if (const toml::table* const leaves = top["photosynthesis"].as_table())
            drop_replaced_numbers(*leaves, crop);
        KnownNames known = names_of(crop);
        known.objectives = objectives_of(spec_);
        known.may_free_nothing = !spec_.components.empty();
        known.passes_over_others = source_ == TextSource::history;
        const TableReader reader(file_, problems_, known);
        reader.read(top, spec_table, &spec_);
        note_leaves(top, file_, crop);
        if (crop.rule.empty())
            read_own_bounds(*top["plant"]["bounds"].as_table(), "plant", crop,
                            problems_.in("plant"));
        const toml::array* const components = top["component"].as_array();
        for (std::size_t i = 0; i < spec_.components.size(); ++i)
            if (CropSpec& own_crop = spec_.components[i].crop;
                own_crop.rule.empty())
                read_own_bounds(
                    *(*components)[i].as_table()->get_as<toml::table>("bounds"),
                    "component", own_crop, problems_.in("component", i));
    }

    void read_lines(const toml::node& named) {
        const std::string file =
            path_from(file_, named.value_or<std::string>(""));
        const Location where = location(named.source(), file_);
        const auto text = text_of(file, "feasibility.lines", where, problems_);
        const auto top =
            text ? parse_toml(*text, file, problems_) : std::nullopt;
        if (top)
            TableReader(file, problems_.in("feasibility"), {})
                .read(*top, lines_table, &spec_.feasibility.lines);
    }

    void follow_bands() {
        const ByBand<bool> follows = followed_bands(spec_);
        spec_.plant.crop.follows = follows;
        for (ComponentSpec& each : spec_.components)
            each.crop.follows = follows;
    }

    void choose_organs() {
        Plant& plant = spec_.plant.crop.baseline;
        std::vector<std::string>& chosen = spec_.plant.organs;
        for (const std::string& name : all_organs(plant))
            set_present(plant, name, std::ranges::count(chosen, name) > 0);
        chosen = organ_names(plant);
    }

    //! Sets missing accuracy keys to the values that `fidelity` recommends.
    void complete_light() {
        LightSpec& light = spec_.light;
        // If only the number of paths is set, all paths are traced.
        if (!light.tolerance) light.tolerance = light.paths ? 0 : 0.005;
        if (!light.paths) light.paths = 16384;
        const bool has_climates = !spec_.climates.empty();
        problems_.doubt({"light.dates"}, light.dates && !has_climates,
                        "light.dates has no effect without a [[climate]]; "
                        "remove it, or give the weather of a season");
        problems_.doubt({"light.stages"}, light.stages && !plants_grow(spec_),
                        "light.stages has no effect on plants that do not "
                        "grow; remove it, or give a [[climate]] an "
                        "'emergence'");
        light.dates = has_climates ? std::optional(light.dates.value_or(3))
                                   : std::nullopt;
        light.stages = plants_grow(spec_)
                           ? std::optional(light.stages.value_or(10))
                           : std::nullopt;
        const std::string par = wavebands[0].name;
        if (std::ranges::count(spec_.plant.crop.follows, true) > 1)
            light.band = light.band.value_or(par);
        else if (light.band == par)
            light.band.reset();
    }

    void complete_names() {
        for (auto& [name, free] : spec_.trait_sets)
            sort_traits(spec_.plant.crop, free);
        for (ComponentSpec& each : spec_.components)
            sort_traits(each.crop, each.free);
        for (auto& [name, span] : spec_.days)
            if (name.empty() && !span.dates.empty()) {
                name = month_and_day(span.dates.front());
                if (span.dates.size() > 1)
                    name += '-' + month_and_day(span.dates.back());
            }
        complete_years();
        for (auto& [name, climate] : spec_.climates)
            if (name.empty())
                name = month_and_day(climate.period.from) + '-' +
                       month_and_day(climate.period.to);
        for (std::size_t i = 0; i < spec_.spacings.size(); ++i) {
            auto& [name, spacing] = spec_.spacings[i];
            const bool has_distance = spacing.plant > 0;
            problems_.in("spacing", i)
                .rule(ProblemCode::contradiction, {"density", "plant"},
                      has_distance && spacing.density > 0,
                      "spacing has 'plant' = {} m and 'density' = {} m-2, "
                      "which both set the distance between neighbours in a "
                      "row; remove one of them",
                      spacing.plant, spacing.density);
            if (has_distance) spacing.density = 0;
            spacing.follow_density();
            if (name.empty())
                name = fmt::format("{}x{}", std::lround(spacing.row * 1000),
                                   std::lround(spacing.plant * 1000));
        }
    }

    //! Replaces each climate with several years by a climate for each year.
    void complete_years() {
        std::vector<NamedClimate> all;
        for (std::size_t c = 0; c < spec_.climates.size(); ++c) {
            NamedClimate& table = spec_.climates[c];
            table.value.table = c;
            const Climate& climate = table.value;
            const std::size_t count = climate.weights.size();
            const bool is_one = climate.years.empty();
            const bool fits =
                count <= 1 || (!is_one && count == climate.years.size());
            problems_.in("climate", c)
                .rule({"weights", "years"}, !fits,
                      "climate.weights has {} values (for {} years); give one "
                      "for each year, or one for all",
                      count, is_one ? 1 : climate.years.size());
            if (is_one) {
                all.push_back(std::move(table));
                continue;
            }
            for (std::size_t y = 0; y < climate.years.size(); ++y) {
                const int year = static_cast<int>(climate.years[y]);
                NamedClimate& one = all.emplace_back(table);
                one.name +=
                    (one.name.empty() ? "" : "_") + std::to_string(year);
                one.value.years.clear();
                if (count > 1 && fits) one.value.weights = {climate.weights[y]};
                const int later = year - climate.period.from.year;
                for (Date* date : {&one.value.period.from, &one.value.period.to,
                                   &one.value.emergence})
                    if (date->year > 0)
                        *date = in_year(*date, date->year + later);
            }
        }
        spec_.climates = std::move(all);
    }

    const std::string& file_;
    TextSource source_;
    Spec& spec_;
    Problems problems_;
};

}  // namespace

Spec read_spec(const std::string& text, const std::string& file,
               TextSource source, const std::vector<std::string>& settings,
               bool is_study, const Problems& problems) {
    Spec spec;
    auto table = parse_toml(text, file, problems);
    if (!table) return spec;
    apply_settings(settings, *table, problems);
    // Resolved campaigns contain [sensitivity] only if they are sensitivity
    // studies.
    spec.is_study =
        source == TextSource::file ? is_study : table->contains("sensitivity");
    if (is_plant(*table))
        problems.add_at(Location{file, 1, 1}, "", ProblemCode::file,
                        "this is a crop file (it has leaves, but no site); "
                        "give a campaign, or evaluate the plant in one: "
                        "ideotype compare PLANT --under CAMPAIGN");
    else
        SpecReader(file, source, spec, problems).read(*table);
    spec.passed_over = problems.passed_over();
    return spec;
}

Spec read_resolved(const std::string& text) {
    Spec spec = read_spec(text, "", TextSource::history, {}, false, Problems());
    complete_factors(spec);
    return spec;
}

std::string passed_over_text(const std::set<std::string>& keys) {
    return fmt::format(
        "the campaign of this history has keys that this version lacks ({}); "
        "they are ignored; the version that wrote the history reads them",
        fmt::join(keys, ", "));
}

std::optional<CropSpec> read_crop_spec(const std::string& text,
                                       const std::string& file,
                                       const Problems& problems) {
    CropSpec crop;
    if (is_table_of_leaves(file, "", {file, 1, 1}, problems)) return crop;
    if (const auto table = parse_toml(text, file, problems)) {
        if (!is_plant(*table)) return std::nullopt;
        CropReader(file, TextSource::file, crop, problems, problems)
            .read(*table, file);
    }
    return crop;
}

}  // namespace ideotype
