// SPDX-License-Identifier: Apache-2.0
#include "ideotype/canopy/quantities.hpp"
#include "spec/tables.hpp"
#include "spec/writer.hpp"

namespace ideotype {

template <>
inline constexpr std::array enum_names<SensitivityMethod>{
    EnumName{"sobol", SensitivityMethod::sobol},
    EnumName{"morris", SensitivityMethod::morris}};
template <>
inline constexpr std::array enum_names<Grouping>{
    EnumName{"trait", Grouping::trait}, EnumName{"gene", Grouping::gene}};

namespace {

constexpr Values source{.type = "path or table", .form = Form::source};
constexpr Values rule(const char* range) {
    return {.type = "text or table",
            .range = range,
            .form = Form::rule,
            .names = Names::rules};
}
constexpr Values duration(double lower, double upper) {
    return {.lower = lower,
            .upper = upper,
            .unit = "s",
            .type = "number or \"1h30m\" or \"HH:MM:SS\"",
            .form = Form::duration};
}
constexpr Values fraction(double lower, double upper) {
    return {.lower = lower,
            .upper = upper,
            .mistaken = {MistakenUnit{"per cent", 0.01}}};
}
constexpr Values objectives(const char* range) {
    return {.type = "text or list of texts",
            .range = range,
            .count = any_count,
            .known = objective_names,
            .names = Names::objectives};
}
constexpr Values quantities(const char* range) {
    return {.range = range, .known = objective_names};
}
constexpr Values axes() {
    Values values = texts("site", "day", "climate", "spacing", "draw");
    values.type = "text or list of texts";
    values.count = any_count;
    return values;
}

bool has_mesh(const ComponentSpec& component) {
    return component.has_mesh();
}

KnownNames names_of_component(const ComponentSpec& component) {
    return names_of(component.crop);
}
bool has_rule(const PlantSpec& plant) {
    return !plant.crop.rule.empty();
}
bool has_organs(const PlantSpec& plant) {
    return !plant.organs.empty();
}
bool has_tolerance(const LightSpec& light) {
    return light.tolerance > 0;
}
bool has_no_tolerance(const LightSpec& light) {
    return !(light.tolerance > 0);
}
bool has_dates(const LightSpec& light) {
    return light.dates.has_value();
}
bool has_stages(const LightSpec& light) {
    return light.stages.has_value();
}
bool maximises(const ObjectiveSpec& objective) {
    return !objective.maximised.empty();
}
bool has_scenarios(const ObjectiveSpec& objective) {
    return !objective.over.empty();
}
bool has_lines(const Spec& spec) {
    return !spec.feasibility.lines.traits.empty();
}
bool assimilates(const Spec& spec) {
    return spec.assimilates;
}
bool is_study(const Spec& spec) {
    return spec.is_study;
}
bool is_search(const Spec& spec) {
    return !spec.is_study;
}

// Each line declares one key.
// clang-format off
constexpr Key top_keys[] = {
    key<&Spec::name>("name", name_text, required("\"ames\""), "name of the campaign, and of the folder of its histories"),
    key<&Spec::seed>("seed", words("0 .. 2^63-1"), usual(), "seed of all random numbers"),
    key<&Spec::replicates>("replicates", within(1, 1000), usual(), "number of independent searches for each combination of the axes, each with another seed"),
};

constexpr Key traits_keys[] = {
    key<&NamedTraits::name>("name", name_text, required("\"angles\""), "name of the trait set, a part of the names of cases"),
    key<&NamedTraits::value>("free", from_file(Names::traits, "traits of the crop file"), required("[\"insertion_angle\", \"azimuth\"]"), "traits that the search may change; all others have the baseline's values").quiet(),
};

constexpr Key draw_keys[] = {
    key<&NamedDraw::name>("name", name_text, required("\"1\""), "name of the draw, a part of the names of scenarios"),
    key<&NamedDraw::value, &Draw::keys>("keys", any_value, required("[\"photosynthesis.rd\"]"), "drawn numbers of field, spacing, panel, optics, photosynthesis or plant.baseline"),
    key<&NamedDraw::value, &Draw::values>("values", numbers(0, 0), required("[2.1]"), "value of each of these keys"),
};

constexpr Key plant_keys[] = {
    key_of<PlantSpec>("baseline", source, required("\"crops/mine.toml\""), "crop file, relative to the campaign file; or its content as [plant.baseline]"),
    key<&PlantSpec::crop, &CropSpec::rule>("bounds", rule("\"traits\", or a rule of the crop file"), usual(), "bounds of traits: a rule of the crop file, \"traits\" for the ranges of its traits, or values in [plant.bounds]").written_if<PlantSpec, has_rule>(),
    key<&PlantSpec::organs>("organs", from_file(Names::organs, "of \"stalk\", \"sheath\", \"petiole\" and the crop file's [[organ]] tables"), by("those that the crop file has present"), "organs of plants in addition to leaves"),
    key<&PlantSpec::stage>("stage", within(0, 2), usual(), "development stage of plants that do not grow, silking at 1 and maturity at 2: their leaves have the capacity of that age by growth.ageing of the crop; it has no other effect").quiet(),
    key<&PlantSpec::is_plastic>("plasticity", any_value, usual(), "false if plants have the measures of their crop files at any density, without the responses of [[response]]; optimised reaction norms act in any case").quiet(),
    key<&PlantSpec::tessellation, &Tessellation::cells_along>("cells_along", within(4, 200), usual(), "number of faces along a leaf, with two across; leaflets have two thirds as many, with four across").trades({6, 8, 12, 16, 24}),
    key<&PlantSpec::tessellation, &Tessellation::stalk_sides>("stalk_sides", within(3, 100), usual(), "number of faces around stalks and sheaths").trades<PlantSpec, has_organs>({3, 6, 12}),
};

constexpr Key trait_bounds_keys[] = {
    itself<Range>("TRAIT", Values{.lower = -1000, .upper = 1000, .range = "within that of the measure"}, by("the range of the trait", "[0.4, 1.1]"), "lower and upper bound of each value of the trait, in the unit of the trait"),
};

constexpr Key component_keys[] = {
    key<&ComponentSpec::name>("name", name_text, required("\"weed\""), "name of the component in files and figures"),
    key_of<ComponentSpec>("crop", source, required("\"crops/mine.toml\""), "crop file of the plants, relative to the campaign file; or its content as [component.crop]").or_by("mesh").excluding("mesh"),
    key<&ComponentSpec::mesh, &ComponentMesh::file>("mesh", file_path, none("\"tree.obj\""), "Wavefront OBJ file of one plant in metres, z up, y along the rows, its foot at the origin; instead of `crop`").written_if<ComponentSpec, has_mesh>(),
    key<&ComponentSpec::mesh, &ComponentMesh::vertices>("vertices", numbers(0, 0, "m"), by("those of the mesh", "[0, 1, 2, 2]"), "coordinates of each vertex, as the program writes them instead of a file").written_if<ComponentSpec, has_mesh>(),
    key<&ComponentSpec::mesh, &ComponentMesh::faces>("faces", numbers(0, 0), by("those of the mesh", "[0, 1, 2, 2]"), "four vertices of each face, from 0").written_if<ComponentSpec, has_mesh>(),
    key<&ComponentSpec::mesh, &ComponentMesh::groups>("group_names", any_value, by("those of the mesh", "[\"leaf01\"]"), "names of the groups of the mesh").written_if<ComponentSpec, has_mesh>(),
    key<&ComponentSpec::mesh, &ComponentMesh::face_groups>("face_groups", numbers(0, 0), by("those of the mesh", "[0, 0, 1]"), "group of each face, from 0").written_if<ComponentSpec, has_mesh>(),
    key<&ComponentSpec::free>("free", from_file(Names::traits, "traits of its crop file"), usual("[\"width\"]"), "traits that the search may change; without any the plants are those of the crop file").quiet().excluding("mesh"),
    key<&ComponentSpec::crop, &CropSpec::rule>("bounds", rule("\"traits\", or a rule of its crop file"), usual(), "bounds of its traits: as for `plant.bounds`, by its crop file; or the table [component.bounds]").quiet().excluding("mesh"),
    key_of<ComponentSpec>("variation", Values{.type = "table"}, by("as the field"), "within-line variation of its plants, with the keys of [field.variation], instead of that of the field; {} for uniform plants").excluding("mesh"),
    key<&ComponentSpec::rows>("rows", numbers(1, 100, "", "list of integers"), none("[2, 4]"), "rows of the field with this component instead of the plant of [plant], counted from 1").variable(),
    key<&ComponentSpec::mixed>("mixed", within(0, 10000), usual(), "number of plants of [plant] that it replaces, at random positions in each generation; instead of `rows`").quiet().variable(),
    key<&ComponentSpec::plants>("plants", within(0, 1000), usual(), "number of plants in each of its rows; 0: as many as `field.plants`").quiet().variable(),
    key<&ComponentSpec::later>("later", within(0, 200, "d"), usual(), "days from `climate.emergence` to the emergence of this component").quiet().variable().excluding("mesh"),
    key<&ComponentSpec::jitter>("jitter", within(0, 180, "deg"), by("as the field"), "largest random turn of each of its plants, instead of `field.jitter` and `field.variation.across_row`").variable(),
};

constexpr Key light_keys[] = {
    key<&LightSpec::paths>("paths", within(16, 16'777'216), by("16384"), "light paths per randomisation; with a tolerance the largest number").trades<LightSpec, has_no_tolerance>({1024, 4096, 16384, 65536}),
    key<&LightSpec::randomisations>("randomisations", within(2, 1024), usual(), "independent repetitions; their spread gives the standard error"),
    key<&LightSpec::fields>("fields", within(1, 256), usual(), "number of random fields among which the randomisations are divided; with several, standard errors include differences between fields").quiet().trades({1, 4, 8}),
    key<&LightSpec::tolerance>("tolerance", fraction(0, 0.1), by("0.005, or 0 if paths is given"), "expected relative standard error of the light absorbed by the leaves of the baseline, met with as few paths as possible; 0: none, all paths").trades<LightSpec, has_tolerance>({0.02, 0.01, 0.005, 0.0025}),
    key<&LightSpec::band>("band", texts("par", "nir"), by("\"par\""), "waveband of the tolerance; all bands share first hits, and scattered light of the others gets about as many paths"),
    key<&LightSpec::sky>("sky", any_value, usual(), "distribution of the radiance of diffuse light: uniform, or CIE overcast or clear sky"),
    key<&LightSpec::dates>("dates", within(1, 366), by("3"), "number of dates of a climate with traced suns; each hour of other dates has the nearest of them; stages of growing plants share the dates").trades<LightSpec, has_dates>({1, 2, 3, 6, 12}),
    key<&LightSpec::stages>("stages", within(1, 40), by("10"), "number of ages at which the canopy of growing plants is evaluated; hours between two of them are linear in thermal time").trades<LightSpec, has_stages>({4, 7, 10, 20}),
};

constexpr Key objective_keys[] = {
    key<&ObjectiveSpec::maximised>("maximise", objectives(nullptr), usual(), "quantity to maximise, any scalar of the canopy on a mean day: absorbed PAR, assimilation (net of leaf respiration in light) or net carbon balance (net of all respiration and of construction cost), per area of ground or of leaf; fractions of the light; leaf area; \"NAME.net_assimilation\" is that of one component").written_if<ObjectiveSpec, maximises>(),
    key<&ObjectiveSpec::minimised>("minimise", objectives("as maximise"), usual(), "quantities to minimise; several objectives need nsga2"),
    key<&ObjectiveSpec::weights>("weights", numbers(-1000, 1000), none("[1, 0.5]"), "weights of the plant of [plant] and of each [[component]] in each objective; without them objectives are those of all plants together"),
    key<&ObjectiveSpec::sole>("sole", numbers(1e-06, 1e6), none("[1.1, 0.9]"), "values of the objective, in its unit, of sole stands of the plant of [plant] and of each [[component]]: the objective is then the land equivalent ratio, the sum of their values over these"),
    key<&ObjectiveSpec::sole_errors>("sole_errors", numbers(0, 1e6), none("[0.002, 0.001]"), "standard errors of `sole`, which `evaluate` adds to that of the ratio; all rows share them, so they cancel in differences"),
    key<&ObjectiveSpec::over>("over", axes(), usual(), "axes with entries that are scenarios, not cases: each plant is evaluated in all of them").written_if<ObjectiveSpec, has_scenarios>(),
    key<&ObjectiveSpec::across>("scenarios", any_value, usual(), "value of each objective over scenarios: the mean; the worst; a quantile; the mean of the worst scenarios (CVaR); or the probability of a value at or above `scenario_threshold`").written_if<ObjectiveSpec, has_scenarios>(),
    key<&ObjectiveSpec::tail>("scenario_tail", within(0.001, 1), usual(), "share of the worst scenarios, by weight: the quantile is the best of them, and the CVaR their mean").quiet(),
    key<&ObjectiveSpec::threshold>("scenario_threshold", within(-1e9, 1e9), none("2000"), "threshold of the probability, in the unit of the objective"),
};

constexpr Key constraints_keys[] = {
    key<&Constraints::lai>("lai", within(0, 1000, "m2 m-2"), usual("[3.4, 3.5]"), "leaf area index; a narrow range fixes it"),
};

constexpr Key trait_constraint_keys[] = {
    key<&TraitConstraint::step>("step", within(0, 360), usual(), "largest difference between neighbouring leaves; 0: any"),
    key<&TraitConstraint::total>("total", within(0, 1e9), usual(), "range of the sum over all leaves"),
    key<&TraitConstraint::is_falling>("falling", any_value, usual(), "true if values may not increase from a leaf to the next higher one"),
    key<&TraitConstraint::distichous>("distichous", within(0, 90, "deg"), usual(), "largest distance of azimuths from one plane, with leaves alternately on its two sides; 0: any"),
    key<&TraitConstraint::range>("range", within(-1e9, 1e9), usual(), "range of each leaf"),
    key<&TraitConstraint::highest>("highest", within(0, 40), usual(), "number of leaves that the range limits, counted from the highest down; 0: all"),
};

//! The correlations of measured lines, stored in a record or a part of it.
template <auto... Path>
constexpr Key correlations = key<Path..., &MeasuredLines::correlations>("correlations", within(-1, 1), by("none: one trait"), "correlation of each pair of traits over the lines: the first with all later ones, then the second with all later ones, ...");

constexpr Key feasibility_keys[] = {
    key_of<Feasibility>("lines", file_path, none(), "file of measured lines, relative to the campaign file; or its content as [[feasibility.trait]] and [[feasibility.line]]"),
    key<&Feasibility::limit>("limit", within(0, 1000), usual(), "largest allowed Mahalanobis distance from the mean of the lines; 0: any"),
    correlations<&Feasibility::lines>,
};

constexpr Key lines_keys[] = {correlations<>};

constexpr Key line_trait_keys[] = {
    key<&LineTrait::measure>("measure", words("measures of the plant"), required("\"leaf.insertion_angle\""), "measure of plants that was taken in several lines"),
    key<&LineTrait::leaf>("leaf", words("\"ear\", \"ear+1\", \"top-1\", ..."), by("none: not of leaves"), "leaf with this measure, counted from the leaf at the ear or from the highest one"),
    key<&LineTrait::mean>("mean", within(-1000, 1000), required("20"), "mean of the lines, in the unit of the measure"),
    key<&LineTrait::deviation>("deviation", within(1e-06, 1000), required("5"), "standard deviation of the lines"),
};

constexpr Key line_keys[] = {
    key<&MeasuredLine::name>("name", words("any text"), required("\"B73\""), "name of the line"),
    key<&MeasuredLine::values>("values", within(-1000, 1000), required("[20, 0.8]"), "values of the traits, in their order and units"),
};

constexpr Key search_keys[] = {
    key<&SearchSpec::optimizer>("optimizer", any_value, by("\"auto\""), "optimizer that proposes the candidates: response surfaces and CMA-ES with restarts, the genetic algorithm, a single CMA-ES, NSGA-II for several objectives, the best plant of each kind, random points, or points of the Sobol' sequence"),
    key<&SearchSpec::population>("population", within(2, 100000), by("100; of CMA-ES 4 + 3 ln(free genes), of auto 2.5 times that"), "plants per generation"),
    key<&SearchSpec::streams>("streams", within(1, 1000), usual(), "number of independent searches with generations in turn, so that many workers do not wait for the end of a generation; not for random search"),
    key<&SearchSpec::ga, &GaSettings::elites>("elites", within(0, 99999), usual(), "best plants carried over and re-evaluated; fewer than the population"),
    key<&SearchSpec::ga, &GaSettings::tournament>("tournament", within(1, 100000), usual(), "contestants per selected parent; at most the population"),
    key<&SearchSpec::start>("start", numbers(0, 0), usual(), "genes of the plant around which auto and CMA-ES begin, as of run --start; none: the baseline"),
    key<&SearchSpec::reference>("reference", numbers(0, 0), by("the worst of each in generation 0"), "reference point of several objectives, in their order and units; the hypervolume of a generation is relative to it"),
};

constexpr Key varied_key = key<&KeyFactor::key>("key", any_value, required("\"optics.soil_albedo\""), "varied key of field, spacing, panel, optics, photosynthesis, water, soil, irrigation or plant.baseline; or climate.emergence, day.date, or rows, mixed, plants, later or jitter of component");
constexpr Key varied_values = key<&KeyFactor::values>("values", any_value, none("[\"loam\", \"clay\"]"), "two or more values of the key, instead of a range: numbers or dates, of which any two are in order, or values of any other type, which are choices").quiet();

constexpr Key varied_keys[] = {
    varied_key,
    key<&KeyFactor::range>("range", any_value, none("[0.05, 0.3]"), "range of the search: whole numbers if the key is an integer").quiet().excluding("values"),
    varied_values,
};

constexpr Key axis_keys[] = {
    key<&AtlasAxis::quantity>("quantity", quantities("as maximise"), required("\"lai\""), "quantity that defines kinds of plants, any that could be an objective"),
    key<&AtlasAxis::range>("range", any_value, required("[2, 6]"), "range that is divided into cells, in the unit of the quantity"),
    key<&AtlasAxis::cells>("cells", within(1, 1000), usual(), "number of cells of equal width; all axes together have at most 1000"),
};

constexpr Key sensitivity_keys[] = {
    key<&SensitivitySpec::method>("method", any_value, usual(), "method: Sobol' indices of the variance, first order and total, or elementary effects after Morris"),
    key<&SensitivitySpec::samples>("samples", within(4, 131072), by("1024; of morris 64"), "number of base samples after Sobol', best a power of two, each of 2 rows and one per factor; or of trajectories after Morris, each of 1 row and one per factor"),
    key<&SensitivitySpec::levels>("levels", within(2, 100), usual(), "even number of values of each factor after Morris"),
    key<&SensitivitySpec::groups>("groups", any_value, usual(), "factor: all genes of a trait, or each gene"),
    key<&SensitivitySpec::has_traits>("traits", any_value, usual(), "true if the traits of the case's trait set are varied"),
};

constexpr Key study_keys[] = {
    varied_key,
    key<&KeyFactor::range>("range", any_value, none("[0.05, 0.3]"), "range in which it is uniformly distributed: whole numbers if the key is an integer").quiet().excluding("values"),
    varied_values,
};

constexpr Key stop_keys[] = {
    key<&StopRules::generations>("generations", within(1, 1e6), usual(), "largest number of generations; also the size of a history"),
    key<&StopRules::no_gain>("no_gain", within(0, 1e6), usual(), "generations over which a line through the means, or the hypervolume, must rise by more than twice its standard error; 0: off, else 5 or more"),
    key<&StopRules::gain_left>("gain_left", within(0, 1), usual(), "share of the gain so far that as many further evaluations gain at most, in 90 % of searches, when the search ends; only with `auto`; 0: off"),
    key<&StopRules::evaluations>("evaluations", within(0, 1e12), usual(), "evaluations after which the search ends; generations that have begun are finished; 0: no limit"),
    key<&StopRules::wall_time>("wall_time", duration(0, 1000000000), usual("\"12:00:00\""), "longest time of all sessions together; 0: no limit"),
};

constexpr Key final_keys[] = {
    key<&FinalSpec::candidates>("candidates", within(1, 1000), by("5"), "number of best plants that are re-evaluated, at most the population; for an atlas the number of its cells"),
    key<&FinalSpec::paths>("paths", within(16, 16'777'216), usual(), "light paths per randomisation"),
    key<&FinalSpec::randomisations>("randomisations", within(2, 1024), usual(), "independent repetitions; their spread gives the standard error"),
};

constexpr Key parallel_keys[] = {
    key<&AnswerLimits::deadline>("deadline", duration(0.001, 1000000000), usual("\"00:10:00\""), "time after which an evaluation is given to another worker; never below 20 times the longest so far"),
};
// clang-format on

constinit const Description traits_table =
    describe<NamedTraits>("traits", traits_keys);
constinit const Description draw_table = describe<NamedDraw>("draw", draw_keys);
constinit const Description light_table =
    describe<LightSpec>("light", light_keys);
constinit const Description objective_table =
    describe<ObjectiveSpec>("objective", objective_keys);
constinit const Description line_trait_table =
    describe<LineTrait>("trait", line_trait_keys);
constinit const Description line_table =
    describe<MeasuredLine>("line", line_keys);
constinit const Description trait_constraint_table =
    describe<TraitConstraint>("TRAIT", trait_constraint_keys);
constinit const Description varied_table =
    describe<KeyFactor>("keys", varied_keys);
constinit const Description study_keys_table =
    describe<KeyFactor>("keys", study_keys);
constinit const Description axis_table = describe<AtlasAxis>("axes", axis_keys);
constinit const Description stop_table = describe<StopRules>("stop", stop_keys);
constinit const Description final_table =
    describe<FinalSpec>("final", final_keys);
constinit const Description parallel_table =
    describe<AnswerLimits>("parallel", parallel_keys);

constexpr Table plant_tables[] = {
    table<&PlantSpec::crop, &CropSpec::own_bounds>("bounds", own_bounds_table)
        .written_by<&PlantSpec::crop, &own_bounds_text>(),
    table<&PlantSpec::crop>("baseline", crop_table)
        .written_by<&PlantSpec::crop, &baseline_text>()};
constinit const Description plant_table =
    describe<PlantSpec>("plant", plant_keys, plant_tables);

constexpr Table component_tables[] = {
    table<&ComponentSpec::mesh, &ComponentMesh::materials>("material",
                                                           material_table)
        .optional(),
    table<&ComponentSpec::mesh, &ComponentMesh::photosynthesis>(
        "photosynthesis", photosynthesis_table),
    table<&ComponentSpec::variation>("variation", variation_table),
    table<&ComponentSpec::crop>("crop", crop_table)
        .written_by<&ComponentSpec::crop, &component_crop_text>(),
    table<&ComponentSpec::crop, &CropSpec::own_bounds>("bounds",
                                                       own_bounds_table)
        .written_by<&ComponentSpec::crop, &own_bounds_text>()};
constinit const Description component_table =
    describe<ComponentSpec>("component", component_keys, component_tables);

constexpr Table constraint_tables[] = {
    table<&Constraints::traits>("TRAIT", trait_constraint_table)
        .named_by<&TraitConstraint::trait, &constrains>()};
constinit const Description constraints_table =
    describe<Constraints>("constraints", constraints_keys, constraint_tables);

//! The tables of measured lines, stored in a record or a part of it.
template <auto... Path>
constexpr std::array lines_tables{
    table<Path..., &MeasuredLines::traits>("trait", line_trait_table)
        .optional()
        .at_most(30),
    table<Path..., &MeasuredLines::lines>("line", line_table)
        .optional()
        .at_most(most_entries)};
constinit const Description feasibility_table = describe<Feasibility>(
    "feasibility", feasibility_keys, lines_tables<&Feasibility::lines>);

constexpr Table search_tables[] = {
    table<&SearchSpec::keys>("keys", varied_table).optional(),
    table<&SearchSpec::axes>("axes", axis_table).optional()};
constinit const Description search_table =
    describe<SearchSpec>("search", search_keys, search_tables);

constexpr Table sensitivity_tables[] = {
    table<&SensitivitySpec::keys>("keys", study_keys_table).optional()};
constinit const Description sensitivity_table = describe<SensitivitySpec>(
    "sensitivity", sensitivity_keys, sensitivity_tables);

constexpr Table spec_tables[] = {
    table<&Spec::sites>("site", site_table).at_most(most_entries),
    table<&Spec::days>("day", day_table).at_most(most_entries).or_by("climate"),
    table<&Spec::climates>("climate", climate_table).optional(),
    table<&Spec::spacings>("spacing", spacing_table)
        .at_most(most_entries)
        .variable(),
    table<&Spec::trait_sets>("traits", traits_table),
    table<&Spec::draws>("draw", draw_table).optional().at_most(most_draws),
    table<&Spec::field>("field", field_table).variable(),
    table<&Spec::plant>("plant", plant_table),
    table<&Spec::components>("component", component_table)
        .completed_with<ComponentSpec, &names_of_component>()
        .optional()
        .at_most(most_components),
    table<&Spec::panels>("panel", panel_table)
        .variable()
        .optional()
        .at_most(most_components),
    table<&Spec::objects>("object", object_table)
        .optional()
        .at_most(most_components),
    table<&Spec::bands>("band", band_table)
        .optional()
        .at_most(wavebands.size()),
    table_of<Spec>("optics", optics_table).variable(),
    table<&Spec::light>("light", light_table),
    table<&Spec::objective>("objective", objective_table),
    table<&Spec::plant, &PlantSpec::crop, &CropSpec::photosynthesis>(
        "photosynthesis", photosynthesis_table)
        .variable()
        .keeping_light()
        .written_if<Spec, assimilates>(),
    table<&Spec::water>("water", water_table).variable(),
    table<&Spec::soil>("soil", soil_table).variable(),
    table<&Spec::irrigation>("irrigation", irrigation_table).variable(),
    table<&Spec::prices>("prices", prices_table).variable().keeping_light(),
    table<&Spec::constraints>("constraints", constraints_table),
    table<&Spec::feasibility>("feasibility", feasibility_table)
        .optional()
        .written_if<Spec, has_lines>(),
    table<&Spec::search>("search", search_table).written_if<Spec, is_search>(),
    table<&Spec::sensitivity>("sensitivity", sensitivity_table)
        .written_if<Spec, is_study>(),
    table<&Spec::stop>("stop", stop_table),
    table<&Spec::final>("final", final_table),
    table<&Spec::parallel>("parallel", parallel_table),
    table<&Spec::weathers>("weather", weather_table)
        .optional()
        .at_most(most_entries)};

}  // namespace

constinit const Description own_bounds_table =
    describe<Range>("bounds", trait_bounds_keys);
constinit const Description lines_table =
    describe<MeasuredLines>("feasibility", lines_keys, lines_tables<>);
constinit const Description spec_table =
    describe<Spec>("top", top_keys, spec_tables);

}  // namespace ideotype
