// SPDX-License-Identifier: Apache-2.0
#include "checks.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "campaign/leaves.hpp"
#include "spec/tables.hpp"
#include "spec/writer.hpp"

namespace ideotype {

void check_surface(const std::string& prefix, const Lambertian& surface,
                   double limit, const Problems& problems) {
    const std::string transmittance = prefix + "transmittance";
    // The sum of decimal fractions such as 0.7 and 0.3 may exceed 1 by
    // rounding.
    problems.rule({transmittance, prefix + "reflectance"},
                  surface.scattered() > limit + 1e-12,
                  "{} is {} (with the reflectance of {} that is more than {} % "
                  "of the light); use {} or less for both together",
                  transmittance, surface.transmittance, surface.reflectance,
                  100 * limit, limit);
}

void check_plant_optics(const ByBand<PlantOptics>& optics,
                        const Problems& problems) {
    for (std::size_t b = 0; b < wavebands.size(); ++b) {
        const std::string table = wavebands[b].table;
        check_surface(table + ".leaf_", optics[b].leaf, 1, problems);
        check_surface(table + ".stalk_", optics[b].stalk, 1, problems);
        check_surface(table + ".sheath_", optics[b].sheath, 1, problems);
    }
}

std::vector<ObjectiveKey> objective_keys(const Spec& spec) {
    std::vector<ObjectiveKey> keys;
    for (const std::string& each : spec.objective.maximised)
        keys.push_back({"objective.maximise", each});
    for (const std::string& each : spec.objective.minimised)
        keys.push_back({"objective.minimise", each});
    return keys;
}

namespace {

template <class Entry>
void check_names(const std::string& axis, const std::vector<Entry>& entries,
                 const Problems& problems) {
    // Names are compared in lower case, since they become file names.
    std::map<std::string, int> lines;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const Problems of_entry = problems.in(axis, i);
        const auto fault = [&]() -> std::string {
            const auto [earlier, is_new] = lines.emplace(
                lower_case(entries[i].name), of_entry.where("name").line);
            return is_new ? ""
                          : fmt::format(
                                "{}.name is \"{}\" (already used in line {}); "
                                "give each a different name",
                                axis, entries[i].name, earlier->second);
        };
        of_entry.rule({"name"}, fault, ProblemCode::duplicate);
    }
}

//! Returns the number of cases. It may be too large for an integer.
double number_of_cases(const Spec& spec) {
    double count = spec.replicates;
    const auto multiply = [&](const std::string& axis, std::size_t entries) {
        if (!is_over(spec, axis)) count *= static_cast<double>(entries);
    };
    multiply("site", spec.sites.size());
    multiply("day", spec.days.size() + spec.climates.size());
    multiply("spacing", spec.spacings.size());
    multiply("traits", spec.trait_sets.size());
    return count;
}

//! Reports cases with equal names. They are possible because names of entries,
//! which are joined by underscores, may also contain underscores.
void check_case_names(const Spec& spec, const Problems& problems) {
    std::set<std::string> names;
    // Check only the first replicate of each case, since names of replicates
    // always differ.
    const auto step = static_cast<std::size_t>(spec.replicates);
    for (std::size_t i = 0; i < count_cases(spec); i += step) {
        const CaseName chosen = case_name(spec, i);
        if (names.insert(chosen.name).second) continue;
        const auto named =
            std::ranges::find(spec.sites, chosen.site_name, &Site::name);
        const auto site = static_cast<std::size_t>(named - spec.sites.begin());
        return problems.in("site", site)
            .add("name", ProblemCode::duplicate,
                 "site.name is \"{}\" (two cases would be called {}, by the "
                 "names of all axes); rename one of the entries",
                 named->name, chosen.name);
    }
}

void check_spacing(const Spacing& spacing, const Problems& problems) {
    // Larger spacings are unusual for any crop [m].
    constexpr double usual = 2;
    for (const auto& [name, value] :
         {std::pair("row", spacing.row), std::pair("plant", spacing.plant)})
        problems.doubt({name}, value > usual,
                       "spacing.{} is {} m (crops stand closer; {} inches are "
                       "{:.4g} m, {} feet {:.4g} m); give metres",
                       name, value, value, value * 0.0254, value,
                       value * 0.3048);
    problems.rule(ProblemCode::missing, {"row", "plant", "density"},
                  !(spacing.plant > 0),
                  "missing key 'plant' in [[spacing]], the distance [m] "
                  "between neighbours in a row; or 'density', the number of "
                  "plants per square metre");
    const Values& range = find_key("spacing", "plant")->values;
    problems.rule(
        {"density"},
        spacing.density > 0 && spacing.plant > 0 &&
            (spacing.plant < range.lower || spacing.plant > range.upper),
        "spacing.density is {} m-2 (neighbours in a row would be {:.4g} m "
        "apart, and the range is {} .. {} m); use another density, or another "
        "distance between rows",
        spacing.density, spacing.plant, range.lower, range.upper);
}

//! Warns if random displacements may reach the next plant in the row.
void check_positions(const Spec& spec, const Problems& problems) {
    const double position = spec.field.variation.position;
    for (const Named<Spacing>& spacing : spec.spacings)
        if (const double distance = spacing.value.plant;
            distance > 0 && most_deviations * position > distance)
            return problems.doubt(
                {"field.variation.position"}, true,
                "field.variation.position is {} m (plants reach the places of "
                "their neighbours, {:.4g} m away; modern planters have 0.035 "
                "m); check it and the spacing",
                position, distance);
}

//! Warns if the leaf area index of the baseline is unrealistic.
void check_leaf_area(const Spec& spec, const Problems& problems) {
    const Plant& baseline = spec.plant.crop.baseline;
    const auto area_of = [&](const Plant& plant) {
        return plant_area(build_plant(plant, spec.plant.tessellation)).leaves;
    };
    const bool responds =
        spec.plant.is_plastic && !baseline.plasticity.responses.empty();
    const double area = area_of(baseline);
    for (std::size_t i = 0; i < spec.spacings.size(); ++i) {
        const Spacing& spacing = spec.spacings[i].value;
        const double density = spacing.plants_per_area();
        const std::string doubt = doubt_of_lai(
            density * (responds ? area_of(respond(baseline, density)) : area));
        problems.in("spacing", i)
            .doubt({"row"}, !doubt.empty(),
                   "spacing.row is {} m (with {} m between plants the baseline "
                   "{}); check both distances",
                   spacing.row, spacing.plant, doubt);
    }
}

//! Reports an error if light is not traced in the waveband to which the
//! tolerance applies.
void check_bands(const Spec& spec, const Problems& problems) {
    for (std::size_t b = 0; b < wavebands.size(); ++b)
        problems.rule(
            {"light.band"},
            spec.light.band == wavebands[b].name && !spec.plant.crop.follows[b],
            "light.band is \"{0}\" (light is not followed in it); add [[band]] "
            "with name = \"{0}\"",
            wavebands[b].name);
}

//! Checks that the memory can hold the faces of all leaves of a field.
void check_faces(const Spec& spec, const Problems& problems) {
    constexpr double limit = 20e6;
    const FieldForm& field = spec.field;
    const int cells = spec.plant.tessellation.cells_along;
    const auto leaves =
        static_cast<double>(spec.plant.crop.baseline.leaves.size());
    const double faces = 2. * cells * leaves * field.rows * field.plants;
    problems.rule(
        {"plant.cells_along", "field.rows", "field.plants"}, faces > limit,
        "plant.cells_along is {} (the leaves of {} x {} plants have {:.0f} "
        "faces, the limit is {:.0f}); use fewer, or a smaller field",
        cells, field.rows, field.plants, faces, limit);
}

void check_field(const FieldForm& field, const Problems& problems) {
    const int fewest = std::min(field.rows, field.plants);
    const Keys keys{"border_rows", "rows", "plants"};
    problems.rule(
        keys, field.border_rows > 0 && field.boundary == Boundary::periodic,
        "field.border_rows is not 0 (a field that repeats without end has no "
        "edges); add boundary = \"isolated\" or leave it out");
    problems.rule(
        keys, field.border_rows > 0 && 2 * field.border_rows >= fewest,
        "field.border_rows is {} (no plant of {} x {} would remain); use {} or "
        "less",
        field.border_rows, field.rows, field.plants, (fewest - 1) / 2);
}

}  // namespace

std::string doubt_of_lai(double lai) {
    constexpr double limit = 8;
    return lai > limit ? fmt::format(
                             "has a leaf area index of {:.2f}, and fields "
                             "hardly ever have more than {}",
                             lai, limit)
                       : "";
}

void check_stand(const Spec& spec, const Problems& problems) {
    for (std::size_t i = 0; i < spec.spacings.size(); ++i)
        check_spacing(spec.spacings[i].value, problems.in("spacing", i));
    check_plant_optics(spec.plant.crop.optics, problems);
    check_objects(spec, problems);
    check_field(spec.field, problems.in("field"));
    check_positions(spec, problems);
    check_photosynthesis(
        spec.plant.crop.photosynthesis,
        spec.plant.crop.is_known ? spec.plant.crop.baseline.leaves.size() : 0,
        problems);
    check_plant(spec.plant.crop, problems.in("plant.baseline"));
}

void check_variable(const Spec& spec, const Problems& problems) {
    check_components(spec, problems);
    check_growing(spec, problems);
    check_soil(spec, problems);
    check_stand(spec, problems);
}

BaselineDoubts check_spec(const Spec& spec, const Problems& problems) {
    problems.rule(
        ProblemCode::missing, {"name"},
        spec.days.empty() && spec.climates.empty() && problems.empty(),
        "there is neither [[day]] nor [[climate]] (each case has one of them); "
        "add one");
    check_names("site", spec.sites, problems);
    check_names("day", spec.days, problems);
    check_names("climate", spec.climates, problems);
    check_names("spacing", spec.spacings, problems);
    check_names("traits", spec.trait_sets, problems);
    check_names("draw", spec.draws, problems);
    check_draws(spec, problems);
    const double count = number_of_cases(spec);
    const bool are_few = count <= static_cast<double>(most_cases);
    problems.rule({"replicates"}, !are_few,
                  "there are {:.0f} cases (sites x days x spacings x trait "
                  "sets x replicates; the limit is {}); split the campaign",
                  count, most_cases);
    // Repeated names within one axis have been reported already.
    if (problems.empty()) check_case_names(spec, problems);
    if (are_few) check_sky(spec, problems);
    check_names("band", spec.bands, problems);
    check_bands(spec, problems);
    check_components(spec, problems);
    check_growing(spec, problems);
    check_stand(spec, problems);
    if (spec.plant.crop.is_known) check_faces(spec, problems);
    doubt_densities(spec, problems);
    check_light(spec.light, asks_for_assimilation(spec), problems.in("light"));
    check_search(spec, problems);
    check_sensitivity(spec, problems);
    check_leaf_models(spec, problems);
    check_water(spec, problems);
    check_soil(spec, problems);
    check_prices(spec, problems);
    const BaselineDoubts doubts = check_breeding(spec, problems);
    check_feasibility(spec, problems);
    if (spec.plant.crop.is_known && problems.empty())
        check_leaf_area(spec, problems);
    return doubts;
}

}  // namespace ideotype
