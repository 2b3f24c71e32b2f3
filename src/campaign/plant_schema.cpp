#include "schema.hpp"

namespace ideotype {

namespace {

constexpr auto required = Presence::required;

// Wide enough for any crop plant; the campaign's bounds are narrower.
constexpr Range any_length{0.01, 3};
constexpr Range any_width{0.001, 0.5};
constexpr Range any_insertion_angle{0, 90};

}  // namespace

std::vector<MistakenUnit> metric_units() {
    return {{"centimetres", 0.01}};
}

Section plant_section(Draft& draft) {
    Campaign& campaign = draft.campaign;
    return {"plant",
            {{.name = "baseline",
              .value = {},
              .presence = required,
              .example = "\"plants/b73.toml\"",
              .type = "path or table",
              .range = "-",
              .meaning = "plant file, relative to the campaign file; or its "
                         "content as [plant.baseline]"},
             {.name = "bounds",
              .value = &draft.bounds.rule,
              .choices = {"paper", "biological"},
              .type = "text or table",
              .meaning = "a rule, or its own values as [plant.bounds]"},
             {.name = "stalk",
              .value = &campaign.plant.stalk.is_present,
              .meaning = "whether plants have stalks"},
             {.name = "cells_along",
              .value = &campaign.tessellation.cells_along,
              .lower = 4,
              .upper = 200,
              .meaning = "faces along a leaf; there are two across"},
             {.name = "stalk_sides",
              .value = &campaign.tessellation.stalk_sides,
              .lower = 3,
              .upper = 100,
              .meaning = "faces around a stalk"}}};
}

Section bounds_section(LeafBounds& bounds) {
    return {"plant.bounds",
            {{.name = "length",
              .value = &bounds.length,
              .presence = required,
              .unit = "m",
              .mistaken = metric_units(),
              .lower = any_length.lower,
              .upper = any_length.upper,
              .example = "[0.4, 1.1]",
              .meaning = "of every leaf"},
             {.name = "width",
              .value = &bounds.width,
              .presence = required,
              .unit = "m",
              .mistaken = metric_units(),
              .lower = any_width.lower,
              .upper = any_width.upper,
              .example = "[0.05, 0.14]",
              .meaning = "of every leaf"},
             {.name = "insertion_angle",
              .value = &bounds.insertion_angle,
              .presence = required,
              .unit = "deg",
              .lower = any_insertion_angle.lower,
              .upper = any_insertion_angle.upper,
              .example = "[10, 80]",
              .meaning = "of every leaf"}}};
}

Section plant_file_section(PlantForm& plant) {
    return {"plant file",
            {{.name = "name",
              .value = &plant.name,
              .presence = required,
              .example = "\"b73\"",
              .range = "at most 64 letters, digits, _ and -",
              .meaning = "of the plant"}}};
}

Section stalk_section(StalkForm& stalk) {
    return {"stalk",
            {{.name = "height",
              .value = &stalk.height,
              .unit = "m",
              .mistaken = metric_units(),
              .lower = 0.05,
              .upper = 6,
              .meaning = "above the soil"},
             {.name = "diameter",
              .value = &stalk.diameter,
              .unit = "m",
              .mistaken = metric_units(),
              .lower = 0.001,
              .upper = 0.2,
              .meaning = "the same at all heights"}}};
}

Section blade_section(BladeForm& blade) {
    return {"blade",
            {{.name = "folding_angle",
              .value = &blade.folding_angle,
              .unit = "deg",
              .lower = 0,
              .upper = 80,
              .meaning = "rise of each half from flat: the V of the blade"},
             {.name = "curvature_exponent",
              .value = &blade.curvature_exponent,
              .lower = 0.1,
              .upper = 10,
              .meaning = "angle at arc length s is insertion_angle + curvature "
                         "s^exponent"},
             {.name = "width_controls",
              .value = &blade.width_controls,
              .lower = 0,
              .upper = 2,
              .count = 6,
              .meaning = "width from base to tip: control values of a cubic "
                         "B-spline with knots at 1/3 and 2/3, scaled to a "
                         "maximum of 1"}}};
}

Section leaf_section(LeafEntry& leaf) {
    return {"leaf",
            {{.name = "length",
              .value = &leaf.traits.length,
              .presence = required,
              .unit = "m",
              .mistaken = metric_units(),
              .lower = any_length.lower,
              .upper = any_length.upper,
              .example = "0.651",
              .meaning = "arc length of the midrib"},
             {.name = "width",
              .value = &leaf.traits.width,
              .presence = required,
              .unit = "m",
              .mistaken = metric_units(),
              .lower = any_width.lower,
              .upper = any_width.upper,
              .example = "0.073",
              .meaning = "largest width of the blade"},
             {.name = "insertion_angle",
              .value = &leaf.traits.insertion_angle,
              .presence = required,
              .unit = "deg",
              .lower = any_insertion_angle.lower,
              .upper = any_insertion_angle.upper,
              .example = "34",
              .meaning = "of the base from the stem; 90 is horizontal"},
             {.name = "curvature",
              .value = &leaf.form.curvature,
              .presence = required,
              .unit = "deg",
              .lower = 0,
              .upper = 180,
              .example = "90",
              .meaning = "how much further the tip bends down"},
             {.name = "azimuth",
              .value = &leaf.traits.azimuth,
              .presence = required,
              .unit = "deg",
              .lower = 0,
              .upper = 360,
              .example = "90",
              .meaning = "about the stem; 0 is along the row"},
             {.name = "insertion_height",
              .value = &leaf.form.insertion_height,
              .presence = required,
              .unit = "m",
              .mistaken = metric_units(),
              .lower = 0,
              .upper = 6,
              .example = "0.09",
              .meaning = "above the soil, at most the stalk's height"}}};
}

}  // namespace ideotype
