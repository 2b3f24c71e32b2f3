#include "resolve.hpp"

#include <fmt/format.h>

#include "schema.hpp"

namespace ideotype {

namespace {

//! Appends the keys of a section; values with a form of their own have
//! their own tables.
void append_keys(std::string& text, const Section& section) {
    for (const Key& key : section.keys)
        if (address(key.value))
            text += fmt::format("{} = {}\n", key.name, toml_text(key));
}

void append_table(std::string& text, const std::string& name,
                  const Section& section) {
    text += fmt::format("\n[{}]\n", name);
    append_keys(text, section);
}

template <class Record>
void append_entries(std::string& text, const std::string& name,
                    Section (*section_of)(Record&),
                    std::vector<Record>& records) {
    for (Record& record : records) {
        text += fmt::format("\n[[{}]]\n", name);
        append_keys(text, section_of(record));
    }
}

//! What a plant consists of; prefix is that of its tables.
void append_parts(std::string& text, const std::string& prefix, Draft& draft) {
    PlantForm& plant = draft.campaign.plant;
    append_table(text, prefix + "stalk", stalk_section(plant.stalk));
    append_table(text, prefix + "blade", blade_section(plant.blade));
    append_entries(text, prefix + "leaf", leaf_section, draft.leaves);
}

void append_plant(std::string& text, Draft& draft) {
    Section section = plant_section(draft);
    const bool has_table = draft.bounds.rule.empty();
    if (has_table)
        for (Key& key : section.keys)
            if (key.name == "bounds") key.value = {};
    append_table(text, "plant", section);
    if (has_table)
        append_table(text, "plant.bounds", bounds_section(draft.bounds.table));
    append_table(text, "plant.baseline",
                 plant_file_section(draft.campaign.plant));
    append_parts(text, "plant.baseline.", draft);
}

}  // namespace

std::string resolved_text(Draft& draft) {
    Campaign& campaign = draft.campaign;
    std::string text;
    append_keys(text, top_section(campaign));
    append_entries(text, "site", site_section, campaign.sites);
    append_entries(text, "day", day_section, campaign.days);
    append_entries(text, "spacing", spacing_section, campaign.spacings);
    append_entries(text, "traits", traits_section, campaign.trait_sets);
    append_table(text, "field", field_section(campaign.field));
    append_plant(text, draft);
    append_table(text, "optics", optics_section(campaign));
    append_table(text, "light", light_section(campaign));
    append_table(text, "objective", objective_section(campaign));
    append_table(text, "constraints",
                 constraints_section(campaign.constraints));
    append_table(text, "search", search_section(campaign.search));
    append_table(text, "stop", stop_section(campaign.stop));
    append_table(text, "final", final_section(campaign.final_rule));
    append_table(text, "parallel", parallel_section(campaign.answer_limits));
    return text;
}

std::string resolved_plant_text(Draft& draft) {
    std::string text;
    append_keys(text, plant_file_section(draft.campaign.plant));
    append_parts(text, "", draft);
    return text;
}

}  // namespace ideotype
