// SPDX-License-Identifier: Apache-2.0
#include "schema.hpp"

namespace ideotype {

namespace {

Section spacing_section(Named<Spacing>& named) {
    Spacing& spacing = named.value;
    Section section("spacing", {{"name", &named.name},
                                {"row", &spacing.row},
                                {"plant", &spacing.plant},
                                {"density", &spacing.density},
                                {"row_direction", &spacing.row_direction}});
    for (const char* key : {"row", "plant"})
        section[key].in_metres({{"centimetres", 0.01}, {"inches", 0.0254}});
    section["density"].written_if(false);
    return section;
}

//! Returns the names of the crop's traits, unless it could not be read.
std::vector<std::string> trait_names(const Draft& draft) {
    std::vector<std::string> known;
    if (draft.is_crop_known)
        for (const TraitEntry& each : draft.traits)
            known.push_back(each.trait.name);
    return known;
}

Section traits_section(const Draft& draft, Named<TraitSet>& traits) {
    Section section("traits",
                    {{"name", &traits.name}, {"free", &traits.value}});
    Key& free = section["free"].one_of(trait_names(draft));
    // Components may be bred instead of the crop.
    free.is_required = draft.components.empty();
    free.written_if(!traits.value.empty());
    return section;
}

Section field_section(FieldForm& field) {
    Section section(
        "field", {{"rows", &field.rows},
                  {"plants", &field.plants},
                  {"row_pattern", &field.row_pattern},
                  {"boundary",
                   choice(field.boundary, {{"periodic", Boundary::periodic},
                                           {"isolated", Boundary::isolated}})},
                  {"border_rows", &field.border_rows},
                  {"jitter", &field.jitter}});
    const bool repeats = field.boundary == Boundary::periodic;
    for (const char* key : {"rows", "plants"})
        section[key].trades({1, 2, 4, 6}, repeats);
    section["row_pattern"].optional_list();
    return section;
}

Section band_section(BandEntry& band) {
    return {"band", {{"name", &band.name}}};
}

Section component_section(Draft& component) {
    Standing& standing = component.standing;
    TraitSet& free = component.campaign.trait_sets.front().value;
    Section section("component", {{"name", &component.campaign.name},
                                  {"crop", {}},
                                  {"free", &free},
                                  {"bounds", place_of_rule(component)},
                                  {"variation", {}},
                                  {"rows", &component.rows},
                                  {"mixed", &standing.mixed},
                                  {"plants", &standing.plants},
                                  {"later", &standing.later},
                                  {"jitter", &standing.jitter}});
    section["free"].one_of(trait_names(component)).written_if(!free.empty());
    section["bounds"]
        .one_of(rule_names(component))
        .written_if(component.rule != "traits");
    section["rows"].optional_list();
    section["mixed"].written_if(standing.mixed > 0);
    section["plants"].written_if(standing.plants > 0);
    section["later"].written_if(standing.later > 0);
    return section;
}

Table component_table(Draft& draft) {
    std::vector<std::shared_ptr<Draft>>& all = draft.components;
    return {"component",
            [&all](std::size_t i) { return component_section(*all.at(i)); },
            [&all] { return all.size(); },
            [&all](std::size_t n) {
                while (all.size() < n) all.push_back(std::make_shared<Draft>());
            }};
}

}  // namespace

Section variation_section(PlantVariation& variation, const std::string& name) {
    return {name,
            {{"length", &variation.length},
             {"width", &variation.width},
             {"insertion_angle", &variation.insertion_angle},
             {"curvature", &variation.curvature},
             {"azimuth", &variation.azimuth},
             {"roll", &variation.roll},
             {"twist", &variation.twist},
             {"height", &variation.height},
             {"across_row", &variation.across_row},
             {"missing", &variation.missing},
             {"late", &variation.late},
             {"late_size", &variation.late_size},
             {"position", &variation.position},
             {"position_across", &variation.position_across}},
            "field.variation"};
}

Section crop_variation_section(CropVariation& variation) {
    Section section = variation_section(variation.plants, "variation");
    section.keys.emplace_back("jitter", &variation.jitter,
                              key_info("field", "jitter"));
    return section;
}

Table optics_table(Campaign& campaign, bool has_soil) {
    const auto table = [&](std::size_t b) {
        auto& [leaf, stalk, sheath] = campaign.optics[b];
        Section optics(wavebands[b].table,
                       {{"leaf_reflectance", &leaf.reflectance},
                        {"leaf_transmittance", &leaf.transmittance},
                        {"stalk_reflectance", &stalk.reflectance},
                        {"stalk_transmittance", &stalk.transmittance},
                        {"sheath_reflectance", &sheath.reflectance},
                        {"sheath_transmittance", &sheath.transmittance}});
        if (has_soil) optics.add("soil_albedo", &campaign.soil_albedo[b]);
        if (has_soil && b == 0)
            optics.add("par_fraction", &campaign.par_fraction);
        return one_table(optics);
    };
    Table all = table(0);
    for (std::size_t b = 1; b < wavebands.size(); ++b)
        all.with(table(b).optional().left_out_if(!campaign.follows[b]),
                 wavebands[b].name);
    return all;
}

Section top_section(Campaign& campaign) {
    return {"top",
            {{"name", &campaign.name},
             {"seed", &campaign.seed},
             {"replicates", &campaign.replicates}}};
}

std::vector<Table> campaign_tables(Draft& draft) {
    Campaign& campaign = draft.campaign;
    PlantVariation& variation = campaign.field.variation;
    Table days = list_of_tables("day", day_section, campaign.days);
    days.is_optional = draft.has_climate;
    std::vector<Table> tables{
        list_of_tables("site", site_section, campaign.sites)
            .at_most(most_entries),
        days.at_most(most_entries),
        list_of_tables("climate", climate_section, campaign.climates)
            .optional(),
        list_of_tables("spacing", spacing_section, campaign.spacings)
            .at_most(most_entries),
        list_of_tables(
            "traits",
            [&draft](Named<TraitSet>& traits) {
                return traits_section(draft, traits);
            },
            campaign.trait_sets),
        one_table(field_section(campaign.field))
            .with(one_table(variation_section(variation, "field.variation"))
                      .optional()
                      .left_out_if(!variation.is_any()),
                  "variation"),
        plant_table(draft),
        component_table(draft).optional().at_most(most_components)};
    const auto append = [&](std::vector<Table> more) {
        std::move(more.begin(), more.end(), std::back_inserter(tables));
    };
    append(object_tables(campaign));
    append({list_of_tables("band", band_section, campaign.bands)
                .optional()
                .at_most(wavebands.size()),
            optics_table(campaign, true)});
    append(measured_tables(draft));
    append({one_table(photosynthesis_section(draft.photosynthesis))
                .left_out_if(!draft.has_photosynthesis),
            one_table(water_section(draft.water))
                .optional()
                .left_out_if(!draft.has_water),
            constraints_table(campaign.constraints), feasibility_table(draft)});
    append(run_tables(draft));
    append({list_of_tables("weather", weather_section, campaign.weathers)
                .optional()
                .at_most(most_entries)});
    return tables;
}

}  // namespace ideotype
