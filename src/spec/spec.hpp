// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ideotype/canopy/field.hpp"
#include "ideotype/canopy/panels.hpp"
#include "ideotype/canopy/scene.hpp"
#include "ideotype/canopy/season.hpp"
#include "ideotype/climate/light_series.hpp"
#include "ideotype/climate/sky_sampler.hpp"
#include "ideotype/climate/weather.hpp"
#include "ideotype/core/enum_names.hpp"
#include "ideotype/core/range.hpp"
#include "ideotype/crop/crop.hpp"
#include "ideotype/crop/measured_lines.hpp"
#include "ideotype/physiology/photosynthesis.hpp"
#include "ideotype/physiology/soil_water.hpp"
#include "search/gene.hpp"
#include "search/settings.hpp"
#include "search/stop_rules.hpp"
#include "spec/toml_value.hpp"

namespace ideotype {

template <>
inline constexpr std::array enum_names<SkyModel>{
    EnumName{"uniform", SkyModel::uniform},
    EnumName{"overcast", SkyModel::overcast},
    EnumName{"clear", SkyModel::clear}};
template <>
inline constexpr std::array enum_names<Boundary>{
    EnumName{"periodic", Boundary::periodic},
    EnumName{"isolated", Boundary::isolated}};

//! A named entry of an axis.
template <class Value>
struct Named {
    std::string name;
    Value value;
};

//! The weather of a period from a file.
struct Climate {
    std::string file;  //!< path as written; "": each site names its own file
    Period period;
    std::string stamp;  //!< meaning of time stamps; "": default of the format
    ColumnMap columns;
    std::optional<double> wind_height;  //!< height above the ground [m]
    std::optional<double> co2;          //!< CO2 of the air [umol mol-1]
    Date emergence{0, 1, 1};            //!< day; year 0: plants do not grow
    //! Years that the climate is repeated in; empty: the year of the period. A
    //! complete specification has a climate for each year instead.
    std::vector<double> years{};
    //! Weight as a scenario, or that of each year; empty: 1.
    std::vector<double> weights{};
    std::size_t table = 0;  //!< index of the [[climate]] that describes it

    bool grows() const { return emergence.year > 0; }
    double weight() const { return weights.empty() ? 1 : weights.front(); }
};

//! The weather of a site in a climate, as read from a file.
struct SiteWeather {
    std::string site, climate;  //!< names of the site and the climate
    std::string sha256;         //!< SHA-256 of the weather file
    double utc_offset = 0;      //!< offset of the dates and hours from UTC [h]
    std::vector<Date> dates;
    std::vector<double> hours;  //!< middle of each step of a day [h]
    //! Light on a horizontal plane, date by date and hour by hour [W m-2].
    //! Empty in wavebands that the campaign does not trace.
    ByBand<std::vector<double>> beam, diffuse;
    //! Air temperature [deg C], relative humidity (0 to 1), wind [m s-1],
    //! pressure [kPa], longwave radiation of the sky [W m-2] and rain [mm]; may
    //! be empty.
    std::vector<double> temperature, humidity, wind, pressure, longwave, rain;
};

//! The free traits; all others keep the values of the baseline.
using TraitSet = std::vector<std::string>;

using NamedDay = Named<DaySpan>;
using NamedClimate = Named<Climate>;
using NamedSpacing = Named<Spacing>;
using NamedTraits = Named<TraitSet>;

//! Values of numeric keys of a campaign that are drawn together, such as from a
//! posterior distribution.
struct Draw {
    std::vector<std::string> keys;
    std::vector<double> values;  //!< one for each key
};
using NamedDraw = Named<Draw>;

//! A trait of a crop file. One of these lists names the measures that it
//! changes.
struct TraitEntry {
    Trait trait;
    std::vector<std::string> sets, scales, shifts;
};

//! Bounds of a trait under a rule that campaigns choose by name.
struct BoundsEntry {
    std::string rule;
    std::string trait;
    Range range;
    double change = 0;  //!< largest relative change from the baseline; 0: any
    bool is_bred = false;  //!< whether the rule makes the trait free
};

//! Models of leaves, in the order of LeafRates.
enum class LeafModel { hyperbola, collatz, farquhar };
template <>
inline constexpr std::array enum_names<LeafModel>{
    EnumName{"hyperbola", LeafModel::hyperbola},
    EnumName{"collatz", LeafModel::collatz},
    EnumName{"farquhar", LeafModel::farquhar}};

//! The table [photosynthesis]. A list contains one value for all leaves, or one
//! per leaf, the lowest first. Empty lists use the default of the model.
struct PhotosynthesisSpec {
    LeafModel model = LeafModel::hyperbola;
    std::vector<double> theta, rd;  //!< parameters of all models
    std::vector<double> phi, amax;  //!< parameters of the hyperbola
    //! Gross assimilation at an absorbed PPFD of 2000, given instead of amax.
    std::vector<double> rate_2000;
    std::vector<double> vmax, alpha, beta, k;  //!< parameters of Collatz
    //! Parameters of the model of Farquhar, in addition to beta.
    std::vector<double> vcmax, jmax, tpu, g1;
    CapacityProfile profile = CapacityProfile::exponential;
    double kn = CanopyNitrogen{}.kn;
    double nitrogen = CanopyNitrogen{}.total;
    std::vector<double> rank_capacity{1};
    bool follows_weather = true;
    double building_days = Photosynthesis{}.building_days;
    double leaf_mass = 45;  //!< dry mass [g m-2 of leaf]
};

//! The table [photosynthesis] for meshes. By default, capacity is uniform with
//! depth and does not depend on the weather.
struct MeshLeaves : PhotosynthesisSpec {
    MeshLeaves() {
        profile = CapacityProfile::none;
        follows_weather = false;
    }
};
// Tables access MeshLeaves records as records of the base class.
static_assert(std::is_standard_layout_v<MeshLeaves>);

//! The table [water].
struct WaterSpec {
    LeafWater rules;
    Stomata::Model model = Stomata::Model::medlyn;
    std::optional<double> intercept{}, slope{};
    double limit = 0;  //!< largest transpiration over all days [mm]; 0: any
};

//! Textures of soils in FAO-56, table 19.
enum class Texture {
    sand,
    loamy_sand,
    sandy_loam,
    loam,
    silt_loam,
    silt,
    silty_clay_loam,
    silty_clay,
    clay
};
template <>
inline constexpr std::array enum_names<Texture>{
    EnumName{"sand", Texture::sand},
    EnumName{"loamy_sand", Texture::loamy_sand},
    EnumName{"sandy_loam", Texture::sandy_loam},
    EnumName{"loam", Texture::loam},
    EnumName{"silt_loam", Texture::silt_loam},
    EnumName{"silt", Texture::silt},
    EnumName{"silty_clay_loam", Texture::silty_clay_loam},
    EnumName{"silty_clay", Texture::silty_clay},
    EnumName{"clay", Texture::clay}};

//! The table [soil].
struct SoilSpec {
    Texture texture = Texture::silt_loam;
    std::optional<double> field_capacity{}, wilting_point{};
    std::optional<double> readily_evaporable{}, total_evaporable{};
    double depletion_fraction = Soil{}.depletion_fraction;
    double root_depth = 1.35;   //!< greatest depth [m]
    double root_rate = 0.0022;  //!< [m / (deg C d)]
    double curve_number = 0;    //!< 0: water does not run off

    //! Returns the soil with what its texture states.
    Soil soil() const;
};

//! The table [irrigation].
struct IrrigationSpec {
    std::vector<Date> dates{};
    std::vector<double> amounts{};  //!< [mm] for each date, or one for all
    double depletion = 1;           //!< 1: no irrigation by depletion
    double amount = 0;              //!< [mm]; 0: up to field capacity
    double limit = 0;               //!< [mm]; 0: none
};

//! A crop file, and the bounds of its traits that the campaign sets.
struct CropSpec {
    //! Fills in the width profile of the baseline and the default traits.
    CropSpec();

    Plant baseline;
    std::vector<TraitEntry> traits;
    std::vector<BoundsEntry> bounds;  //!< bounds of all rules
    std::optional<Growth> growth;
    std::optional<Grain> grain;  //!< none: kernels are not modelled
    ByBand<PlantOptics> optics = usual_optics;
    PhotosynthesisSpec photosynthesis;
    //! The file that states each key of [photosynthesis], by key.
    std::map<std::string, std::string> leaf_files;
    //! Within-line variation; nothing if the crop file does not contain the
    //! table.
    std::optional<CropVariation> variation;
    //! Name of the rule of bounds. "traits": the ranges of the traits; "":
    //! own_bounds.
    std::string rule = "traits";
    //! Bounds that the campaign states, by trait.
    std::vector<Range> own_bounds;
    bool is_known = true;        //!< whether the crop's file was read
    ByBand<bool> follows{true};  //!< wavebands in which light is traced
};

//! The table [plant].
struct PlantSpec {
    CropSpec crop;
    //! Organs that are present, in addition to leaves.
    std::vector<std::string> organs;
    //! Development stage of plants that do not grow: 0 is emergence, 1 silking
    //! and 2 maturity. It affects only the photosynthetic capacity of leaves,
    //! which changes with the age of the crop.
    double stage = 1;
    //! Whether plants of all crops respond to density as their files state.
    bool is_plastic = true;
    Tessellation tessellation;
};

//! The surfaces of an OBJ file.
struct MeshContent {
    std::string file;  //!< path as written; "": none
    //! Three coordinates of each vertex [m]; four vertex indices of each face,
    //! counted from 0.
    std::vector<double> vertices, faces;
    std::vector<std::string> groups;  //!< names of groups
    //! Group index of each face, counted from 0.
    std::vector<double> face_groups;
};

//! The material of groups of a mesh. For each waveband it contains reflectance
//! and transmittance, or the reflectances of both faces and the transmittance.
struct MaterialSpec {
    std::vector<std::string> groups;  //!< prefixes of group names
    ByBand<std::vector<double>> optics;
    //! Additional wavebands, which only `ideotype light` supports.
    std::map<std::string, std::vector<double>> others{};

    //! Returns the optical values in a waveband; empty if they are unknown.
    std::vector<double> in(const std::string& band) const;
};

//! Returns the wavebands that any material names, "par" first.
std::vector<std::string> bands_of(const std::vector<MaterialSpec>& materials);

//! The mesh of each plant of a component. Such plants neither grow nor are
//! optimised. Without a file, the component consists of a crop.
struct ComponentMesh : MeshContent {
    std::vector<MaterialSpec> materials;
    std::optional<MeshLeaves> photosynthesis{};  //!< none: unknown
};

//! A component in addition to the main crop.
struct ComponentSpec {
    std::string name;
    CropSpec crop;       //!< crop; not known if there is a mesh
    ComponentMesh mesh;  //!< mesh instead of a crop
    TraitSet free;       //!< optimised traits; empty: not optimised
    std::optional<PlantVariation> variation;
    std::vector<double> rows;  //!< row numbers in the field, counted from 1
    int mixed = 0;   //!< plants that replace plants of the main crop; 0: none
    int plants = 0;  //!< plants per row; 0: as in the field
    int later = 0;   //!< delay of emergence after the main crop [d]
    std::optional<double> jitter{};  //!< jitter instead of the field's [deg]

    bool has_mesh() const { return !mesh.file.empty(); }
};

//! Rows of panels, with the optical properties of panels in each waveband.
struct PanelEntry {
    PanelRows rows;
    ByBand<Lambertian> optics = std::to_array<Lambertian>({{.05, 0}, {.15, 0}});
};

//! An object in the field; each copy of the field contains it.
struct ObjectEntry {
    std::string name;
    MeshContent mesh;  //!< surfaces; group names are ignored
    double x = 0, y = 0, z = 0, turn = 0;
    ByBand<Lambertian> optics = std::to_array<Lambertian>({{.4, 0}, {.4, 0}});
};

//! A waveband that a campaign names.
struct BandEntry {
    std::string name;
};

//! The table [light]. Missing values are derived from the given ones.
struct LightSpec {
    std::optional<int> paths;  //!< paths per randomisation
    int randomisations = 16;
    int fields = 1;
    std::optional<double> tolerance;  //!< relative standard error; 0: none
    //! Waveband in which the tolerance applies to the light absorbed by leaves.
    std::optional<std::string> band;
    SkyModel sky = SkyModel::uniform;
    //! Number of dates of a climate for which the sun is traced, and number of
    //! stages of growing plants. Empty without climates or growth.
    std::optional<int> dates, stages;
};

//! The way in which values of several scenarios form one objective.
enum class Across { mean, worst, quantile, cvar, probability };
template <>
inline constexpr std::array enum_names<Across>{
    EnumName{"mean", Across::mean}, EnumName{"worst", Across::worst},
    EnumName{"quantile", Across::quantile}, EnumName{"cvar", Across::cvar},
    EnumName{"probability", Across::probability}};

//! The table [objective].
struct ObjectiveSpec {
    std::vector<std::string> maximised{"absorbed_par"}, minimised;
    //! Weight of each component in the objectives, the main crop first. If
    //! empty, objectives refer to all plants together.
    std::vector<double> weights;
    //! Yield of each component as a sole crop, in the unit of the objective,
    //! and its standard error. If empty, the objective is not a land equivalent
    //! ratio.
    std::vector<double> sole, sole_errors;
    //! Names of the axes with scenarios of one case as entries.
    std::vector<std::string> over;
    Across across = Across::mean;
    double tail = 0.2;  //!< share of the worst scenarios: quantile and cvar
    std::optional<double> threshold{};  //!< of a probability
};

//! A limit on the first measure that a trait changes, in the unit of this
//! measure.
struct TraitConstraint {
    std::string trait;
    double step = 0;  //!< largest difference between successive leaves; 0: any
    Range total{0, 1e9};      //!< total of all leaves
    bool is_falling = false;  //!< no leaf may exceed the next lower leaf
    //! Largest angle between a leaf and the plane of alternating (distichous)
    //! leaves [deg]; 0: any.
    double distichous = 0;
    Range range{-1e9, 1e9};  //!< range of each leaf
    int highest = 0;  //!< number of top leaves to which it applies; 0: all
};

//! Returns whether a constraint restricts anything.
bool constrains(const TraitConstraint& limit);

//! The constraints on plants. A plant that violates them ranks below all
//! feasible plants, in the order of violation().
struct Constraints {
    Range lai{0, 1000};  //!< one-sided leaf area index [m2 m-2]
    std::vector<TraitConstraint> traits;
};

//! Returns whether any constraint restricts anything.
bool has_constraints(const Constraints& constraints);

//! Measured lines, and the largest allowed distance of plants from them.
struct Feasibility {
    MeasuredLines lines;  //!< measured lines; none if no traits are given
    //! Largest allowed distance from the mean of the lines, see LineDistance;
    //! 0: no limit. The relative excess over it counts as a violation.
    double limit = 0;

    //! Returns the lines, if there are any.
    std::optional<MeasuredLines> known_lines() const {
        return lines.traits.empty() ? std::nullopt : std::optional(lines);
    }
};

//! A key of a campaign that a search or a sensitivity study varies: within a
//! range of numbers, or among values of any type.
struct KeyFactor {
    std::string key;  //!< key such as "optics.soil_albedo"
    Range range;
    std::vector<TomlValue> values{};  //!< values instead of a range
    GeneKind kind = GeneKind::real;
    std::string unit{};  //!< unit; "1": dimensionless
    //! Number of the gene in the campaign: the value of the key, or its entry
    //! in `values`. A key without a value has the middle of the range, or the
    //! first entry.
    double number = 0;
    bool is_known = true;  //!< whether `values` have the campaign's value
};

//! Returns the keys of a draw.
inline std::vector<KeyFactor> factors_of(const Draw& draw) {
    std::vector<KeyFactor> factors;
    for (const std::string& key : draw.keys) factors.push_back({key, {}});
    return factors;
}

//! Returns the bounds of the numbers of a varied key. Those of values are their
//! entries.
inline Range bounds_of(const KeyFactor& factor) {
    if (factor.values.empty()) return factor.range;
    return {0, static_cast<double>(factor.values.size()) - 1};
}

//! The table [search].
struct SearchSpec {
    std::optional<OptimizerKind> optimizer;
    std::optional<int> population;
    int streams = 1;
    GaSettings ga;
    std::vector<double> start;
    std::vector<double> reference;
    std::vector<KeyFactor> keys;  //!< keys that a search varies
    std::vector<AtlasAxis> axes;

    OptimizerKind optimizer_or_usual() const {
        return optimizer.value_or(SearchSettings{}.optimizer);
    }
    int population_or_usual() const {
        return population.value_or(SearchSettings{}.population);
    }
};

//! The table [sensitivity].
struct SensitivitySpec {
    SensitivityMethod method = SensitivityMethod::sobol;
    std::optional<int> samples;
    int levels = SensitivitySettings{}.levels;
    Grouping groups = Grouping::trait;
    bool has_traits = true;  //!< whether free genes are factors of the study
    std::vector<KeyFactor> keys;
};

//! The table [final]: how many of the best candidates are re-evaluated at the
//! end, and with which accuracy.
struct FinalSpec {
    std::optional<int> candidates;
    int paths = 16384;
    int randomisations = 16;
};

//! Time limits for workers. They are not part of the study, and may change when
//! a case is resumed.
struct AnswerLimits {
    double deadline = 60;  //!< shortest deadline of an evaluation [s]
};

//! The contents of a campaign file and of the files that it names. Every key is
//! declared in spec/tables, with its unit, range and default.
struct Spec {
    std::string name;
    std::uint64_t seed = 1;
    int replicates = 1;
    std::vector<Site> sites;
    std::vector<NamedDay> days;
    std::vector<NamedClimate> climates;  //!< climates, which replace days
    std::vector<NamedSpacing> spacings;
    std::vector<NamedTraits> trait_sets{{"all", {}}};
    std::vector<NamedDraw> draws;  //!< draws of keys, all of them scenarios
    FieldForm field;               //!< field; each case sets the spacing
    PlantSpec plant;
    std::vector<ComponentSpec> components;
    std::vector<PanelEntry> panels;
    std::vector<ObjectEntry> objects;
    std::vector<BandEntry> bands;  //!< wavebands that the campaign file names
    ByBand<double> soil_albedo = usual_soil_albedo;
    double par_fraction = 0.45;
    LightSpec light;
    ObjectiveSpec objective;
    bool assimilates = false;  //!< whether assimilation is computed
    std::optional<WaterSpec> water;
    std::optional<SoilSpec> soil;  //!< none: plants have enough water
    std::optional<IrrigationSpec> irrigation;
    std::optional<Prices> prices;  //!< none: no margin
    Constraints constraints;
    Feasibility feasibility;
    SearchSpec search;
    SensitivitySpec sensitivity;
    bool is_study = false;  //!< whether this is a sensitivity study
    StopRules stop;
    FinalSpec final;
    AnswerLimits parallel;
    std::vector<SiteWeather> weathers;  //!< weather by site and climate
    //! Keys in the campaign of a history that this version does not know,
    //! except keys with their former default.
    std::set<std::string> passed_over;
};

//! Returns the wavebands in which light is traced.
ByBand<bool> followed_bands(const Spec& spec);

//! Returns whether plants grow in any climate.
bool plants_grow(const Spec& spec);

//! Returns whether the entries of an axis are scenarios of one case.
bool is_over(const Spec& spec, const std::string& axis);

//! Returns whether an objective, or an axis of an atlas, depends on the
//! assimilation of leaves.
bool asks_for_assimilation(const Spec& spec);

//! Returns the names of the rules of bounds from which campaigns may choose.
std::vector<std::string> rule_names(const CropSpec& crop);

//! Returns whether a trait is free in campaigns without trait sets.
bool is_bred(const CropSpec& crop, const Trait& trait);

//! Returns the measures that a trait changes: the list that is not empty.
const std::vector<std::string>& measures_of(const TraitEntry& entry);

//! Returns a trait, with measures and effect from the list that is not empty.
Trait complete(const TraitEntry& entry);

//! Makes a crop from a crop file that has been checked.
Crop crop_of(const CropSpec& spec);

//! Returns the bounds of a trait, given the value of the baseline.
Range bounds_of(const CropSpec& crop, std::size_t trait, double baseline);

//! Returns the names of all organs, in addition to leaves, that plants may
//! have.
std::vector<std::string> all_organs(const Plant& plant);

}  // namespace ideotype
