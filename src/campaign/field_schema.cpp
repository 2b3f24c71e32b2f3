// SPDX-License-Identifier: Apache-2.0
#include "schema.hpp"

namespace ideotype {

namespace {

Section spacing_section(Named<Spacing>& named) {
    Section keys{"spacing"};
    Spacing& spacing = named.value;
    const auto add_distance = [&](const std::string& name, double& value,
                                  const std::string& meaning) -> Key& {
        return keys.add(name, value, {0.02, 10}, meaning)
            .in_metres({{"centimetres", 0.01}, {"inches", 0.0254}});
    };
    keys.add_name("name", named.name, "part of the names of cases")
        .defaults("row x plant in mm, \"762x152\"")
        .like("\"762x152\"");
    add_distance("row", spacing.row, "between neighbouring rows")
        .required("0.762");
    add_distance("plant", spacing.plant, "between neighbours in a row")
        .defaults("by `density`")
        .like("0.1524");
    keys.add("density", spacing.density, {0.01, 1000, "m-2"},
             "plants per ground area, in the place of `plant`")
        .defaults("by `plant`")
        .written_if(false);
    keys.add("row_direction", spacing.row_direction, {0, 360, "deg"},
             "clockwise from north; 90 is east-west");
    return keys;
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
    Section keys{"traits"};
    keys.add_name("name", traits.name, "part of the names of cases")
        .required("\"angles\"");
    // Components may be bred in the place of the crop.
    keys.add("free", traits.value,
             "what may be bred; the rest keeps the baseline's values")
        .allows("traits of the crop file")
        .one_of(trait_names(draft))
        .required("[\"insertion_angle\", \"azimuth\"]")
        .is_required = draft.components.empty();
    return keys;
}

Section field_section(FieldForm& field) {
    Section keys{"field"};
    const std::vector<double> sizes{1, 2, 4, 6};
    const bool repeats = field.boundary == Boundary::periodic;
    keys.add("rows", field.rows, {1, 100}, "of the field")
        .trades(sizes, repeats);
    keys.add("plants", field.plants, {1, 100}, "per row")
        .trades(sizes, repeats);
    keys.add("row_pattern", field.row_pattern, {0.01, 100},
             "distances from each row to the next, over their mean, which is "
             "`spacing.row`; they repeat: [1, 3] are twin rows")
        .optional_list("list of numbers", "all alike", "[1, 3]");
    keys.add(
        "boundary", field.boundary,
        {{"periodic", Boundary::periodic}, {"isolated", Boundary::isolated}},
        "whether the field repeats without end or is a plot alone on "
        "endless soil, lit from all sides");
    keys.add("border_rows", field.border_rows, {0, 49},
             "rows, and plants of each row, that are cut away on all sides of "
             "an isolated plot");
    keys.add("jitter", field.jitter, {0, 180, "deg"},
             "largest random turn of each plant, either way");
    return keys;
}

//! The optics of plants.
//! @param band as it is called in the middle of a sentence
Section plant_optics_section(const std::string& name, PlantOptics& optics,
                             const std::string& band) {
    Section keys{name};
    const auto add = [&](const std::string& part, Lambertian& surface,
                         const std::string& meaning) {
        keys.add(part + "_reflectance", surface.reflectance, {0, 1}, meaning);
        keys.add(part + "_transmittance", surface.transmittance, {0, 1},
                 "reflectance + transmittance <= 1");
    };
    add("leaf", optics.leaf, "of both faces, in the " + band + " band");
    add("stalk", optics.stalk, "of the stalk's surface");
    add("sheath", optics.sheath, "of the surface of sheaths");
    return keys;
}

Section band_section(BandEntry& band) {
    Section keys{"band"};
    keys.add("name", band.name,
             "waveband that light is followed in, beside PAR: near infrared is "
             "the solar radiation beyond PAR")
        .one_of({"par", "nir"})
        .required("\"nir\"");
    return keys;
}

Section component_section(Draft& component) {
    Section keys{"component"};
    Standing& standing = component.standing;
    TraitSet& free = component.campaign.trait_sets.front().value;
    keys.add_name("name", component.campaign.name,
                  "of the kind of plant, as files and figures tell it")
        .required("\"weed\"");
    keys.add_by_hand("crop", "path or table",
                     "crop file of its plants, relative to the campaign file; "
                     "or its content as [component.crop]")
        .required("\"crops/mine.toml\"");
    keys.add("free", free,
             "what is bred of it; left out, it stays as its crop file has it")
        .allows("traits of its crop file")
        .defaults("[]")
        .like("[\"width\"]")
        .written_if(!free.empty())
        .one_of(trait_names(component));
    keys.add_rule(component.rule, rule_names(component),
                  "as `plant.bounds`, of its own crop file; or "
                  "[component.bounds]")
        .allows("rules of its crop file")
        .written_if(component.rule != "traits");
    keys.add_by_hand("variation", "table",
                     "how its plants differ, with the keys of "
                     "[field.variation], in the place of those of the field; "
                     "{} for plants that do not")
        .defaults("as the field");
    keys.add("rows", component.rows, {1, 100},
             "rows of the field that it stands in instead of the crop's "
             "plants, counted from 1")
        .optional_list("list of integers", "none", "[2, 4]");
    keys.add("mixed", standing.mixed, {0, 10000},
             "in the place of `rows`: so many of the places of plants that are "
             "bred, drawn anew for each generation")
        .written_if(standing.mixed > 0);
    keys.add("plants", standing.plants, {0, 1000},
             "in each of its rows; 0: as many as `field.plants`")
        .written_if(standing.plants > 0);
    keys.add("later", standing.later, {0, 200, "d"},
             "how many days after `climate.emergence` it emerges")
        .written_if(standing.later > 0);
    keys.add("jitter", standing.jitter, {0, 180, "deg"},
             "largest random turn of each of its plants, in the place of "
             "`field.jitter` and `field.variation.across_row`")
        .defaults("as the field");
    return keys;
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
    Section keys{name};
    constexpr double largest = 0.3;  // three of them leave something
    //! Adds a standard deviation of an angle of leaves.
    const auto add_angle = [&](const std::string& angle, LeafSpread& spread,
                               double most, const std::string& meaning) {
        keys.add(angle, spread, {0, most, "deg"}, meaning)
            .or_list("number or list")
            .defaults("0");
    };
    keys.add("length", variation.length, {0, largest},
             "of each blade, relative");
    keys.add("width", variation.width, {0, largest}, "of each blade, relative");
    add_angle("insertion_angle", variation.insertion_angle, 30, "of each leaf");
    add_angle("curvature", variation.curvature, 90,
              "of each leaf: how far its tip bends down");
    add_angle("azimuth", variation.azimuth, 60, "of each leaf");
    add_angle("roll", variation.roll, 90,
              "of each blade: turn about its midrib, halfway along");
    add_angle("twist", variation.twist, 180,
              "of each blade: turn about its midrib from the base to the tip "
              "(Laplace distribution)");
    keys.add("height", variation.height, {0, largest},
             "of each plant, relative: stalk, sheaths, and where leaves begin");
    keys.add("across_row", variation.across_row, {0, 1},
             "fraction of plants whose leaves point across the row, within 45 "
             "deg; left out, plants stand as the baseline does, but for "
             "`field.jitter`")
        .defaults("as the baseline");
    keys.add("missing", variation.missing, {0, 0.5},
             "fraction of plants that there are not");
    keys.add("late", variation.late, {0, 0.5},
             "fraction of plants that emerged late");
    keys.add("late_size", variation.late_size, {0.1, 1},
             "all lengths of late plants over those of the others");
    return keys;
}

Table optics_table(Campaign& campaign, bool has_soil) {
    Section par = plant_optics_section("optics", campaign.optics, "PAR");
    Section nir = plant_optics_section("optics.nir", campaign.nir_optics,
                                       "near infrared");
    if (has_soil) {
        const std::string soil = "light that the soil sends back";
        par.add("soil_albedo", campaign.soil_albedo, {0, 1}, soil);
        par.add("par_fraction", campaign.par_fraction, {0.01, 1},
                "PAR over all solar energy");
        nir.add("soil_albedo", campaign.nir_soil_albedo, {0, 1}, soil);
    }
    return one_table(par).with(
        one_table(nir).optional().left_out_if(!campaign.has_nir), "nir");
}

std::vector<Table> campaign_tables(Draft& draft) {
    Campaign& campaign = draft.campaign;
    PlantVariation& variation = campaign.field.variation;
    Table days =
        list_of_tables<Named<DaySpan>>("day", day_section, campaign.days);
    days.is_optional = draft.has_climate;
    std::vector<Table> tables{
        list_of_tables<Site>("site", site_section, campaign.sites)
            .at_most(most_entries),
        days.at_most(most_entries),
        list_of_tables<Named<Climate>>("climate", climate_section,
                                       campaign.climates)
            .optional(),
        list_of_tables<Named<Spacing>>("spacing", spacing_section,
                                       campaign.spacings)
            .at_most(most_entries),
        list_of_tables<Named<TraitSet>>(
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
    append({list_of_tables<BandEntry>("band", band_section, campaign.bands)
                .optional()
                .at_most(2),
            optics_table(campaign, true)});
    append(measured_tables(draft));
    append({one_table(photosynthesis_section(draft.photosynthesis))
                .left_out_if(!draft.has_photosynthesis),
            one_table(water_section(draft.water))
                .optional()
                .left_out_if(!draft.has_water),
            constraints_table(campaign.constraints), feasibility_table(draft)});
    append(run_tables(draft));
    append({list_of_tables<SiteWeather>("weather", weather_section,
                                        campaign.weathers)
                .optional()
                .at_most(most_entries)});
    return tables;
}

}  // namespace ideotype
