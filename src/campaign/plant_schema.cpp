// SPDX-License-Identifier: Apache-2.0
#include "ideotype/crop/measures.hpp"
#include "schema.hpp"

namespace ideotype {

namespace {

template <class Part>
void add_measure(Section& keys, const Measure<Part>& measure, Part& part) {
    const std::string unit = measure.unit;
    const auto& [least, most] = measure.limits;
    Key& key =
        keys.add(measure.name, part.*measure.value,
                 {least, most, unit == "1" ? "" : unit}, measure.meaning);
    if (unit == "m") key.in_metres();
}

template <class Part>
void add_measures(Section& keys, const auto& measures, Part& part) {
    for (const Measure<Part>& each : measures) add_measure(keys, each, part);
}

void add_presence(Section& keys, bool& value) {
    keys.add("present", value, "whether plants have it");
}

//! A part that a plant has once, or does not have.
template <class Part>
Section part_section(const std::string& name, const auto& measures,
                     Part& part) {
    Section keys{name};
    add_presence(keys, part.is_present);
    add_measures(keys, measures, part);
    return keys;
}

Section stalk_section(Stalk& stalk) {
    Section keys = part_section("stalk", stalk_measures, stalk);
    keys.add("leaf_base", stalk.leaf_base,
             {{"surface", LeafBase::surface}, {"axis", LeafBase::axis}},
             "where the midribs of leaves begin");
    return keys;
}

Section growth_section(Growth& growth) {
    Section keys{"growth"};
    const Bounds thermal_time{0, 5000, "deg C d"}, of_leaves{0.01, 0.99};
    keys.add("leaves", growth.leaves, {3, 40},
             "of the main stem; the plant's are the highest of them");
    keys.add("interval", growth.interval, thermal_time,
             "between the tips of successive leaves");
    keys.add("largest_area", growth.largest_area, {1e-5, 1, "m2"},
             "of the blade that is largest, one-sided");
    keys.add("largest", growth.largest, of_leaves,
             "rank of the largest blade over the leaves");
    keys.add("narrowing", growth.narrowing, {0, 100},
             "a of the area by rank, exp(-a x^2 + b x^3) with x = (n - m) / (m "
             "- 1) and m the rank of the largest");
    keys.add("skewness", growth.skewness, {-100, 100}, "b of the area by rank");
    keys.add("first_extension", growth.first_extension, thermal_time,
             "from tip to collar of the first leaf");
    keys.add("longest_extension", growth.longest_extension, thermal_time,
             "from tip to collar of the leaf that takes longest");
    keys.add("last_extension", growth.last_extension, thermal_time,
             "from tip to collar of the highest leaf");
    keys.add("slowest", growth.slowest, of_leaves,
             "rank of the leaf that takes longest over the leaves");
    keys.add("lower_leaves", growth.lower_leaves, of_leaves,
             "ranks up to it over the leaves die while the plant grows");
    keys.add("lower_death", growth.lower_death, thermal_time,
             "from emergence to the death of the lowest leaf");
    keys.add("lower_interval", growth.lower_interval, thermal_time,
             "between the deaths of lower leaves");
    keys.add("upper_death", growth.upper_death, thermal_time,
             "from silking to the death of the first upper leaf");
    keys.add("upper_interval", growth.upper_interval, thermal_time,
             "between the deaths of upper leaves");
    keys.add("fading", growth.fading, thermal_time,
             "from the death of a blade to its last green");
    keys.add("silking", growth.silking, thermal_time,
             "from as many intervals as there are leaves to silking");
    keys.add("maturity", growth.maturity, thermal_time,
             "from silking to maturity");
    keys.add("internode_rate", growth.internode_rate,
             {1e-5, 0.1, "m / (deg C d)"},
             "growth of an internode from the collar of its leaf on");
    keys.add("base", growth.base, {-5, 20, "deg C"},
             "temperature that thermal time is counted from");
    keys.add("cap", growth.cap, {20, 50, "deg C"},
             "temperature above which growth is no faster");
    return keys;
}

Section blade_section(Blade& blade) {
    Section keys{"blade"};
    add_measures(keys, blade_measures, blade);
    keys.add("leaflets", blade.leaflets, {1, 15}, "of each leaf");
    // A single blade has the first two.
    for (std::size_t i = 2; i < keys.keys.size(); ++i)
        keys.keys[i].written_if(blade.leaflets > 1);
    keys.add("width_controls", blade.width_controls, {0, 2},
             "width from base to tip: control values of a cubic B-spline with "
             "knots at 1/3 and 2/3, scaled to a maximum of 1")
        .count = 6;
    return keys;
}

Section organ_section(Organ& organ) {
    Section keys{"organ"};
    keys.add_name("name", organ.name, "of the organ").required("\"ear\"");
    add_presence(keys, organ.is_present);
    keys.add(
        "tissue", organ.material,
        {{"stalk", PlantMaterial::stalk}, {"sheath", PlantMaterial::sheath}},
        "whose optics its surface has");
    keys.add("leaf", organ.leaf, {0, most_leaves},
             "rank of the leaf at whose insertion it is; 0: the stalk's top");
    keys.add("count", organ.count, {1, 100},
             "of such cones, evenly around the stalk");
    keys.add("sides", organ.sides, {3, 24}, "faces around each");
    add_measures(keys, organ_measures, organ);
    for (Key& key : keys.keys) {
        if (key.name == "length") key.required("0.3");
        if (key.name == "base_diameter") key.required("0.01");
    }
    return keys;
}

Section leaf_section(Leaf& leaf) {
    Section keys{"leaf"};
    add_measures(keys, leaf_measures, leaf);
    const char* const examples[] = {"0.651", "0.073", "34", "90", "90", "0.09"};
    for (std::size_t i = 0; i < leaf_measures.size(); ++i) {
        Key& key = keys.keys[i];
        if (i < needed_leaf_measures)
            key.required(examples[i]);
        else  // Blades that are neither rolled nor twisted need not say so.
            key.written_if(leaf.*leaf_measures[i].value != 0);
        if (key.name == "insertion_angle" || key.name == "curvature")
            key.unless = "midrib";
        if (key.name == "insertion_height")
            key.written_if(leaf.internode == 0).unless = "internode";
    }
    keys.add("midrib", leaf.midrib,
             "points of the digitised midrib from base to tip, out from the "
             "stalk and up, in any unit; where it is told, insertion_angle and "
             "curvature follow from it, and may be told to bend it further")
        .allows("two points or more")
        .defaults("from insertion_angle and curvature");
    return keys;
}

Section trait_section(TraitEntry& entry) {
    Section keys{"trait"};
    Trait& trait = entry.trait;
    const auto add_measures = [&](const std::string& name,
                                  std::vector<std::string>& measures,
                                  const std::string& meaning) {
        keys.add(name, measures, meaning)
            .allows("measures of the plant")
            .like("[\"leaf.length\"]");
    };
    keys.add_name("name", trait.name, "of the trait").required("\"length\"");
    keys.add("per", trait.numbers,
             {{"leaf", TraitNumbers::leaf},
              {"plant", TraitNumbers::plant},
              {"profile", TraitNumbers::profile}},
             "whether each leaf has a number, the whole plant has one, or the "
             "points of a smooth curve over leaf position have");
    keys.add("points", trait.points, {1, 10},
             "of a profile, at equal distances from the lowest leaf to the "
             "highest");
    add_measures("sets", entry.sets, "the measure that is the number");
    add_measures("scales", entry.scales,
                 "the measures of the baseline that the number multiplies");
    add_measures("shifts", entry.shifts,
                 "the measures of the baseline that the number is added to");
    keys.add("unit", trait.unit,
             "of the number: that of the measures, \"1\" of a factor")
        .one_of({"m", "deg", "1"})
        .required("\"m\"");
    keys.add("range", trait.range, {-1000, 1000}, "in which it may be bred")
        .required("[0.4, 1.1]");
    keys.add("circular", trait.is_circular,
             "whether both ends of the range are the same direction");
    keys.add("bred", trait.is_bred,
             "whether campaigns that name no trait set breed it");
    return keys;
}

Section bounds_section(BoundsEntry& bounds) {
    Section keys{"bounds"};
    keys.add_name("name", bounds.rule, "that campaigns choose the bounds by")
        .required("\"paper\"");
    keys.add_name("trait", bounds.trait, "that the bounds are of")
        .required("\"length\"");
    keys.add("range", bounds.range, {-1000, 1000}, "in which it may be bred")
        .required("[0.4, 1.1]");
    keys.add("change", bounds.change, {0, 100},
             "largest change of the baseline's value, relative to it; 0: any");
    keys.add("bred", bounds.is_bred,
             "whether campaigns that choose these bounds, but name no trait "
             "set, breed it; if any of the rule is, no other traits are");
    return keys;
}

void add_own_bounds(Section& keys, const Trait& trait, Range& range,
                    Plant& plant) {
    const auto measure =
        trait.effect == TraitEffect::sets && !trait.measures.empty()
            ? find_measure(plant, trait.measures[0])
            : std::nullopt;
    const Bounds bounds = measure ? Bounds{measure->limits.lower,
                                           measure->limits.upper, measure->unit}
                                  : Bounds{-1000, 1000};
    Key& key = keys.add(trait.name, range, bounds, "of each of its numbers")
                   .like("[0.4, 1.1]");
    if (bounds.unit == "m") key.in_metres();
}

Section plant_section(Draft& draft) {
    Section keys{"plant"};
    Tessellation& faces = draft.campaign.tessellation;
    keys.add_by_hand("baseline", "path or table",
                     "crop file, relative to the campaign file; or its content "
                     "as [plant.baseline]")
        .required("\"crops/mine.toml\"");
    keys.add_rule(draft.rule, rule_names(draft),
                  "a rule of the crop file, \"traits\" for the ranges of its "
                  "traits, or own values as [plant.bounds]");
    keys.add("organs", draft.organs, "that plants have besides leaves")
        .allows(
            "of \"stalk\", \"sheath\", \"petiole\" and the crop file's "
            "[[organ]] tables")
        .defaults("those that the crop file has present")
        .one_of(all_organs(draft.campaign.crop.baseline));
    keys.add("cells_along", faces.cells_along, {4, 200},
             "faces along a leaf with two across; leaflets have two thirds as "
             "many, with four across")
        .trades({6, 8, 12, 16, 24});
    keys.add("stalk_sides", faces.stalk_sides, {3, 100},
             "faces around stalks and sheaths")
        .trades({3, 6, 12}, !draft.organs.empty());
    return keys;
}

}  // namespace

Table own_bounds_table(Draft& draft, const std::string& parent) {
    Section keys{parent + ".bounds"};
    for (std::size_t t = 0; t < draft.traits.size(); ++t)
        add_own_bounds(keys, complete(draft.traits[t]), draft.own_bounds.at(t),
                       draft.campaign.crop.baseline);
    Table table = one_table(keys);
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
    Section keys{"crop file"};
    keys.add_name("name", plant.name, "of the plant").required("\"b73\"");
    return keys;
}

std::vector<Table> crop_defaults(Draft& draft) {
    return {optics_table(draft.campaign, false).optional(),
            one_table(photosynthesis_section(draft.photosynthesis)).optional()};
}

std::vector<Table> plant_tables(Draft& draft) {
    Plant& plant = draft.campaign.crop.baseline;
    return {one_table(stalk_section(plant.stalk)),
            one_table(part_section("sheath", sheath_measures, plant.sheath)),
            one_table(part_section("petiole", petiole_measures, plant.petiole))
                .left_out_if(!has_petioles(plant)),
            one_table(blade_section(plant.blade)),
            one_table(growth_section(draft.growth))
                .optional()
                .left_out_if(!draft.has_growth),
            list_of_tables<Leaf>("leaf", leaf_section, plant.leaves)
                .at_most(most_leaves),
            list_of_tables<Organ>("organ", organ_section, plant.organs)
                .optional()
                .at_most(most_organs),
            list_of_tables<TraitEntry>("trait", trait_section, draft.traits)
                .at_most(most_traits),
            list_of_tables<BoundsEntry>("bounds", bounds_section, draft.bounds)
                .optional()};
}

}  // namespace ideotype
