// SPDX-License-Identifier: Apache-2.0
#include "ideotype/crop/measures.hpp"
#include "schema.hpp"

namespace ideotype {

namespace {

template <class Part>
Key measure_key(const Measure<Part>& measure, Part& part) {
    const auto& [least, most] = measure.limits;
    Key key(measure.name, &(part.*measure.value), measure.meaning);
    const std::string unit = measure.unit;
    if (unit == "m") return key.metres(least, most);
    return key.within(least, most, unit == "1" ? "" : unit);
}

template <class Part, std::size_t count>
std::vector<Key> measure_keys(const std::array<Measure<Part>, count>& measures,
                              Part& part) {
    std::vector<Key> keys;
    for (const Measure<Part>& each : measures)
        keys.push_back(measure_key(each, part));
    return keys;
}

Key presence(bool& value) {
    return Key("present", &value, "whether plants have it");
}

Section stalk_section(Stalk& stalk) {
    Section section{"stalk", measure_keys(stalk_measures, stalk)};
    section.keys.insert(section.keys.begin(), presence(stalk.is_present));
    section.keys.push_back(Key("leaf_base", choice(stalk.leaf_base),
                               "where the midribs of leaves begin")
                               .one_of({"surface", "axis"}));
    return section;
}

Section sheath_section(Sheath& sheath) {
    Section section{"sheath", measure_keys(sheath_measures, sheath)};
    section.keys.insert(section.keys.begin(), presence(sheath.is_present));
    return section;
}

//! The table is not written of plants that have no petiole.
Table petiole_table(Plant& plant) {
    Section section{"petiole", measure_keys(petiole_measures, plant.petiole)};
    section.keys.insert(section.keys.begin(),
                        presence(plant.petiole.is_present));
    Table table = one_table(section);
    table.is_default = !has_petioles(plant);
    return table;
}

Key thermal_time(const std::string& name, double& value,
                 const std::string& meaning) {
    return Key(name, &value, meaning).within(0, 5000, "deg C d");
}

Key fraction_of_leaves(const std::string& name, double& value,
                       const std::string& meaning) {
    return Key(name, &value, meaning).within(0.01, 0.99);
}

Section growth_section(Growth& growth) {
    return {
        "growth",
        {Key("leaves", &growth.leaves,
             "of the main stem; the plant's are the highest of them")
             .within(3, 40),
         thermal_time("interval", growth.interval,
                      "between the tips of successive leaves"),
         Key("largest_area", &growth.largest_area,
             "of the blade that is largest, one-sided")
             .within(1e-5, 1, "m2"),
         fraction_of_leaves("largest", growth.largest,
                            "rank of the largest blade over the leaves"),
         Key("narrowing", &growth.narrowing,
             "a of the area by rank, exp(-a x^2 + b x^3) with x = (n - m) / "
             "(m - 1) and m the rank of the largest")
             .within(0, 100),
         Key("skewness", &growth.skewness, "b of the area by rank")
             .within(-100, 100),
         thermal_time("first_extension", growth.first_extension,
                      "from tip to collar of the first leaf"),
         thermal_time("longest_extension", growth.longest_extension,
                      "from tip to collar of the leaf that takes longest"),
         thermal_time("last_extension", growth.last_extension,
                      "from tip to collar of the highest leaf"),
         fraction_of_leaves("slowest", growth.slowest,
                            "rank of the leaf that takes longest over the "
                            "leaves"),
         fraction_of_leaves("lower_leaves", growth.lower_leaves,
                            "ranks up to it over the leaves die while the "
                            "plant grows"),
         thermal_time("lower_death", growth.lower_death,
                      "from emergence to the death of the lowest leaf"),
         thermal_time("lower_interval", growth.lower_interval,
                      "between the deaths of lower leaves"),
         thermal_time("upper_death", growth.upper_death,
                      "from silking to the death of the first upper leaf"),
         thermal_time("upper_interval", growth.upper_interval,
                      "between the deaths of upper leaves"),
         thermal_time("fading", growth.fading,
                      "from the death of a blade to its last green"),
         thermal_time("silking", growth.silking,
                      "from as many intervals as there are leaves to silking"),
         thermal_time("maturity", growth.maturity, "from silking to maturity"),
         Key("internode_rate", &growth.internode_rate,
             "growth of an internode from the collar of its leaf on")
             .within(1e-5, 0.1, "m / (deg C d)"),
         Key("base", &growth.base,
             "temperature that thermal time is counted from")
             .within(-5, 20, "deg C"),
         Key("cap", &growth.cap, "temperature above which growth is no faster")
             .within(20, 50, "deg C")}};
}

Section blade_section(Blade& blade) {
    Section section{"blade", measure_keys(blade_measures, blade)};
    section.keys.push_back(
        Key("leaflets", &blade.leaflets, "of each leaf").within(1, 15));
    // A single blade has the first two.
    for (std::size_t i = 2; i < section.keys.size(); ++i)
        section.keys[i].is_written = blade.leaflets > 1;
    section.keys.push_back(
        Key("width_controls", &blade.width_controls,
            "width from base to tip: control values of a cubic B-spline "
            "with knots at 1/3 and 2/3, scaled to a maximum of 1")
            .within(0, 2)
            .set(&Key::count, 6));
    return section;
}

//! The material of an organ that is no leaf.
Choice material_choice(PlantMaterial& material) {
    return {
        &material,
        [](const void* from) {
            return static_cast<std::size_t>(*static_cast<const PlantMaterial*>(
                                                from) == PlantMaterial::sheath);
        },
        [](void* to, std::size_t position) {
            *static_cast<PlantMaterial*>(to) =
                position == 0 ? PlantMaterial::stalk : PlantMaterial::sheath;
        }};
}

Section organ_section(Organ& organ) {
    Section section{
        "organ",
        {Key("name", &organ.name, "of the organ")
             .set(&Key::range, name_range)
             .required("\"ear\""),
         presence(organ.is_present),
         Key("tissue", material_choice(organ.material),
             "whose optics its surface has")
             .one_of({"stalk", "sheath"}),
         Key("leaf", &organ.leaf,
             "rank of the leaf at whose insertion it is; 0: the stalk's top")
             .within(0, most_leaves),
         Key("count", &organ.count, "of such cones, evenly around the stalk")
             .within(1, 100),
         Key("sides", &organ.sides, "faces around each").within(3, 24)}};
    for (Key& key : measure_keys(organ_measures, organ)) {
        if (key.name == "length") key.required("0.3");
        if (key.name == "base_diameter") key.required("0.01");
        section.keys.push_back(key);
    }
    return section;
}

Section leaf_section(Leaf& leaf) {
    Section section{"leaf", measure_keys(leaf_measures, leaf)};
    section.keys.push_back(
        Key("midrib", &leaf.midrib,
            "points of the digitised midrib from base to tip, out from the "
            "stalk and up, in any unit; where it is told, insertion_angle and "
            "curvature follow from it, and may be told to bend it further")
            .set(&Key::range, "two points or more")
            .set(&Key::initial, "from insertion_angle and curvature"));
    const auto examples = {"0.651", "0.073", "34", "90", "90", "0.09"};
    auto example = examples.begin();
    for (std::size_t i = 0; i < leaf_measures.size(); ++i) {
        Key& key = section.keys[i];
        if (i < needed_leaf_measures)
            key.required(*example++);
        else  // Blades that are neither rolled nor twisted need not say so.
            key.is_written = leaf.*leaf_measures[i].value != 0;
        if (key.name == "insertion_angle" || key.name == "curvature")
            key.set(&Key::unless, "midrib");
        if (key.name == "insertion_height")
            key.set(&Key::unless, "internode").is_written = leaf.internode == 0;
    }
    return section;
}

Key acts(const std::string& name, std::vector<std::string>& measures,
         const std::string& meaning) {
    return Key(name, &measures, meaning)
        .set(&Key::range, "measures of the plant")
        .like("[\"leaf.length\"]");
}

Section trait_section(TraitEntry& entry) {
    Trait& trait = entry.trait;
    return {"trait",
            {Key("name", &trait.name, "of the trait")
                 .set(&Key::range, name_range)
                 .required("\"length\""),
             Key("per", choice(trait.numbers),
                 "whether each leaf has a number, the whole plant has one, or "
                 "the points of a smooth curve over leaf position have")
                 .one_of({"leaf", "plant", "profile"}),
             Key("points", &trait.points,
                 "of a profile, at equal distances from the lowest leaf to the "
                 "highest")
                 .within(1, 10),
             acts("sets", entry.sets, "the measure that is the number"),
             acts("scales", entry.scales,
                  "the measures of the baseline that the number multiplies"),
             acts("shifts", entry.shifts,
                  "the measures of the baseline that the number is added to"),
             Key("unit", &trait.unit,
                 "of the number: that of the measures, \"1\" of a factor")
                 .one_of({"m", "deg", "1"})
                 .required("\"m\""),
             Key("range", &trait.range, "in which it may be bred")
                 .within(-1000, 1000)
                 .required("[0.4, 1.1]"),
             Key("circular", &trait.is_circular,
                 "whether both ends of the range are the same direction"),
             Key("bred", &trait.is_bred,
                 "whether campaigns that name no trait set breed it")}};
}

Section bounds_entry_section(BoundsEntry& bounds) {
    return {"bounds",
            {Key("name", &bounds.rule, "that campaigns choose the bounds by")
                 .set(&Key::range, name_range)
                 .required("\"paper\""),
             Key("trait", &bounds.trait, "that the bounds are of")
                 .set(&Key::range, name_range)
                 .required("\"length\""),
             Key("range", &bounds.range, "in which it may be bred")
                 .within(-1000, 1000)
                 .required("[0.4, 1.1]"),
             Key("change", &bounds.change,
                 "largest change of the baseline's value, relative to it; 0: "
                 "any")
                 .within(0, 100),
             Key("bred", &bounds.is_bred,
                 "whether campaigns that choose these bounds, but name no "
                 "trait set, breed it; if any of the rule is, no other traits "
                 "are")}};
}

Key own_bounds_key(const Trait& trait, Range& range, Plant& plant) {
    Key key(trait.name, &range, "of each of its numbers");
    key.like("[0.4, 1.1]");
    if (trait.effect != TraitEffect::sets || trait.measures.empty())
        return key.within(-1000, 1000);
    const auto measure = find_measure(plant, trait.measures[0]);
    if (!measure) return key.within(-1000, 1000);
    const auto& [least, most] = measure->limits;
    return measure->unit == "m" ? key.metres(least, most)
                                : key.within(least, most, measure->unit);
}

}  // namespace

Table own_bounds_table(Draft& draft, const std::string& parent) {
    Section section{parent + ".bounds", {}};
    for (std::size_t t = 0; t < draft.traits.size(); ++t)
        section.keys.push_back(own_bounds_key(complete(draft.traits[t]),
                                              draft.own_bounds.at(t),
                                              draft.campaign.crop.baseline));
    Table table = one_table(section);
    table.name = "bounds";
    return table;
}

namespace {

Section plant_section(Draft& draft) {
    Campaign& campaign = draft.campaign;
    return {"plant",
            {Key("baseline", {},
                 "crop file, relative to the campaign file; or its content "
                 "as [plant.baseline]")
                 .set(&Key::type, "path or table")
                 .set(&Key::range, "-")
                 .required("\"crops/mine.toml\""),
             Key("bounds", draft.rule.empty() ? Target{} : &draft.rule,
                 "a rule of the crop file, \"traits\" for the ranges of its "
                 "traits, or own values as [plant.bounds]")
                 .set(&Key::type, "text or table")
                 .set(&Key::initial, "\"traits\"")
                 .one_of(rule_names(draft)),
             Key("organs", &draft.organs, "that plants have besides leaves")
                 .set(&Key::range,
                      "of \"stalk\", \"sheath\", \"petiole\" and the crop "
                      "file's [[organ]] tables")
                 .set(&Key::initial, "those that the crop file has present")
                 .one_of(all_organs(draft.campaign.crop.baseline)),
             Key("cells_along", &campaign.tessellation.cells_along,
                 "faces along a leaf with two across; leaflets have two thirds "
                 "as many, with four across")
                 .within(4, 200)
                 .trades({6, 8, 12, 16, 24}),
             Key("stalk_sides", &campaign.tessellation.stalk_sides,
                 "faces around stalks and sheaths")
                 .within(3, 100)
                 .trades({3, 6, 12}, !draft.organs.empty())}};
}

}  // namespace

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
    return {"crop file",
            {Key("name", &plant.name, "of the plant")
                 .set(&Key::range, name_range)
                 .required("\"b73\"")}};
}

std::vector<Table> crop_defaults(Draft& draft) {
    std::vector<Table> tables{
        plant_optics_table(draft.campaign),
        one_table(photosynthesis_section(draft.photosynthesis))};
    for (Table& table : tables) table.is_optional = true;
    return tables;
}

std::vector<Table> plant_tables(Draft& draft) {
    Plant& plant = draft.campaign.crop.baseline;
    Table leaves = list_of_tables<Leaf>("leaf", leaf_section, plant.leaves);
    Table organs = list_of_tables<Organ>("organ", organ_section, plant.organs);
    Table traits =
        list_of_tables<TraitEntry>("trait", trait_section, draft.traits);
    Table bounds = list_of_tables<BoundsEntry>("bounds", bounds_entry_section,
                                               draft.bounds);
    organs.is_optional = bounds.is_optional = true;
    Table growth = one_table(growth_section(draft.growth));
    growth.is_optional = true;
    growth.is_default = !draft.has_growth;
    leaves.most = most_leaves;
    organs.most = most_organs;
    traits.most = most_traits;
    return {one_table(stalk_section(plant.stalk)),
            one_table(sheath_section(plant.sheath)),
            petiole_table(plant),
            one_table(blade_section(plant.blade)),
            growth,
            leaves,
            organs,
            traits,
            bounds};
}

}  // namespace ideotype
