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
#include "ideotype/climate/light_series.hpp"
#include "ideotype/climate/sky_sampler.hpp"
#include "ideotype/climate/weather.hpp"
#include "ideotype/core/enum_names.hpp"
#include "ideotype/core/range.hpp"
#include "ideotype/crop/crop.hpp"
#include "ideotype/crop/measured_lines.hpp"
#include "ideotype/physiology/photosynthesis.hpp"
#include "search/settings.hpp"
#include "search/stop_rules.hpp"

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

//! A named entry of an axis of the sweep.
template <class Value>
struct Named {
    std::string name;
    Value value;
};

//! The weather of a period from a file.
struct Climate {
    std::string file;  //!< path as written; "": each site has its own
    Period period;
    std::string stamp;  //!< time stamp; "": as in the format
    ColumnMap columns;
    std::optional<double> wind_height;  //!< height above the ground [m]
    std::optional<double> co2;          //!< CO2 of the air [umol mol-1]
    Date emergence{0, 1, 1};            //!< day; year 0: plants do not grow

    bool grows() const { return emergence.year > 0; }
};

//! The weather of a site in a climate, as it was read.
struct SiteWeather {
    std::string site, climate;  //!< names of the site and the climate
    std::string sha256;         //!< SHA-256 of the weather file
    double utc_offset = 0;      //!< time of dates and hours, from UTC [h]
    std::vector<Date> dates;
    std::vector<double> hours;  //!< middle of each step of a day [h]
    //! Light on a horizontal plane, date by date and hour by hour [W m-2];
    //! empty in wavebands that the campaign does not follow.
    ByBand<std::vector<double>> beam, diffuse;
    //! Air temperature [deg C], relative humidity (0 to 1), wind [m s-1],
    //! pressure [kPa] and longwave radiation of the sky [W m-2]; may be empty.
    std::vector<double> temperature, humidity, wind, pressure, longwave;
};

//! The traits that may be bred; all others keep the baseline's values.
using TraitSet = std::vector<std::string>;

using NamedDay = Named<DaySpan>;
using NamedClimate = Named<Climate>;
using NamedSpacing = Named<Spacing>;
using NamedTraits = Named<TraitSet>;

//! One trait of a crop file, which acts on the measures of one of these lists.
struct TraitEntry {
    Trait trait;
    std::vector<std::string> sets, scales, shifts;
};

//! Bounds of one trait under a rule that campaigns choose by its name.
struct BoundsEntry {
    std::string rule;
    std::string trait;
    Range range;
    double change = 0;     //!< relative to the baseline; 0: any
    bool is_bred = false;  //!< whether campaigns with only the rule breed it
};

//! Models of leaves, in the order of LeafRates.
enum class LeafModel { hyperbola, collatz, farquhar };
template <>
inline constexpr std::array enum_names<LeafModel>{
    EnumName{"hyperbola", LeafModel::hyperbola},
    EnumName{"collatz", LeafModel::collatz},
    EnumName{"farquhar", LeafModel::farquhar}};

//! The table [photosynthesis]. A list has one number for all leaves, or one for
//! each, the lowest first; empty: the model's default.
struct PhotosynthesisSpec {
    LeafModel model = LeafModel::hyperbola;
    std::vector<double> theta, rd;  //!< numbers of all models
    std::vector<double> phi, amax;  //!< numbers of the hyperbola
    //! Gross assimilation at an absorbed PPFD of 2000, in place of amax.
    std::vector<double> rate_2000;
    std::vector<double> vmax, alpha, beta, k;  //!< numbers of Collatz
    //! Numbers of Farquhar, with beta.
    std::vector<double> vcmax, jmax, tpu, g1;
    CapacityProfile profile = CapacityProfile::exponential;
    double kn = CanopyNitrogen{}.kn;
    double nitrogen = CanopyNitrogen{}.total;
    std::vector<double> rank_capacity{1};
    bool follows_weather = true;
    double building_days = Photosynthesis{}.building_days;
    double leaf_mass = 45;  //!< dry mass [g m-2 of leaf]
};

//! The table [photosynthesis] of meshes: leaves do not differ by depth and do
//! not follow the weather unless the table says so.
struct MeshLeaves : PhotosynthesisSpec {
    MeshLeaves() {
        profile = CapacityProfile::none;
        follows_weather = false;
    }
};
// Tables read its records as those of its only base.
static_assert(std::is_standard_layout_v<MeshLeaves>);

//! The table [water].
struct WaterSpec {
    LeafWater rules;
    Stomata::Model model = Stomata::Model::medlyn;
    std::optional<double> intercept{}, slope{};
    double limit = 0;  //!< most transpiration on all days [mm]; 0: any
};

//! A crop file, and the bounds within which a campaign breeds its traits.
struct CropSpec {
    //! Fills in the baseline's width profile and the usual traits.
    CropSpec();

    Plant baseline;
    std::vector<TraitEntry> traits;
    std::vector<BoundsEntry> bounds;  //!< bounds of all rules
    std::optional<Growth> growth;
    ByBand<PlantOptics> optics = usual_optics;
    PhotosynthesisSpec photosynthesis;
    //! The file of each key of [photosynthesis] that a file states.
    std::map<std::string, std::string> leaf_files;
    //! Differences between plants; none: the crop file has no such table.
    std::optional<CropVariation> variation;
    //! Rule of bounds; "traits": ranges of the traits; "": own_bounds.
    std::string rule = "traits";
    std::vector<Range> own_bounds;  //!< own bounds of each trait
    bool is_known = true;           //!< whether all files were found
    ByBand<bool> follows{true};     //!< wavebands in which light is followed
};

//! The table [plant].
struct PlantSpec {
    CropSpec crop;
    std::vector<std::string> organs;  //!< present organs besides leaves
    //! Development stage of plants that do not grow, from emergence (0) over
    //! silking (1) to maturity (2); it fixes the capacity of leaves by the
    //! ageing of their crop, and nothing else.
    double stage = 1;
    Tessellation tessellation;
};

//! The surfaces of an OBJ file.
struct MeshContent {
    std::string file;  //!< path as written; "": none
    //! Three coordinates of each vertex [m], and four vertices of each face,
    //! from 0.
    std::vector<double> vertices, faces;
    std::vector<std::string> groups;  //!< names of groups
    std::vector<double> face_groups;  //!< group of each face, from 0
};

//! The material of the groups of a mesh: in each waveband reflectance and
//! transmittance, or reflectance of both faces and transmittance.
struct MaterialSpec {
    std::vector<std::string> groups;  //!< texts that names of groups begin with
    ByBand<std::vector<double>> optics;
    //! Further wavebands, which only the light in a single mesh may have.
    std::map<std::string, std::vector<double>> others{};

    //! Returns the numbers in a waveband; none: they are not known.
    std::vector<double> in(const std::string& band) const;
};

//! Returns the wavebands of any material by name, "par" first.
std::vector<std::string> bands_of(const std::vector<MaterialSpec>& materials);

//! The mesh of each plant of a component, which neither grows nor is bred.
//! Without a file the component has a crop.
struct ComponentMesh : MeshContent {
    std::vector<MaterialSpec> materials;
    std::optional<MeshLeaves> photosynthesis{};  //!< none: it is not known
};

//! A component beside the campaign's crop.
struct ComponentSpec {
    std::string name;
    CropSpec crop;       //!< not known if there is a mesh
    ComponentMesh mesh;  //!< mesh in place of a crop
    TraitSet free;       //!< bred traits; none: not bred
    std::optional<PlantVariation> variation;
    std::vector<double> rows;        //!< rows of the field, from 1
    int mixed = 0;                   //!< places among bred plants; 0: none
    int plants = 0;                  //!< plants per row; 0: as in the field
    int later = 0;                   //!< delay of emergence after the crop [d]
    std::optional<double> jitter{};  //!< jitter instead of the field's [deg]

    bool has_mesh() const { return !mesh.file.empty(); }
};

//! Rows of panels, with the optics of panels in each band.
struct PanelEntry {
    PanelRows rows;
    ByBand<Lambertian> optics = std::to_array<Lambertian>({{.05, 0}, {.15, 0}});
};

//! An object in the field that repeats with the field.
struct ObjectEntry {
    std::string name;
    MeshContent mesh;  //!< surfaces; their groups have no meaning
    double x = 0, y = 0, z = 0, turn = 0;
    ByBand<Lambertian> optics = std::to_array<Lambertian>({{.4, 0}, {.4, 0}});
};

//! A waveband that a campaign names.
struct BandEntry {
    std::string name;
};

//! The table [light]. Values that are missing follow from others.
struct LightSpec {
    std::optional<int> paths;  //!< paths per randomisation
    int randomisations = 16;
    int fields = 1;
    std::optional<double> tolerance;  //!< relative standard error; 0: none
    //! Waveband in which the tolerance bounds the light of leaves.
    std::optional<std::string> band;
    SkyModel sky = SkyModel::uniform;
    //! Dates of a climate whose suns stand for all, and stages of plants that
    //! grow; none: there are no climates, or plants do not grow.
    std::optional<int> dates, stages;
};

//! The way in which values from several scenarios become one objective.
enum class Across { mean, worst };
template <>
inline constexpr std::array enum_names<Across>{
    EnumName{"mean", Across::mean}, EnumName{"worst", Across::worst}};

//! The table [objective].
struct ObjectiveSpec {
    std::vector<std::string> maximised{"absorbed_par"}, minimised;
    //! Weight of each component in the objectives, the bred component first.
    //! Empty: objectives are those of all plants together.
    std::vector<double> weights;
    //! Yield of each component alone, in the unit of the objective, and its
    //! standard error. Empty: the objective is no land equivalent ratio.
    std::vector<double> sole, sole_errors;
    //! Axes whose entries are scenarios of one case, by table name.
    std::vector<std::string> over;
    Across across = Across::mean;
};

//! A limit of the first measure that a trait acts on, in the unit of this
//! measure. A plant must keep to the limit however it is bred.
struct TraitConstraint {
    std::string trait;
    double step = 0;          //!< largest step from leaf to leaf; 0: any
    Range total{0, 1e9};      //!< total of all leaves
    bool is_falling = false;  //!< no leaf may exceed the leaf below
    //! Largest angle between a leaf and a plane to whose two sides leaves
    //! alternate [deg]; 0: any.
    double distichous = 0;
    Range range{-1e9, 1e9};  //!< range of each leaf
    int highest = 0;         //!< limited leaves, from the top down; 0: all
};

//! Returns whether a limit restricts anything.
bool constrains(const TraitConstraint& limit);

//! All limits that a plant must keep to. A plant that breaks limits is worse
//! than any plant that keeps to all, by its violation().
struct Constraints {
    Range lai{0, 1000};  //!< one-sided leaf area index [m2 m-2]
    std::vector<TraitConstraint> traits;
};

//! The measured lines near which plants of the crop must stay.
struct Feasibility {
    MeasuredLines lines;  //!< lines; none without traits
    //! Largest distance from the mean of the lines, see LineDistance; the
    //! excess over it, relative to it, is a violation. 0: no limit.
    double limit = 0;

    //! Returns the lines, if there are any.
    std::optional<MeasuredLines> known_lines() const {
        return lines.traits.empty() ? std::nullopt : std::optional(lines);
    }
};

//! A numeric key of a campaign that a search or a sensitivity study varies.
struct KeyFactor {
    std::string key;  //!< key such as "optics.soil_albedo"
    Range range;
    std::string unit{};  //!< unit; "1": none
    double value = 0;    //!< value in the campaign, or the middle of the range
};

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
    bool has_traits = true;  //!< whether free genes are factors
    std::vector<KeyFactor> keys;
};

//! The table [final]: the best candidates that are evaluated again at the end,
//! and the accuracy of these evaluations.
struct FinalSpec {
    std::optional<int> candidates;
    int paths = 16384;
    int randomisations = 16;
};

//! The time that workers may take. It does not belong to the study and may
//! differ when a case is resumed.
struct AnswerLimits {
    double deadline = 60;  //!< least deadline of an evaluation [s]
};

//! All that a campaign file and the files that it names say. Every key, with
//! its unit, range and default, is declared in the tables of spec/tables.
struct Spec {
    std::string name;
    std::uint64_t seed = 1;
    int replicates = 1;
    std::vector<Site> sites;
    std::vector<NamedDay> days;
    std::vector<NamedClimate> climates;  //!< climates that replace days
    std::vector<NamedSpacing> spacings;
    std::vector<NamedTraits> trait_sets{{"all", {}}};
    FieldForm field;  //!< field; each case sets its spacing
    PlantSpec plant;
    std::vector<ComponentSpec> components;
    std::vector<PanelEntry> panels;
    std::vector<ObjectEntry> objects;
    std::vector<BandEntry> bands;  //!< wavebands in the campaign file
    ByBand<double> soil_albedo = usual_soil_albedo;
    double par_fraction = 0.45;
    LightSpec light;
    ObjectiveSpec objective;
    bool assimilates = false;  //!< whether leaves assimilate
    std::optional<WaterSpec> water;
    Constraints constraints;
    Feasibility feasibility;
    SearchSpec search;
    SensitivitySpec sensitivity;
    bool is_study = false;  //!< whether it is a sensitivity study
    StopRules stop;
    FinalSpec final;
    AnswerLimits parallel;
    std::vector<SiteWeather> weathers;  //!< weather by site and climate
    //! Keys of a history's campaign that this version does not have, but for
    //! those with their former default.
    std::set<std::string> passed_over;
};

//! Returns whether light is followed in each waveband.
ByBand<bool> followed_bands(const Spec& spec);

//! Returns whether plants grow in a climate.
bool plants_grow(const Spec& spec);

//! Returns whether the entries of an axis are scenarios of one case.
bool is_over(const Spec& spec, const std::string& axis);

//! Returns whether an objective, or an axis of an atlas, depends on the
//! assimilation of leaves.
bool asks_for_assimilation(const Spec& spec);

//! Returns the names by which campaigns may choose bounds.
std::vector<std::string> rule_names(const CropSpec& crop);

//! Returns whether campaigns without trait sets breed the trait.
bool is_bred(const CropSpec& crop, const Trait& trait);

//! Returns the measures that a trait acts on: the list that is not empty.
const std::vector<std::string>& measures_of(const TraitEntry& entry);

//! Returns a trait with the measures and effect of the list that is not empty.
Trait complete(const TraitEntry& entry);

//! Returns the crop of a crop file without problems.
Crop crop_of(const CropSpec& spec);

//! Returns the bounds of a trait, given the baseline's value.
Range bounds_of(const CropSpec& crop, std::size_t trait, double baseline);

//! Returns the names of all organs that plants may have besides leaves.
std::vector<std::string> all_organs(const Plant& plant);

}  // namespace ideotype
