#include "schema.hpp"

namespace ideotype {

namespace {

// Wide enough for any crop plant; the campaign's bounds are narrower.

template <class Value>
Key length(Value& value, const std::string& example,
           const std::string& meaning) {
    return Key("length", &value, meaning).metres(0.01, 3).required(example);
}

template <class Value>
Key width(Value& value, const std::string& example,
          const std::string& meaning) {
    return Key("width", &value, meaning).metres(0.001, 0.5).required(example);
}

template <class Value>
Key insertion_angle(Value& value, const std::string& example,
                    const std::string& meaning) {
    return Key("insertion_angle", &value, meaning)
        .within(0, 90, "deg")
        .required(example);
}

Section stalk_section(StalkForm& stalk) {
    return {"stalk",
            {Key("height", &stalk.height, "above the soil").metres(0.05, 6),
             Key("diameter", &stalk.diameter, "the same at all heights")
                 .metres(0.001, 0.2)}};
}

Section blade_section(BladeForm& blade) {
    return {"blade",
            {Key("folding_angle", &blade.folding_angle,
                 "rise of each half from flat: the V of the blade")
                 .within(0, 80, "deg"),
             Key("curvature_exponent", &blade.curvature_exponent,
                 "angle at arc length s is insertion_angle + curvature "
                 "s^exponent")
                 .within(0.1, 10),
             Key("width_controls", &blade.width_controls,
                 "width from base to tip: control values of a cubic B-spline "
                 "with knots at 1/3 and 2/3, scaled to a maximum of 1")
                 .within(0, 2)
                 .set(&Key::count, 6)}};
}

Section leaf_section(LeafEntry& leaf) {
    return {"leaf",
            {length(leaf.traits.length, "0.651", "arc length of the midrib"),
             width(leaf.traits.width, "0.073", "largest width of the blade"),
             insertion_angle(leaf.traits.insertion_angle, "34",
                             "of the base from the stem; 90 is horizontal"),
             Key("curvature", &leaf.form.curvature,
                 "how much further the tip bends down")
                 .within(0, 180, "deg")
                 .required("90"),
             Key("azimuth", &leaf.traits.azimuth,
                 "about the stem; 0 is along the row")
                 .within(0, 360, "deg")
                 .required("90"),
             Key("insertion_height", &leaf.form.insertion_height,
                 "above the soil, at most the stalk's height")
                 .metres(0, 6)
                 .required("0.09")}};
}

}  // namespace

Section plant_section(Draft& draft) {
    Campaign& campaign = draft.campaign;
    return {"plant",
            {Key("baseline", {},
                 "plant file, relative to the campaign file; or its content "
                 "as [plant.baseline]")
                 .set(&Key::type, "path or table")
                 .set(&Key::range, "-")
                 .required("\"plants/b73.toml\""),
             Key("bounds",
                 draft.bounds.rule.empty() ? Target{} : &draft.bounds.rule,
                 "a rule, or its own values as [plant.bounds]")
                 .set(&Key::type, "text or table")
                 .one_of({"paper", "biological"}),
             Key("stalk", &campaign.plant.stalk.is_present,
                 "whether plants have stalks"),
             Key("cells_along", &campaign.tessellation.cells_along,
                 "faces along a leaf; there are two across")
                 .within(4, 200),
             Key("stalk_sides", &campaign.tessellation.stalk_sides,
                 "faces around a stalk")
                 .within(3, 100)}};
}

Section bounds_section(LeafBounds& bounds) {
    return {
        "plant.bounds",
        {length(bounds.length, "[0.4, 1.1]", "of every leaf"),
         width(bounds.width, "[0.05, 0.14]", "of every leaf"),
         insertion_angle(bounds.insertion_angle, "[10, 80]", "of every leaf")}};
}

Section plant_file_section(PlantForm& plant) {
    return {"plant file",
            {Key("name", &plant.name, "of the plant")
                 .set(&Key::range, name_range)
                 .required("\"b73\"")}};
}

std::vector<Table> plant_tables(Draft& draft) {
    PlantForm& plant = draft.campaign.plant;
    return {one_table(stalk_section(plant.stalk)),
            one_table(blade_section(plant.blade)),
            list_of_tables("leaf", leaf_section, draft.leaves)};
}

}  // namespace ideotype
