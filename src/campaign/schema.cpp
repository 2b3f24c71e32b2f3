// SPDX-License-Identifier: Apache-2.0
#include "schema.hpp"

#include <fmt/format.h>

namespace ideotype {

namespace {

//! The name of an entry, which is required if it has no initial one.
Key entry_name(std::string& name, const std::string& initial,
               const std::string& example) {
    Key key("name", &name, "part of the names of cases");
    key.like(example).set(&Key::range, name_range).set(&Key::initial, initial);
    key.is_required = initial.empty();
    return key;
}

Key distance(const std::string& name, double& value, const std::string& example,
             const std::string& meaning) {
    return Key(name, &value, meaning)
        .metres(0.02, 10, {{"centimetres", 0.01}, {"inches", 0.0254}})
        .required(example);
}

Key instant(const std::string& name, double& value, const std::string& example,
            const std::string& range, const std::string& meaning) {
    return Key(name, &value, meaning)
        .set(&Key::notation, Notation::clock)
        .set(&Key::range, range)
        .required(example);
}

Key fraction(const std::string& name, double& value,
             const std::string& meaning) {
    return Key(name, &value, meaning).within(0, 1);
}

Key path(const std::string& name, std::string& value,
         const std::string& meaning) {
    return Key(name, &value, meaning)
        .set(&Key::is_any_text, true)
        .set(&Key::type, "path")
        .like("\"weather/mine.csv\"")
        .set(&Key::range, "relative to this file")
        .set(&Key::initial, "none");
}

Section site_section(Site& site) {
    return {"site",
            {entry_name(site.name, "", R"("ames")"),
             Key("latitude", &site.latitude, "north is positive")
                 .within(-90, 90, "deg")
                 .required("42.0"),
             Key("longitude", &site.longitude, "east is positive")
                 .within(-180, 180, "deg")
                 .required("-93.6"),
             Key("utc_offset", &site.utc_offset,
                 "local clock minus UTC, with summer time")
                 .within(-12, 14, "h")
                 .required("-5"),
             Key("elevation", &site.elevation, "above sea level")
                 .within(-500, 9000, "m"),
             Key("linke_turbidity", &site.linke_turbidity,
                 "haze of the clear sky: 2 very clear, 7 hazy")
                 .within(1, 10),
             path("weather", site.weather,
                  "weather file of the site, if a climate has none")}};
}

constexpr auto date_range = "1950-01-01 .. 2100-12-31";

Section day_section(Named<DaySpan>& day) {
    DaySpan& span = day.value;
    return {"day",
            {entry_name(day.name, R"(month and day, "0807")", R"("0807")"),
             Key("date", &span.dates,
                 "fixes the sun's path; of several dates the mean day counts")
                 .set(&Key::range, date_range)
                 .required("2025-08-07"),
             instant("start", span.start, "07:00:00", "00:00:00 .. 23:59:59",
                     "first instant, on the local clock"),
             instant("end", span.end, "20:00:00", "after start, to \"24:00\"",
                     "last instant"),
             Key("step_minutes", &span.step_minutes,
                 "between instants; divides the time from start to end")
                 .within(1, 720, "min")
                 .trades({120, 60, 30, 15})}};
}

Key column(const std::string& name, std::optional<Column>& value,
           const std::string& unit, const std::string& meaning) {
    return Key(name, &value, meaning)
        .like(fmt::format("[\"{}\", \"{}\"]", name, unit))
        .set(&Key::initial, "none");
}

Section climate_section(Named<Climate>& named) {
    Climate& climate = named.value;
    ColumnMap& columns = climate.columns;
    const auto date = [](const std::string& name, Date& value,
                         const std::string& example,
                         const std::string& meaning) {
        return Key(name, &value, meaning)
            .set(&Key::range, date_range)
            .required(example);
    };
    const auto number =
        [](const std::string& name, std::optional<double>& value,
           const std::string& initial, const std::string& meaning) {
            return Key(name, &value, meaning).set(&Key::initial, initial);
        };
    const auto light = [](const std::string& name, std::optional<Column>& value,
                          const std::string& plane) {
        return column(name, value, "W/m2", "column and unit: light " + plane);
    };
    return {
        "climate",
        {entry_name(named.name, R"(months and days, "0721-0920")",
                    R"("season")"),
         path("file", climate.file,
              "weather file: what `ideotype weather` writes, or any CSV with "
              "the columns below"),
         date("from", climate.period.from, "2011-07-21", "first day"),
         date("to", climate.period.to, "2011-09-20", "last day"),
         Key("emergence", &climate.emergence,
             "day on which the plants of the crop emerge, which then grow and "
             "age by [growth] of its crop file until they are mature or the "
             "period ends; left out, they stand as they are")
             .set(&Key::range, date_range)
             .set(&Key::initial, "none")
             .like("2011-05-15")
             .set(&Key::is_written, climate.grows()),
         Key("stamp", &climate.stamp,
             "which part of its time step the time of a row is")
             .one_of({"beginning", "middle", "end"})
             .set(&Key::initial, "\"end\"; \"middle\" without time"),
         Key("time", &columns.time,
             "columns of date and time, or of date, and time, or of year, "
             "month, day, hour and, if there is one, minute")
             .set(&Key::range, "columns of the file")
             .set(&Key::initial, "what `ideotype weather` writes"),
         Key("date_order", choice(columns.date_order), "of dates in one text")
             .one_of({"year_month_day", "month_day_year", "day_month_year"}),
         number("utc_offset", columns.utc_offset, "that of the site",
                "of the file's clock, if its times have none")
             .within(-12, 14, "h"),
         number("missing", columns.missing, "none",
                "number that stands for what is not known, beside -99, -999, "
                "9999, NaN and the like"),
         light("global", columns.global, "on a horizontal plane"),
         light("beam_normal", columns.beam_normal,
               "of the sun on a plane that faces it"),
         light("diffuse", columns.diffuse, "of the sky on a horizontal plane"),
         column("diffuse_fraction", columns.diffuse_fraction, "1",
                "column and unit: diffuse over global light"),
         column("ppfd", columns.ppfd, "umol/m2/s",
                "column and unit: photons from 400 to 700 nm, which are only "
                "compared with the global light"),
         column("temperature", columns.temperature, "C",
                "column and unit: of the air"),
         column("humidity", columns.humidity, "%",
                "column and unit: relative humidity of the air"),
         column("wind", columns.wind, "m/s", "column and unit: wind speed"),
         number("wind_height", climate.wind_height, "10",
                "of the wind, above the ground")
             .within(0.5, 200, "m"),
         column("pressure", columns.pressure, "kPa",
                "column and unit: of the air"),
         column("longwave", columns.longwave, "W/m2",
                "column and unit: longwave radiation of the sky on a "
                "horizontal plane"),
         number("co2", climate.co2, "400", "of the air")
             .within(50, 5000, "umol mol-1")}};
}

Section weather_section(SiteWeather& weather) {
    const auto numbers =
        [](const std::string& name, std::vector<double>& values,
           const std::string& unit, const std::string& meaning) {
            return Key(name, &values, meaning)
                .set(&Key::unit, unit)
                .set(&Key::initial, "none")
                .like("[0, 0]");
        };
    const auto text = [](const std::string& name, std::string& value,
                         const std::string& meaning) {
        return Key(name, &value, meaning)
            .set(&Key::range, name_range)
            .required("\"ames\"");
    };
    return {"weather",
            {text("site", weather.site, "name of the site"),
             text("climate", weather.climate, "name of the climate"),
             text("sha256", weather.sha256, "of the file that was read"),
             Key("utc_offset", &weather.utc_offset, "of dates and hours")
                 .within(-12, 14, "h")
                 .required("-6"),
             Key("dates", &weather.dates,
                 "of the period, but for those that "
                 "the file leaves out")
                 .set(&Key::range, date_range)
                 .required("[2011-07-21]"),
             numbers("hours", weather.hours, "h",
                     "middles of the time steps of a day"),
             numbers("beam", weather.beam, "W m-2",
                     "PAR of the sun on a horizontal plane, date by date and "
                     "hour by hour"),
             numbers("diffuse", weather.diffuse, "W m-2", "PAR of the sky"),
             numbers("temperature", weather.temperature, "deg C", "of the air"),
             numbers("humidity", weather.humidity, "1",
                     "relative humidity of the air"),
             numbers("nir_beam", weather.nir_beam, "W m-2",
                     "near infrared of the sun on a horizontal plane, if it is "
                     "followed"),
             numbers("nir_diffuse", weather.nir_diffuse, "W m-2",
                     "near infrared of the sky, if it is followed"),
             numbers("wind", weather.wind, "m s-1", "speed, if it is known"),
             numbers("pressure", weather.pressure, "kPa",
                     "of the air, if it is known"),
             numbers("longwave", weather.longwave, "W m-2",
                     "longwave radiation of the sky, if it is known")}};
}

Section spacing_section(Named<Spacing>& spacing) {
    return {"spacing",
            {entry_name(spacing.name, R"(row x plant in mm, "762x152")",
                        R"("762x152")"),
             distance("row", spacing.value.row, "0.762",
                      "between neighbouring rows"),
             distance("plant", spacing.value.plant, "0.1524",
                      "between neighbours in a row")
                 .set(&Key::is_required, false)
                 .set(&Key::initial, "by `density`"),
             Key("density", &spacing.value.density,
                 "plants per ground area, in the place of `plant`")
                 .within(0.01, 1000, "m-2")
                 .set(&Key::initial, "by `plant`")
                 .set(&Key::is_written, false),
             Key("row_direction", &spacing.value.row_direction,
                 "clockwise from north; 90 is east-west")
                 .within(0, 360, "deg")}};
}

//! The names of the crop's traits, unless it could not be read.
std::vector<std::string> trait_names(const Draft& draft) {
    std::vector<std::string> known;
    if (draft.is_crop_known)
        for (const TraitEntry& each : draft.traits)
            known.push_back(each.trait.name);
    return known;
}

Section traits_section(const Draft& draft, Named<TraitSet>& traits) {
    Key free("free", &traits.value,
             "what may be bred; the rest keeps the baseline's values");
    free.set(&Key::range, "traits of the crop file")
        .one_of(trait_names(draft))
        .required(R"(["insertion_angle", "azimuth"])");
    // Components may be bred in the place of the crop.
    free.is_required = draft.components.empty();
    return {"traits", {entry_name(traits.name, "", R"("angles")"), free}};
}

Section field_section(FieldForm& field) {
    const std::vector<double> sizes{1, 2, 4, 6};
    const bool repeats = field.boundary == Boundary::periodic;
    return {"field",
            {Key("rows", &field.rows, "of the field")
                 .within(1, 100)
                 .trades(sizes, repeats),
             Key("plants", &field.plants, "per row")
                 .within(1, 100)
                 .trades(sizes, repeats),
             Key("row_pattern", &field.row_pattern,
                 "distances from each row to the next, over their mean, which "
                 "is `spacing.row`; they repeat: [1, 3] are twin rows")
                 .within(0.01, 100)
                 .set(&Key::count, any_count)
                 .set(&Key::type, "list of numbers")
                 .set(&Key::initial, "all alike")
                 .set(&Key::is_written, !field.row_pattern.empty())
                 .like("[1, 3]"),
             Key("boundary", choice(field.boundary),
                 "whether the field repeats without end or is a plot alone on "
                 "endless soil, lit from all sides")
                 .one_of({"periodic", "isolated"}),
             Key("border_rows", &field.border_rows,
                 "rows, and plants of each row, that are cut away on all "
                 "sides of an isolated plot")
                 .within(0, 49),
             Key("jitter", &field.jitter,
                 "largest random turn of each plant, either way")
                 .within(0, 180, "deg")}};
}

//! A standard deviation of an angle of leaves.
Key of_leaves(const std::string& name, LeafSpread& spread,
              const std::string& meaning, double most) {
    return Key(name, &spread, meaning)
        .within(0, most, "deg")
        .set(&Key::count, any_count)
        .set(&Key::type, "number or list")
        .set(&Key::initial, "0");
}

}  // namespace

Section variation_section(PlantVariation& variation, const std::string& name) {
    constexpr double largest = 0.3;  // three of them leave something
    return {
        name,
        {Key("length", &variation.length, "of each blade, relative")
             .within(0, largest),
         Key("width", &variation.width, "of each blade, relative")
             .within(0, largest),
         of_leaves("insertion_angle", variation.insertion_angle, "of each leaf",
                   30),
         of_leaves("curvature", variation.curvature,
                   "of each leaf: how far its tip bends down", 90),
         of_leaves("azimuth", variation.azimuth, "of each leaf", 60),
         of_leaves("roll", variation.roll,
                   "of each blade: turn about its midrib, halfway along", 90),
         of_leaves("twist", variation.twist,
                   "of each blade: turn about its midrib from the base to "
                   "the tip (Laplace distribution)",
                   180),
         Key("height", &variation.height,
             "of each plant, relative: stalk, sheaths, and where leaves "
             "begin")
             .within(0, largest),
         Key("across_row", &variation.across_row,
             "fraction of plants whose leaves point across the row, within "
             "45 deg; left out, plants stand as the baseline does, but for "
             "`field.jitter`")
             .within(0, 1)
             .set(&Key::initial, "as the baseline"),
         Key("missing", &variation.missing,
             "fraction of plants that there are not")
             .within(0, 0.5),
         Key("late", &variation.late, "fraction of plants that emerged late")
             .within(0, 0.5),
         Key("late_size", &variation.late_size,
             "all lengths of late plants over those of the others")
             .within(0.1, 1)}};
}

namespace {

//! @param band as it is called in the middle of a sentence
Section plant_optics_section(const std::string& name, PlantOptics& optics,
                             const std::string& band) {
    return {name,
            {fraction("leaf_reflectance", optics.leaf.reflectance,
                      "of both faces, in the " + band + " band"),
             fraction("leaf_transmittance", optics.leaf.transmittance,
                      "reflectance + transmittance <= 1"),
             fraction("stalk_reflectance", optics.stalk.reflectance,
                      "of the stalk's surface"),
             fraction("stalk_transmittance", optics.stalk.transmittance,
                      "reflectance + transmittance <= 1"),
             fraction("sheath_reflectance", optics.sheath.reflectance,
                      "of the surface of sheaths"),
             fraction("sheath_transmittance", optics.sheath.transmittance,
                      "reflectance + transmittance <= 1")}};
}

Section nir_section(Campaign& campaign) {
    return plant_optics_section("optics.nir", campaign.nir_optics,
                                "near infrared");
}

//! Puts a table of the near infrared into one of PAR.
Table with_nir(const Campaign& campaign, const Section& par,
               const Section& nir) {
    Table table = one_table(par), child = one_table(nir);
    child.name = "nir";
    child.is_optional = true;
    child.is_default = !campaign.has_nir;
    table.children = {child};
    return table;
}

Table optics_table(Campaign& campaign) {
    const std::string soil = "light that the soil sends back";
    Section par = plant_optics_section("optics", campaign.optics, "PAR");
    par.keys.push_back(fraction("soil_albedo", campaign.soil_albedo, soil));
    par.keys.push_back(
        Key("par_fraction", &campaign.par_fraction, "PAR over all solar energy")
            .within(0.01, 1));
    Section nir = nir_section(campaign);
    nir.keys.push_back(fraction("soil_albedo", campaign.nir_soil_albedo, soil));
    return with_nir(campaign, par, nir);
}

Table water_table(Draft& draft) {
    Table table = one_table(water_section(draft.water));
    table.is_optional = true;
    table.is_default = !draft.has_water;
    return table;
}

Table band_table(Campaign& campaign) {
    Table table = list_of_tables<BandEntry>(
        "band",
        [](BandEntry& band) -> Section {
            return {"band",
                    {Key("name", &band.name,
                         "waveband that light is followed in, beside PAR: near "
                         "infrared is the solar radiation beyond PAR")
                         .one_of({"par", "nir"})
                         .required("\"nir\"")}};
        },
        campaign.bands);
    table.is_optional = true;
    table.most = 2;
    return table;
}

Section component_section(Draft& component) {
    return {
        "component",
        {Key("name", &component.campaign.name,
             "of the kind of plant, as files and figures tell it")
             .set(&Key::range, name_range)
             .required("\"weed\""),
         Key("crop", {},
             "crop file of its plants, relative to the campaign file; or "
             "its content as [component.crop]")
             .set(&Key::type, "path or table")
             .set(&Key::range, "-")
             .required("\"crops/mine.toml\""),
         Key("free", &component.campaign.trait_sets.front().value,
             "what is bred of it; left out, it stays as its crop file has it")
             .set(&Key::range, "traits of its crop file")
             .set(&Key::initial, "[]")
             .like(R"(["width"])")
             .set(&Key::is_written,
                  !component.campaign.trait_sets.front().value.empty())
             .one_of(trait_names(component)),
         Key("bounds", component.rule.empty() ? Target{} : &component.rule,
             "as `plant.bounds`, of its own crop file; or [component.bounds]")
             .set(&Key::type, "text or table")
             .set(&Key::initial, "\"traits\"")
             .set(&Key::range, "rules of its crop file")
             .set(&Key::is_written, component.rule != "traits")
             .one_of(rule_names(component)),
         Key("variation", {},
             "how its plants differ, with the keys of [field.variation], in "
             "the place of those of the field; {} for plants that do not")
             .set(&Key::type, "table")
             .set(&Key::range, "-")
             .set(&Key::initial, "as the field"),
         Key("rows", &component.rows,
             "rows of the field that it stands in instead of the crop's "
             "plants, counted from 1")
             .within(1, 100)
             .set(&Key::count, any_count)
             .set(&Key::type, "list of integers")
             .set(&Key::initial, "none")
             .set(&Key::is_written, !component.rows.empty())
             .like("[2, 4]"),
         Key("mixed", &component.standing.mixed,
             "in the place of `rows`: so many of the places of plants "
             "that are bred, drawn anew for each generation")
             .within(0, 10000)
             .set(&Key::is_written, component.standing.mixed > 0),
         Key("plants", &component.standing.plants,
             "in each of its rows; 0: as many as `field.plants`")
             .within(0, 1000)
             .set(&Key::is_written, component.standing.plants > 0),
         Key("later", &component.standing.later,
             "how many days after `climate.emergence` it emerges")
             .within(0, 200, "d")
             .set(&Key::is_written, component.standing.later > 0),
         Key("jitter", &component.standing.jitter,
             "largest random turn of each of its plants, in the place of "
             "`field.jitter` and `field.variation.across_row`")
             .within(0, 180, "deg")
             .set(&Key::initial, "as the field")
             .set(&Key::is_written, component.standing.jitter.has_value())}};
}

Table component_table(Draft& draft) {
    std::vector<std::shared_ptr<Draft>>& all = draft.components;
    return {"component",
            [&all](std::size_t i) { return component_section(*all.at(i)); },
            [&all] { return all.size(); },
            [&all](std::size_t n) {
                while (all.size() < n) all.push_back(std::make_shared<Draft>());
            },
            {},
            false,
            true,
            most_components};
}

}  // namespace

Table plant_optics_table(Campaign& campaign) {
    return with_nir(campaign,
                    plant_optics_section("optics", campaign.optics, "PAR"),
                    nir_section(campaign));
}

Section top_section(Campaign& campaign) {
    return {"top",
            {Key("name", &campaign.name, "names the folder of the histories")
                 .set(&Key::range, name_range)
                 .required("\"ames\""),
             Key("seed", &campaign.seed, "of all random numbers")
                 .set(&Key::range, "0 .. 2^63-1"),
             Key("replicates", &campaign.replicates,
                 "evolutions with seeds of their own, per combination of the "
                 "axes")
                 .within(1, 1000)}};
}

std::vector<Table> climate_file_tables(Campaign& campaign) {
    std::vector<Table> tables;
    for (Section section : {site_section(campaign.sites.front()),
                            climate_section(campaign.climates.front())}) {
        section.keys.front().is_required = false;
        tables.push_back(one_table(section));
    }
    return tables;
}

Table field_table(FieldForm& field) {
    Table table = one_table(field_section(field));
    Table variation =
        one_table(variation_section(field.variation, "field.variation"));
    variation.name = "variation";
    variation.is_optional = true;
    variation.is_default = !field.variation.is_any();
    table.children = {variation};
    return table;
}

std::vector<Table> campaign_tables(Draft& draft) {
    Campaign& campaign = draft.campaign;
    Table sites = list_of_tables<Site>("site", site_section, campaign.sites);
    Table days =
        list_of_tables<Named<DaySpan>>("day", day_section, campaign.days);
    Table spacings = list_of_tables<Named<Spacing>>("spacing", spacing_section,
                                                    campaign.spacings);
    sites.most = days.most = spacings.most = most_entries;
    days.is_optional = draft.has_climate;
    Table climates = list_of_tables<Named<Climate>>("climate", climate_section,
                                                    campaign.climates);
    Table weathers = list_of_tables<SiteWeather>("weather", weather_section,
                                                 campaign.weathers);
    climates.is_optional = weathers.is_optional = true;
    weathers.most = most_entries;
    return {sites,
            days,
            climates,
            spacings,
            list_of_tables<Named<TraitSet>>(
                "traits",
                [&draft](Named<TraitSet>& traits) {
                    return traits_section(draft, traits);
                },
                campaign.trait_sets),
            field_table(campaign.field),
            plant_table(draft),
            component_table(draft),
            panel_table(campaign),
            object_table(campaign),
            band_table(campaign),
            optics_table(campaign),
            one_table(light_section(campaign)),
            one_table(objective_section(draft)),
            photosynthesis_table(draft),
            water_table(draft),
            constraints_table(campaign.constraints),
            feasibility_table(draft),
            search_table(draft),
            sensitivity_table(draft),
            one_table(stop_section(campaign.stop)),
            one_table(final_section(campaign.final_rule)),
            one_table(parallel_section(campaign.answer_limits)),
            weathers};
}

}  // namespace ideotype
