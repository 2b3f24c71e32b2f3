#include "schema.hpp"

namespace ideotype {

namespace {

constexpr auto required = Presence::required;

// Names end up in the names of files and as fixed-length text in them.
constexpr auto name_range = "at most 64 letters, digits, _ and -";

Key entry_name(std::string& name, const std::string& initial,
               const std::string& example) {
    return {.name = "name",
            .value = &name,
            .presence = initial.empty() ? required : Presence::optional,
            .example = example,
            .range = name_range,
            .initial = initial,
            .meaning = "part of the names of cases"};
}

std::vector<MistakenUnit> spacing_units() {
    std::vector<MistakenUnit> units = metric_units();
    units.push_back({"inches", 0.0254});
    return units;
}

}  // namespace

Key fraction(const std::string& name, double& value,
             const std::string& meaning) {
    return {.name = name,
            .value = &value,
            .lower = 0,
            .upper = 1,
            .meaning = meaning};
}

Section top_section(Campaign& campaign) {
    return {"top",
            {{.name = "name",
              .value = &campaign.name,
              .presence = required,
              .example = "\"ames\"",
              .range = name_range,
              .meaning = "names the folder of the histories"},
             {.name = "seed",
              .value = &campaign.seed,
              .range = "0 .. 2^63-1",
              .meaning = "of all random numbers"},
             {.name = "replicates",
              .value = &campaign.replicates,
              .lower = 1,
              .upper = 1000,
              .meaning = "evolutions with seeds of their own, per "
                         "combination of the axes"}}};
}

Section site_section(Site& site) {
    return {"site",
            {entry_name(site.name, "", R"("ames")"),
             {.name = "latitude",
              .value = &site.latitude,
              .presence = required,
              .unit = "deg",
              .lower = -90,
              .upper = 90,
              .example = "42.0",
              .meaning = "north is positive"},
             {.name = "longitude",
              .value = &site.longitude,
              .presence = required,
              .unit = "deg",
              .lower = -180,
              .upper = 180,
              .example = "-93.6",
              .meaning = "east is positive"},
             {.name = "utc_offset",
              .value = &site.utc_offset,
              .presence = required,
              .unit = "h",
              .lower = -12,
              .upper = 14,
              .example = "-5",
              .meaning = "local clock minus UTC, with summer time"},
             {.name = "elevation",
              .value = &site.elevation,
              .unit = "m",
              .lower = -500,
              .upper = 9000,
              .meaning = "above sea level"},
             {.name = "linke_turbidity",
              .value = &site.linke_turbidity,
              .lower = 1,
              .upper = 10,
              .meaning = "haze of the clear sky: 2 very clear, 7 hazy"}}};
}

Section day_section(Named<DaySpan>& day) {
    return {"day",
            {entry_name(day.name, R"(month and day, "0807")", R"("0807")"),
             {.name = "date",
              .value = &day.value.date,
              .presence = required,
              .example = "2025-08-07",
              .range = "1950-01-01 .. 2100-12-31",
              .meaning = "fixes the sun's path"},
             {.name = "start",
              .value = &day.value.start,
              .presence = required,
              .notation = Notation::clock,
              .example = "07:00:00",
              .range = "00:00:00 .. 23:59:59",
              .meaning = "first instant, on the local clock"},
             {.name = "end",
              .value = &day.value.end,
              .presence = required,
              .notation = Notation::clock,
              .example = "20:00:00",
              .range = "after start",
              .meaning = "last instant"},
             {.name = "step_minutes",
              .value = &day.value.step_minutes,
              .unit = "min",
              .lower = 1,
              .upper = 720,
              .meaning = "between instants; divides the time from start to "
                         "end"}}};
}

Section spacing_section(Named<Spacing>& spacing) {
    return {"spacing",
            {entry_name(spacing.name, R"(row x plant in mm, "762x152")",
                        R"("762x152")"),
             {.name = "row",
              .value = &spacing.value.row,
              .presence = required,
              .unit = "m",
              .mistaken = spacing_units(),
              .lower = 0.02,
              .upper = 10,
              .example = "0.762",
              .meaning = "between neighbouring rows"},
             {.name = "plant",
              .value = &spacing.value.plant,
              .presence = required,
              .unit = "m",
              .mistaken = spacing_units(),
              .lower = 0.02,
              .upper = 10,
              .example = "0.1524",
              .meaning = "between neighbours in a row"},
             {.name = "row_direction",
              .value = &spacing.value.row_direction,
              .unit = "deg",
              .lower = 0,
              .upper = 360,
              .meaning = "clockwise from north; 90 is east-west"}}};
}

Section traits_section(Named<TraitSet>& traits) {
    return {"traits",
            {entry_name(traits.name, "", R"("angles")"),
             {.name = "free",
              .value = &traits.value,
              .presence = required,
              .example = R"(["insertion_angle", "azimuth"])",
              .range = "any of length, width, insertion_angle, azimuth",
              .meaning = "what may be bred; the rest keeps the baseline's "
                         "values"}}};
}

Section field_section(FieldForm& field) {
    return {"field",
            {{.name = "rows",
              .value = &field.rows,
              .lower = 1,
              .upper = 100,
              .meaning = "of the field"},
             {.name = "plants",
              .value = &field.plants,
              .lower = 1,
              .upper = 100,
              .meaning = "per row"},
             {.name = "boundary",
              .value = &field.boundary,
              .choices = {"periodic", "isolated"},
              .meaning = "whether the field repeats without end or is a plot "
                         "alone on endless soil, lit from all sides"},
             {.name = "border_rows",
              .value = &field.border_rows,
              .lower = 0,
              .upper = 49,
              .meaning = "rows, and plants of each row, that are cut away on "
                         "all sides of an isolated plot"},
             {.name = "jitter",
              .value = &field.jitter,
              .unit = "deg",
              .lower = 0,
              .upper = 180,
              .meaning = "largest random turn of each plant, either way"}}};
}

Section optics_section(Campaign& campaign) {
    Optics& optics = campaign.optics;
    return {"optics",
            {fraction("leaf_reflectance", optics.leaf.reflectance,
                      "of both faces, in the PAR band"),
             fraction("leaf_transmittance", optics.leaf.transmittance,
                      "reflectance + transmittance <= 1"),
             fraction("stalk_reflectance", optics.stalk.reflectance,
                      "of the stalk's surface"),
             fraction("stalk_transmittance", optics.stalk.transmittance,
                      "reflectance + transmittance <= 1"),
             fraction("soil_albedo", optics.soil_albedo,
                      "light that the soil sends back"),
             {.name = "par_fraction",
              .value = &campaign.par_fraction,
              .lower = 0.01,
              .upper = 1,
              .meaning = "PAR over all solar energy"}}};
}

}  // namespace ideotype
