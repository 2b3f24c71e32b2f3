// SPDX-License-Identifier: Apache-2.0
#include "ideotype/crop/measures.hpp"
#include "schema.hpp"

namespace ideotype {

namespace {

template <class Part>
void add_measures(Section& section, const auto& measures, Part& part) {
    for (const Measure<Part>& each : measures) {
        section.add(each.name, &(part.*each.value));
        if (section.keys.back().unit == "m") section.keys.back().in_metres();
    }
}

//! Adds the keys of a tissue, which are written if it is living.
template <class Part>
void add_tissue(Section& section, Part& part) {
    for (const Measure<Part>& each : tissue_measures<Part>) {
        section.add(each.name, &(part.*each.value));
        section.keys.back().written_if(part.is_living());
    }
}

//! Returns the section of a part that a plant has at most once.
template <class Part>
Section part_section(const std::string& name, const auto& measures,
                     Part& part) {
    Section section(name, {{"present", &part.is_present}});
    add_measures(section, measures, part);
    return section;
}

Section stalk_section(Stalk& stalk) {
    Section section = part_section("stalk", stalk_measures, stalk);
    add_tissue(section, stalk);
    section.add("leaf_base",
                choice(stalk.leaf_base, {{"surface", LeafBase::surface},
                                         {"axis", LeafBase::axis}}));
    return section;
}

Section sheath_section(Sheath& sheath) {
    Section section = part_section("sheath", sheath_measures, sheath);
    add_tissue(section, sheath);
    return section;
}

Section growth_section(Growth& growth) {
    Section section("growth", {{"leaves", &growth.leaves},
                               {"interval", &growth.interval},
                               {"largest_area", &growth.largest_area},
                               {"largest", &growth.largest},
                               {"narrowing", &growth.narrowing},
                               {"skewness", &growth.skewness},
                               {"first_extension", &growth.first_extension},
                               {"longest_extension", &growth.longest_extension},
                               {"last_extension", &growth.last_extension},
                               {"slowest", &growth.slowest},
                               {"lower_leaves", &growth.lower_leaves},
                               {"lower_death", &growth.lower_death},
                               {"lower_interval", &growth.lower_interval},
                               {"upper_death", &growth.upper_death},
                               {"upper_interval", &growth.upper_interval},
                               {"fading", &growth.fading},
                               {"silking", &growth.silking},
                               {"maturity", &growth.maturity},
                               {"internode_rate", &growth.internode_rate},
                               {"base", &growth.base},
                               {"cap", &growth.cap},
                               {"ageing", &growth.ageing},
                               {"maintenance", &growth.maintenance},
                               {"root_share", &growth.root_share},
                               {"ear_maintenance", &growth.ear_maintenance}});
    const Growth usual;
    section["ageing"].written_if(growth.ageing != usual.ageing);
    section["maintenance"].written_if(growth.maintenance != usual.maintenance);
    section["root_share"].written_if(growth.root_share > 0);
    section["ear_maintenance"].written_if(growth.ear_maintenance > 0);
    return section;
}

Section blade_section(Blade& blade) {
    Section section("blade", {});
    add_measures(section, blade_measures, blade);
    section.add("leaflets", &blade.leaflets);
    // A single blade has only the first two keys.
    for (std::size_t i = 2; i < section.keys.size(); ++i)
        section.keys[i].written_if(blade.leaflets > 1);
    section.add("width_controls", &blade.width_controls);
    section["width_controls"].count = 6;
    return section;
}

Section organ_section(Organ& organ) {
    Section section(
        "organ", {{"name", &organ.name},
                  {"present", &organ.is_present},
                  {"tissue",
                   choice(organ.material, {{"stalk", PlantMaterial::stalk},
                                           {"sheath", PlantMaterial::sheath}})},
                  {"leaf", &organ.leaf},
                  {"count", &organ.count},
                  {"sides", &organ.sides}});
    add_measures(section, organ_measures, organ);
    add_tissue(section, organ);
    section.add("senescence", &organ.senescence);
    section.keys.back().written_if(organ.senescence > 0);
    return section;
}

Section leaf_section(Leaf& leaf) {
    Section section("leaf", {});
    add_measures(section, leaf_measures, leaf);
    // Blades that are neither rolled nor twisted may leave these keys out.
    for (std::size_t i = needed_leaf_measures; i < leaf_measures.size(); ++i)
        section.keys[i].written_if(leaf.*leaf_measures[i].value != 0);
    for (const char* key : {"insertion_angle", "curvature"})
        section[key].unless = "midrib";
    section["insertion_height"].written_if(leaf.internode == 0).unless =
        "internode";
    section.add("midrib", &leaf.midrib);
    return section;
}

Section trait_section(TraitEntry& entry) {
    Trait& trait = entry.trait;
    Section section(
        "trait",
        {{"name", &trait.name},
         {"per", choice(trait.numbers, {{"leaf", TraitNumbers::leaf},
                                        {"plant", TraitNumbers::plant},
                                        {"profile", TraitNumbers::profile}})},
         {"points", &trait.points},
         {"sets", &entry.sets},
         {"scales", &entry.scales},
         {"shifts", &entry.shifts},
         {"unit", &trait.unit},
         {"range", &trait.range},
         {"circular", &trait.is_circular},
         {"bred", &trait.is_bred}});
    section["sets"].written_if(!entry.sets.empty());
    section["scales"].written_if(!entry.scales.empty());
    section["shifts"].written_if(!entry.shifts.empty());
    return section;
}

Section bounds_section(BoundsEntry& bounds) {
    return {"bounds",
            {{"name", &bounds.rule},
             {"trait", &bounds.trait},
             {"range", &bounds.range},
             {"change", &bounds.change},
             {"bred", &bounds.is_bred}}};
}

//! Returns the key for the bounds of a trait, in the range of its measure.
Key own_bounds_key(const Trait& trait, Range& range, Plant& plant) {
    Key key(trait.name, &range, key_info("plant.bounds", "TRAIT"));
    const auto measure =
        trait.effect == TraitEffect::sets && !trait.measures.empty()
            ? find_measure(plant, trait.measures[0])
            : std::nullopt;
    if (!measure) return key;
    key.lower = measure->limits.lower;
    key.upper = measure->limits.upper;
    key.unit = measure->unit;
    return key.unit == "m" ? key.in_metres() : key;
}

Section plant_section(Draft& draft) {
    Tessellation& faces = draft.campaign.tessellation;
    Section section("plant", {{"baseline", {}},
                              {"bounds", place_of_rule(draft)},
                              {"organs", &draft.organs},
                              {"stage", &draft.campaign.stage},
                              {"cells_along", &faces.cells_along},
                              {"stalk_sides", &faces.stalk_sides}});
    section["bounds"].one_of(rule_names(draft));
    section["organs"].one_of(all_organs(draft.campaign.crop.baseline));
    section["stage"].written_if(draft.campaign.stage != Campaign().stage);
    section["cells_along"].trades({6, 8, 12, 16, 24});
    section["stalk_sides"].trades({3, 6, 12}, !draft.organs.empty());
    return section;
}

}  // namespace

Target place_of_rule(Draft& draft) {
    return draft.rule.empty() ? Target{} : &draft.rule;
}

Table own_bounds_table(Draft& draft, const std::string& parent) {
    Section section(parent + ".bounds", {});
    for (std::size_t t = 0; t < draft.traits.size(); ++t)
        section.keys.push_back(own_bounds_key(complete(draft.traits[t]),
                                              draft.own_bounds.at(t),
                                              draft.campaign.crop.baseline));
    Table table = one_table(section);
    table.name = "bounds";
    return table;
}

Table plant_table(Draft& draft) {
    Table table = one_table(plant_section(draft));
    if (draft.rule.empty()) table.children = {own_bounds_table(draft, "plant")};
    return table;
}

std::vector<std::string> all_organs(const Plant& plant) {
    std::vector<std::string> names{"stalk", "sheath"};
    if (has_petioles(plant)) names.push_back("petiole");
    for (const Organ& organ : plant.organs) names.push_back(organ.name);
    return names;
}

Section plant_file_section(Plant& plant) {
    return {"crop file", {{"name", &plant.name}}};
}

std::vector<Table> crop_defaults(Draft& draft) {
    return {optics_table(draft.campaign, false).optional(),
            one_table(photosynthesis_section(draft.photosynthesis))
                .optional()
                .left_out_if(draft.leaf_files.empty())};
}

std::vector<Table> plant_tables(Draft& draft) {
    Plant& plant = draft.campaign.crop.baseline;
    return {
        one_table(stalk_section(plant.stalk)),
        one_table(sheath_section(plant.sheath)),
        one_table(part_section("petiole", petiole_measures, plant.petiole))
            .left_out_if(!has_petioles(plant)),
        one_table(blade_section(plant.blade)),
        one_table(growth_section(draft.growth))
            .optional()
            .left_out_if(!draft.has_growth),
        list_of_tables("leaf", leaf_section, plant.leaves).at_most(most_leaves),
        list_of_tables("organ", organ_section, plant.organs)
            .optional()
            .at_most(most_organs),
        list_of_tables("trait", trait_section, draft.traits)
            .at_most(most_traits),
        list_of_tables("bounds", bounds_section, draft.bounds).optional()};
}

}  // namespace ideotype
