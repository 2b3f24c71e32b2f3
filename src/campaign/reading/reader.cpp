// SPDX-License-Identifier: Apache-2.0
#include "reader.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "files.hpp"
#include "nodes.hpp"
#include "tables.hpp"

namespace ideotype {

namespace {

//! Returns whether a table is a plant: whether it has leaves and no sites.
bool is_plant(const toml::table& top) {
    return top.contains("leaf") && !top.contains("site");
}

std::string month_and_day(const Date& date) {
    return fmt::format("{:02}{:02}", date.month, date.day);
}

//! Sorts the traits of a set in the order of the crop file: their order in a
//! campaign does not matter.
void sort_traits(const Draft& draft, TraitSet& free) {
    std::ranges::sort(free, {}, [&](const std::string& name) {
        return std::ranges::find(
            draft.traits, name,
            [](const TraitEntry& each) { return each.trait.name; });
    });
}

//! Reads a campaign, or one of its components, with its crop.
class DraftReader : CropReader {
  public:
    using CropReader::CropReader;

    void read(const toml::table& top) {
        Campaign& campaign = draft_.campaign;
        // Other tables name traits and organs of the crop.
        draft_.is_crop_known = false;
        if (const auto baseline = top["plant"]["baseline"])
            read_key(*baseline.node(), "plant.baseline");
        prepare(top["plant"]["bounds"].value_or<std::string>(""));
        read_components(top);
        draft_.has_climate = top.contains("climate");
        if (top["plant"]["bounds"].is_table()) draft_.rule.clear();
        drop_replaced_leaves(top);
        const std::vector<Table> tables = campaign_tables(draft_);
        tables_.read(top, top_section(campaign), tables);
        for (const Table& table : tables) tables_.read(top, table);
        note_leaves(top, file_);
        draft_.has_water = top.contains("water");
        for (std::size_t b = 1; b < wavebands.size(); ++b)
            campaign.follows[b] =
                (b == nir_band && draft_.has_water &&
                 draft_.water.rules.has_leaf_temperature) ||
                std::ranges::count(campaign.bands, wavebands[b].name,
                                   &BandEntry::name) > 0;
        // Threads share the components of a campaign, so all of their values
        // are set here.
        for (const std::shared_ptr<Draft>& each : draft_.components)
            each->campaign.follows = campaign.follows;
        if (const auto lines = top["feasibility"]["lines"])
            read_lines(*lines.node());
        draft_.has_photosynthesis = top.contains("photosynthesis") ||
                                    draft_.has_water ||
                                    asks_for_assimilation(campaign);
        draft_.has_optimizer = top["search"]["optimizer"].node() != nullptr;
        draft_.has_population = top["search"]["population"].node() != nullptr;
        draft_.has_finalists = top["final"]["candidates"].node() != nullptr;
        // Resolved campaigns have [sensitivity] if they search for nothing.
        if (source_ == PlantSource::table)
            draft_.is_study = top.contains("sensitivity");
        if (draft_.is_study)
            campaign.varied.has_traits = draft_.varied.has_traits;
        draft_.has_samples = top["sensitivity"]["samples"].node() != nullptr;
        choose_organs();
        for (auto& [name, free] : campaign.trait_sets)
            sort_traits(draft_, free);
        for (const std::shared_ptr<Draft>& each : draft_.components)
            sort_traits(*each, each->campaign.trait_sets.front().value);
        // If a file sets paths but no tolerance, all paths are traced.
        if (top["light"]["paths"] && !top["light"]["tolerance"])
            campaign.sampling.tolerance = 0;
        for (auto& [name, span] : campaign.days)
            if (name.empty() && !span.dates.empty()) {
                name = month_and_day(span.dates.front());
                if (span.dates.size() > 1)
                    name += '-' + month_and_day(span.dates.back());
            }
        for (auto& [name, climate] : campaign.climates)
            if (name.empty())
                name = month_and_day(climate.period.from) + '-' +
                       month_and_day(climate.period.to);
        for (auto& [name, spacing] : campaign.spacings) {
            const bool has_distance = spacing.plant > 0;
            if (!has_distance && spacing.density > 0 && spacing.row > 0)
                spacing.plant = 1 / (spacing.density * spacing.row);
            if (has_distance) spacing.density = 0;
            if (name.empty())
                name = fmt::format("{}x{}", std::lround(spacing.row * 1000),
                                   std::lround(spacing.plant * 1000));
        }
    }

  private:
    //! Removes the numbers of the crop's leaves that the campaign replaces.
    void drop_replaced_leaves(const toml::table& top) {
        const toml::table* leaves = top["photosynthesis"].as_table();
        if (!leaves) return;
        std::set<std::string> keys;
        for (const auto& [key, value] : *leaves) keys.emplace(key.str());
        drop_replaced_numbers(draft_, keys,
                              (*leaves)["model"].value_or<std::string>(""));
    }

    //! Derives from the crop what must be known to read the campaign.
    //! @param rule rule by which bounds are chosen
    void prepare(const std::string& rule) {
        Campaign& campaign = draft_.campaign;
        for (const TraitEntry& entry : draft_.traits) {
            const Trait& trait = entry.trait;
            draft_.own_bounds.push_back(trait.range);
            campaign.constraints.traits.push_back({trait.name});
            if (is_bred(draft_, trait, rule))
                campaign.trait_sets[0].value.push_back(trait.name);
        }
        draft_.organs = organ_names(campaign.crop.baseline);
    }

    void choose_organs() {
        Plant& plant = draft_.campaign.crop.baseline;
        for (const std::string& name : all_organs(plant))
            set_present(plant, name,
                        std::ranges::count(draft_.organs, name) > 0);
        draft_.organs = organ_names(plant);
    }

    void read_variation(const toml::node& node) {
        const Section section = variation_section(
            draft_.campaign.field.variation, "component.variation");
        draft_.has_variation = true;
        if (const toml::table* table = node.as_table())
            TableReader(file_, problems_.in("variation")).read(*table, section);
        else
            problems_.add(tables_.where(node),
                          "component.variation is {} (expected: table); write "
                          "[component.variation] before its keys",
                          kind(node));
    }

    //! Reads the keys of a component on which its other keys depend: its name,
    //! its crop and its own bounds.
    void read_component(const toml::table& table) {
        draft_.campaign.name = table["name"].value_or<std::string>("");
        draft_.is_crop_known = false;
        if (const toml::node* const crop = table.get("crop"))
            read_key(*crop, "component.crop");
        if (const toml::node* const variation = table.get("variation"))
            read_variation(*variation);
        prepare("");
        draft_.campaign.trait_sets.front().value.clear();
        if (!table["bounds"].is_table()) return;
        draft_.rule.clear();
        tables_.read(table, own_bounds_table(draft_, "component"));
    }

    void read_components(const toml::table& top) {
        const toml::array* const all = top["component"].as_array();
        const std::size_t count = all ? all->size() : 0;
        for (std::size_t i = 0; i < std::min(count, most_components); ++i) {
            Draft& component =
                *draft_.components.emplace_back(std::make_shared<Draft>());
            const Problems own = problems_.in("component", i);
            if (const auto* table = all->get_as<toml::table>(i))
                DraftReader(file_, source_, component, own, own.in("crop"))
                    .read_component(*table);
        }
    }

    void read_lines(const toml::node& named) {
        const std::string file =
            path_from(file_, named.value_or<std::string>(""));
        const auto text =
            text_of(file, "feasibility.lines", tables_.where(named), problems_);
        const auto top =
            text ? parse_toml(*text, file, problems_) : std::nullopt;
        if (!top) return;
        const TableReader tables(file, problems_.in("feasibility"));
        const std::vector<Table> parts = lines_tables(draft_.lines);
        tables.read(*top, lines_section(draft_.lines), parts);
        for (const Table& part : parts) tables.read(*top, part);
    }

    TableReader tables_{file_, problems_};
};

//! Removes the optimizer of a study, which histories of version 0.2.0 name.
void leave_out_study(toml::table& top, const std::string& file,
                     PlantSource source, Draft& draft,
                     const Problems& problems) {
    const auto optimizer = top["search"]["optimizer"];
    if (optimizer.value<std::string>() != "sensitivity") return;
    if (source != PlantSource::table)
        problems.add(location(optimizer.node()->source(), file),
                     "search.optimizer is \"sensitivity\" (a design, which "
                     "searches for nothing); remove it, and start ideotype "
                     "sensitivity CAMPAIGN");
    draft.is_study = true;
    top["search"].as_table()->erase("optimizer");
}

}  // namespace

void read_draft(const std::string& text, const std::string& file,
                PlantSource source, const std::vector<std::string>& settings,
                Draft& draft, const Problems& problems) {
    auto table = parse_toml(text, file, problems);
    if (table) apply_settings(settings, *table, problems);
    if (table && is_plant(*table))
        problems.add(Location{file, 1, 1},
                     "this is a crop file (it has leaves, but no site to "
                     "light them); give a campaign, or evaluate the plant in "
                     "one: ideotype compare PLANT --under CAMPAIGN");
    else if (table) {
        leave_out_study(*table, file, source, draft, problems);
        DraftReader(file, source, draft, problems,
                    problems.in("plant.baseline"))
            .read(*table);
    }
}

bool read_crop_draft(const std::string& text, const std::string& file,
                     Draft& draft, const Problems& problems) {
    CropReader reader(file, PlantSource::file_or_table, draft, problems,
                      problems);
    if (reader.is_table_of_leaves(file, {file, 1, 1})) return true;
    if (const auto table = parse_toml(text, file, problems)) {
        if (!is_plant(*table)) return false;
        reader.read_crop(*table, file);
    }
    return true;
}

}  // namespace ideotype
