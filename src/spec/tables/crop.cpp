// SPDX-License-Identifier: Apache-2.0
#include "ideotype/crop/measures.hpp"
#include "spec/tables.hpp"

namespace ideotype {

template <>
inline constexpr std::array enum_names<PlantMaterial>{
    EnumName{"stalk", PlantMaterial::stalk},
    EnumName{"sheath", PlantMaterial::sheath}};
template <>
inline constexpr std::array enum_names<TraitNumbers>{
    EnumName{"leaf", TraitNumbers::leaf},
    EnumName{"plant", TraitNumbers::plant},
    EnumName{"profile", TraitNumbers::profile}};

template <>
inline constexpr std::array enum_names<Cue>{EnumName{"density", Cue::density},
                                            EnumName{"light", Cue::light}};

namespace {

//! A text as an argument of a template.
template <std::size_t n>
struct Text {
    constexpr Text(const char (&text)[n]) { std::copy_n(text, n, letters); }
    char letters[n];
};

template <const auto& measures, Text name>
constexpr auto measure_of = *std::ranges::find(
    measures, std::string_view(name.letters),
    [](const auto& each) -> std::string_view { return each.name; });

//! Declares the key of a measure, from which it takes unit, range and meaning.
template <const auto& measures, Text name>
constexpr Key measured(Default initial = usual()) {
    constexpr auto measure = measure_of<measures, name>;
    using Part = typename OwnerOf<decltype(measure.value)>::type;
    const auto& [lower, upper] = measure.limits;
    const std::string_view unit = measure.unit;
    Key key = key_of<Part>(measure.name,
                           unit == "m"   ? metres(lower, upper)
                           : unit == "1" ? within(lower, upper)
                                         : within(lower, upper, measure.unit),
                           initial, measure.meaning);
    key.values.type = "number";
    key.place = [](void* part) -> Target {
        return &(static_cast<Part*>(part)->*measure_of<measures, name>.value);
    };
    return key;
}

constexpr Values six_numbers(double lower, double upper) {
    return {.lower = lower,
            .upper = upper,
            .type = "list of 6 numbers",
            .count = 6};
}

bool is_living(const Stalk& stalk) {
    return stalk.is_living();
}
bool is_living(const Sheath& sheath) {
    return sheath.is_living();
}
bool is_living(const Organ& organ) {
    return organ.is_living();
}
bool has_leaflets(const Blade& blade) {
    return blade.leaflets > 1;
}
bool has_height(const Leaf& leaf) {
    return leaf.internode == 0;
}
bool follows_light(const Plasticity& plasticity) {
    return plasticity.cue == Cue::light;
}
bool turns(const Plasticity& plasticity) {
    return plasticity.turn > 0;
}
bool has_densities(const DensityResponse& response) {
    return response.densities.lower < response.densities.upper;
}
bool has_petioles(const CropSpec& crop) {
    return has_petioles(crop.baseline);
}
bool states_plasticity(const CropSpec& crop) {
    const Plasticity& plasticity = crop.baseline.plasticity;
    return plasticity.reference > 0 || plasticity.turn > 0;
}
bool states_leaves(const CropSpec& crop) {
    return !crop.leaf_files.empty();
}

// Each line declares one key.
// clang-format off
constexpr Key stalk_keys[] = {
    key<&Stalk::is_present>("present", any_value, usual(), "true if plants have stalks"),
    measured<stalk_measures, "height">(),
    measured<stalk_measures, "base_diameter">(),
    measured<stalk_measures, "top_diameter">(),
    measured<tissue_measures<Stalk>, "capacity">().written_if<Stalk, is_living>(),
    measured<tissue_measures<Stalk>, "density">().written_if<Stalk, is_living>(),
    measured<tissue_measures<Stalk>, "maintenance">().written_if<Stalk, is_living>(),
    measured<tissue_measures<Stalk>, "construction">().written_if<Stalk, is_living>(),
};

constexpr Key sheath_keys[] = {
    key<&Sheath::is_present>("present", any_value, usual(), "true if plants have sheaths"),
    measured<sheath_measures, "length">(),
    measured<sheath_measures, "thickness">(),
    measured<tissue_measures<Sheath>, "capacity">().written_if<Sheath, is_living>(),
    measured<tissue_measures<Sheath>, "density">().written_if<Sheath, is_living>(),
    measured<tissue_measures<Sheath>, "maintenance">().written_if<Sheath, is_living>(),
    measured<tissue_measures<Sheath>, "construction">().written_if<Sheath, is_living>(),
};

constexpr Key petiole_keys[] = {
    key<&Petiole::is_present>("present", any_value, usual(), "true if plants have petioles"),
    measured<petiole_measures, "diameter">(),
};

constexpr Key blade_keys[] = {
    measured<blade_measures, "folding_angle">(),
    measured<blade_measures, "curvature_exponent">(),
    measured<blade_measures, "leaflet_divergence">().written_if<Blade, has_leaflets>(),
    measured<blade_measures, "rachis_length">().written_if<Blade, has_leaflets>(),
    key<&Blade::leaflets>("leaflets", within(1, 15), usual(), "number of leaflets of each leaf").written_if<Blade, has_leaflets>(),
    key<&Blade::width_controls>("width_controls", six_numbers(0, 2), by("[0.28, 0.88587, 0.895017, 1.149943, 0.379696, 0]"), "width from base to tip: control values of a cubic B-spline with knots at 1/3 and 2/3, scaled to a maximum of 1"),
};

constexpr Key growth_keys[] = {
    key<&Growth::leaves>("leaves", within(3, 40), usual(), "leaf count of the main stem; the leaves of the plant are the highest of them"),
    key<&Growth::interval>("interval", within(0, 5000, "deg C d"), usual(), "thermal time between the tips of successive leaves"),
    key<&Growth::largest_area>("largest_area", within(1e-05, 1, "m2"), usual(), "one-sided area of the largest blade"),
    key<&Growth::largest>("largest", within(0.01, 0.99), usual(), "rank of the largest blade over the leaf count"),
    key<&Growth::narrowing>("narrowing", within(0, 100), usual(), "a of the area by rank, exp(-a x^2 + b x^3) with x = (n - m) / (m - 1) and m the rank of the largest"),
    key<&Growth::skewness>("skewness", within(-100, 100), usual(), "b of the area by rank"),
    key<&Growth::first_extension>("first_extension", within(0, 5000, "deg C d"), usual(), "thermal time from tip to collar of the first leaf"),
    key<&Growth::longest_extension>("longest_extension", within(0, 5000, "deg C d"), usual(), "longest thermal time from tip to collar of a leaf"),
    key<&Growth::last_extension>("last_extension", within(0, 5000, "deg C d"), usual(), "thermal time from tip to collar of the highest leaf"),
    key<&Growth::lower_death>("lower_death", within(0, 5000, "deg C d"), usual(), "thermal time from emergence to the death of the lowest leaf"),
    key<&Growth::lower_interval>("lower_interval", within(0, 5000, "deg C d"), usual(), "thermal time between the deaths of lower leaves"),
    key<&Growth::upper_death>("upper_death", within(0, 5000, "deg C d"), usual(), "thermal time from silking to the death of the first upper leaf"),
    key<&Growth::upper_interval>("upper_interval", within(0, 5000, "deg C d"), usual(), "thermal time between the deaths of upper leaves"),
    key<&Growth::fading>("fading", within(0, 5000, "deg C d"), usual(), "thermal time from the death of a blade to the loss of all green"),
    key<&Growth::silking>("silking", within(0, 5000, "deg C d"), usual(), "thermal time to silking after as many intervals as there are leaves"),
    key<&Growth::maturity>("maturity", within(0, 5000, "deg C d"), usual(), "thermal time from silking to maturity"),
    key<&Growth::internode_rate>("internode_rate", within(1e-05, 0.1, "m / (deg C d)"), usual(), "elongation of an internode after the collar of its leaf"),
    key<&Growth::base>("base", within(-5, 20, "deg C"), usual(), "base temperature of thermal time"),
    key<&Growth::cap>("cap", within(20, 50, "deg C"), usual(), "temperature above which thermal time is no faster"),
    key<&Growth::ageing>("ageing", number_or_list(0, 2), usual(), "capacity of green leaves relative to that before silking, at equal steps of development from silking to maturity, linear in between; it begins with 1").quiet(),
    key<&Growth::maintenance>("maintenance", number_or_list(0, 2), usual(), "maintenance respiration of other organs per mass relative to that before silking, at the steps of ageing; it begins with 1").quiet(),
    key<&Growth::root_share>("root_share", within(0, 1), usual(), "dry mass of roots over that of leaves and of organs with a density, where plants grow; roots respire 0.015 of it per day at 25 deg C, times `maintenance`, and cost 1.45 of carbohydrate; 0: roots have no effect").quiet(),
    key<&Growth::ear_maintenance>("ear_maintenance", within(0, 0.1, "d-1"), usual(), "carbohydrate that the dry matter which enters the ear after silking respires at 25 deg C, times `maintenance`, until maturity; 0: no effect").quiet(),
};

constexpr Key grain_keys[] = {
    key<&Grain::rule>("kernel_rule", any_value, usual(), "number of kernels by growth around silking, after Andrade and others 2002, or as in CERES-Maize"),
    key<&Grain::kernels>("kernels", within(0, 5000), usual(), "kernels per plant: by Andrade those of a growth of 4.2 g d-1, by CERES the most"),
    key<&Grain::rate>("filling_rate", within(0, 100, "mg d-1"), usual(), "growth of a kernel at the best temperature"),
    key<&Grain::reserves>("reserves", within(0, 1), usual(), "reserves of the stem at silking, as a fraction of its dry mass"),
};

constexpr Key leaf_keys[] = {
    measured<leaf_measures, "length">(required("0.651")),
    measured<leaf_measures, "width">(required("0.073")),
    measured<leaf_measures, "insertion_angle">(required("34")).or_by("midrib"),
    measured<leaf_measures, "curvature">(required("90")).or_by("midrib"),
    measured<leaf_measures, "azimuth">(required("90")),
    measured<leaf_measures, "insertion_height">(required("0.09")).or_by("internode").written_if<Leaf, has_height>(),
    measured<leaf_measures, "roll">().quiet(),
    measured<leaf_measures, "twist">().quiet(),
    measured<leaf_measures, "petiole_length">().quiet(),
    measured<leaf_measures, "petiole_angle">().quiet(),
    measured<leaf_measures, "internode">().quiet(),
    key<&Leaf::midrib>("midrib", words("two points or more"), by("from insertion_angle and curvature"), "points of the digitised midrib from base to tip, out from the stalk and up, in any unit; insertion_angle and curvature follow from it, and bend it further if given"),
};

constexpr Key organ_keys[] = {
    key<&Organ::name>("name", name_text, required("\"ear\""), "name of the organ"),
    key<&Organ::is_present>("present", any_value, usual(), "true if plants have the organ"),
    key<&Organ::material>("tissue", any_value, usual(), "tissue with the optics of its surface"),
    key<&Organ::leaf>("leaf", within(0, 40), usual(), "rank of the leaf at the insertion of the organ; 0: the stalk's top"),
    key<&Organ::count>("count", within(1, 100), usual(), "number of cones, evenly around the stalk"),
    key<&Organ::sides>("sides", within(3, 24), usual(), "number of faces around each cone"),
    measured<organ_measures, "offset">(),
    measured<organ_measures, "spread">(),
    measured<organ_measures, "length">(required("0.3")),
    measured<organ_measures, "base_diameter">(required("0.01")),
    measured<organ_measures, "top_diameter">(),
    measured<organ_measures, "inclination">(),
    measured<tissue_measures<Organ>, "capacity">().written_if<Organ, is_living>(),
    measured<tissue_measures<Organ>, "density">().written_if<Organ, is_living>(),
    measured<tissue_measures<Organ>, "maintenance">().written_if<Organ, is_living>(),
    measured<tissue_measures<Organ>, "construction">().written_if<Organ, is_living>(),
    key<&Organ::senescence>("senescence", within(0, 5000, "deg C d"), usual(), "thermal time from silking to its death, where plants grow: a dead organ has the optics of the stalk and does not assimilate; 0: it stays green").quiet(),
};

constexpr Key plasticity_keys[] = {
    key<&Plasticity::reference>("reference", within(0, 1000, "m-2"), usual("7"), "density at which plants have the measures of this file; 0: not known, so that plants are the same at any density"),
    key<&Plasticity::cue>("cue", any_value, usual(), "what responses follow: \"density\" of the rows, or, where plants grow, the \"light\" on young leaves, as the density at which they would have it in a stand of this crop alone").quiet(),
    key<&Plasticity::rows>("rows", metres(0.1, 10), usual(), "distance of rows in that stand").written_if<Plasticity, follows_light>(),
    key<&Plasticity::turning>("turning", within(0, 1000, "m-2"), by("none", "[4.5, 9]"), "densities at which planes of leaves begin to turn towards the widest gap between plants, and at which they have turned by `turn`; linear in the logarithm of density in between").written_if<Plasticity, turns>(),
    key<&Plasticity::turn>("turn", within(0, 1), usual("0.5"), "turn of planes of leaves, relative to their angle from the direction of that gap").written_if<Plasticity, turns>(),
};

constexpr Key response_keys[] = {
    key<&DensityResponse::scales>("scales", words("measures of the plant"), usual("[\"leaf.length\"]"), "measures that are multiplied by d^slope, with d the density relative to plasticity.reference").quiet(),
    key<&DensityResponse::shifts>("shifts", words("measures of the plant"), usual("[\"leaf.insertion_angle\"]"), "measures to which slope x ln(d) is added").quiet(),
    key<&DensityResponse::slopes>("slope", number_or_list(-90, 90), required("[0.1, 0, -0.1]"), "slope over leaf position, at equal distances from the lowest leaf to the highest, in the unit of shifted measures"),
    key<&DensityResponse::densities>("densities", within(0, 1000, "m-2"), by("any", "[4.5, 15]"), "densities for which the response is known; outside, measures keep their value at the nearest of them").written_if<DensityResponse, has_densities>(),
};

constexpr Key trait_keys[] = {
    key<&TraitEntry::trait, &Trait::name>("name", name_text, required("\"length\""), "name of the trait"),
    key<&TraitEntry::trait, &Trait::numbers>("per", any_value, usual(), "number of values: one for each leaf, one for the whole plant, or the points of a smooth curve over leaf position"),
    key<&TraitEntry::trait, &Trait::points>("points", within(1, 10), usual(), "number of points of a profile, at equal distances from the lowest leaf to the highest"),
    key<&TraitEntry::sets>("sets", words("measures of the plant"), usual("[\"leaf.length\"]"), "the measure that has the value of the trait").quiet(),
    key<&TraitEntry::scales>("scales", words("measures of the plant"), usual("[\"leaf.length\"]"), "measures of the baseline that the value multiplies").quiet(),
    key<&TraitEntry::shifts>("shifts", words("measures of the plant"), usual("[\"leaf.length\"]"), "measures of the baseline to which the value is added").quiet(),
    key<&TraitEntry::trait, &Trait::unit>("unit", texts("m", "deg", "1"), required("\"m\""), "unit of the value: that of the measures, or \"1\" of a factor"),
    key<&TraitEntry::trait, &Trait::range>("range", within(-1000, 1000), required("[0.4, 1.1]"), "range of the values that searches may reach"),
    key<&TraitEntry::trait, &Trait::is_circular>("circular", any_value, usual(), "true if both ends of the range are the same direction"),
    key<&TraitEntry::trait, &Trait::is_slope>("over_density", any_value, usual(), "true if the values are slopes over the logarithm of density, as those of [[response]]: a reaction norm. The trait then has no effect at plasticity.reference").quiet(),
    key<&TraitEntry::trait, &Trait::is_bred>("bred", any_value, usual(), "true if campaigns without trait sets search the trait"),
};

constexpr Key bounds_keys[] = {
    key<&BoundsEntry::rule>("name", name_text, required("\"paper\""), "name by which campaigns choose the bounds"),
    key<&BoundsEntry::trait>("trait", name_text, required("\"length\""), "trait with these bounds"),
    key<&BoundsEntry::range>("range", within(-1000, 1000), required("[0.4, 1.1]"), "range of the values that searches may reach"),
    key<&BoundsEntry::change>("change", within(0, 100), usual(), "largest change of the baseline's value, relative to it; 0: any"),
    key<&BoundsEntry::is_bred>("bred", any_value, usual(), "true if campaigns with these bounds and without trait sets search the trait; they then search only traits of the rule with this mark"),
};

constexpr Key crop_keys[] = {
    key<&CropSpec::baseline, &Plant::name>("name", name_text, required("\"b73\""), "name of the plant"),
};
// clang-format on

template <class Record, std::size_t n>
constexpr Description of_crop(std::string_view section, const Key (&keys)[n]) {
    Description all = describe<Record>(section, keys);
    all.is_of_crop = true;
    return all;
}

constinit const Description stalk_table = of_crop<Stalk>("stalk", stalk_keys);
constinit const Description sheath_table =
    of_crop<Sheath>("sheath", sheath_keys);
constinit const Description petiole_table =
    of_crop<Petiole>("petiole", petiole_keys);
constinit const Description blade_table = of_crop<Blade>("blade", blade_keys);
constinit const Description growth_table =
    of_crop<Growth>("growth", growth_keys);
constinit const Description grain_table = of_crop<Grain>("grain", grain_keys);
constinit const Description plasticity_table =
    of_crop<Plasticity>("plasticity", plasticity_keys);
constinit const Description response_table =
    of_crop<DensityResponse>("response", response_keys);
constinit const Description leaf_table = of_crop<Leaf>("leaf", leaf_keys);
constinit const Description organ_table = of_crop<Organ>("organ", organ_keys);
constinit const Description trait_table =
    of_crop<TraitEntry>("trait", trait_keys);
constinit const Description bounds_table =
    of_crop<BoundsEntry>("bounds", bounds_keys);

constexpr Table crop_parts[] = {
    table<&CropSpec::baseline, &Plant::stalk>("stalk", stalk_table).variable(),
    table<&CropSpec::baseline, &Plant::sheath>("sheath", sheath_table)
        .variable(),
    table<&CropSpec::baseline, &Plant::petiole>("petiole", petiole_table)
        .variable()
        .written_if<CropSpec, has_petioles>(),
    table<&CropSpec::baseline, &Plant::blade>("blade", blade_table).variable(),
    table<&CropSpec::growth>("growth", growth_table).variable(),
    table<&CropSpec::grain>("grain", grain_table).variable().keeping_light(),
    table<&CropSpec::baseline, &Plant::leaves>("leaf", leaf_table)
        .variable()
        .at_most(most_leaves),
    table<&CropSpec::baseline, &Plant::organs>("organ", organ_table)
        .variable()
        .optional()
        .at_most(most_organs),
    table<&CropSpec::baseline, &Plant::plasticity>("plasticity",
                                                   plasticity_table)
        .variable()
        .optional()
        .written_if<CropSpec, states_plasticity>(),
    table<&CropSpec::baseline, &Plant::plasticity, &Plasticity::responses>(
        "response", response_table)
        .variable()
        .optional()
        .at_most(most_responses),
    table<&CropSpec::traits>("trait", trait_table).at_most(most_traits),
    table<&CropSpec::bounds>("bounds", bounds_table).optional()};

constexpr Table leaf_tables[] = {
    table_of<CropSpec>("optics", crop_optics_table).optional(),
    table<&CropSpec::photosynthesis>("photosynthesis", photosynthesis_table)
        .optional()
        .written_if<CropSpec, states_leaves>()};

}  // namespace

constinit const Description crop_table = [] {
    Description all = describe<CropSpec>("crop file", crop_keys, crop_parts);
    all.is_of_crop = true;
    return all;
}();
constinit const Description crop_leaves_table = [] {
    Description all;
    all.first_table = leaf_tables;
    all.table_count = std::size(leaf_tables);
    return all;
}();

}  // namespace ideotype
