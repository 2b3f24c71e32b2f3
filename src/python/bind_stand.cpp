// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "bindings.hpp"
#include "ideotype/canopy/field.hpp"
#include "ideotype/core/error.hpp"
#include "spec/writer.hpp"
#include "stand.hpp"

namespace ideotype::python {

namespace {

using Settings = std::vector<std::string>;

std::unique_ptr<CaseStand> of_case(Campaign campaign, int index,
                                   const std::string& path,
                                   const std::string& isa) {
    const Case chosen = case_at(campaign, index, path);
    return std::make_unique<CaseStand>(std::move(campaign), chosen, isa);
}

std::unique_ptr<CaseStand> from_file(const std::string& path, int index,
                                     const Settings& settings,
                                     const std::string& isa) {
    return of_case(read_campaign(path, settings), index, path, isa);
}

std::unique_ptr<CaseStand> from_text(const std::string& text,
                                     const std::string& path, int index,
                                     const Settings& settings,
                                     const std::string& isa) {
    return of_case(read_campaign_text(text, path, settings), index, path, isa);
}

//! Makes the stand of the case with this name; returns null if there is none.
//! If values of varied keys follow the traits in the genome, they are applied
//! to the stand and removed from the genome.
std::unique_ptr<CaseStand> stand_at(const Campaign& campaign,
                                    const std::string& name, Genome& genome,
                                    const std::string& isa) {
    Campaign varied = at_keys(campaign, genome);
    const std::optional<Case> matching = cases(varied).find(name);
    if (!matching) return nullptr;
    return std::make_unique<CaseStand>(std::move(varied), *matching, isa);
}

//! Makes the stand of a history from its resolved campaign, to which settings
//! are applied first.
std::unique_ptr<CaseStand> from_history(const std::string& text,
                                        const std::string& path,
                                        const std::string& name, Genome genome,
                                        const Settings& settings,
                                        const std::string& isa) {
    const Campaign campaign = parse_history_campaign(text, path, settings);
    if (auto found = stand_at(campaign, name, genome, isa)) return found;
    throw Error(path + ": the campaign in this history has no case " + name);
}

//! Returns the name of the entry on each axis. If the case is a mean over
//! several entries, this is the first of them.
nb::dict entries(const CaseStand& stand) {
    const Case chosen = scenarios(stand.chosen()).front();
    nb::dict result;
    result["site"] = chosen.site_name;
    result["day"] = result["climate"] = chosen.day_name;
    result["spacing"] = chosen.spacing_name;
    result["traits"] = chosen.trait_set_name;
    return result;
}

nb::list genes(const CaseStand& stand) {
    const Genome baseline = baseline_genome(stand.campaign());
    nb::list list;
    for (const Gene& gene : gene_space(stand.campaign(), stand.chosen()))
        list.append(nb::make_tuple(
            gene.name, gene.trait, gene.leaf, gene.unit, gene.lower, gene.upper,
            baseline.at(list.size()), gene.is_free, gene.is_circular));
    return list;
}

nb::tuple evaluate(CaseStand& stand, const Input<double, 1>& genome,
                   std::uint32_t generation, bool is_final,
                   std::optional<std::uint64_t> seed,
                   std::optional<double> tolerance) {
    const Genome numbers = to_vector(genome);
    Outcome outcome;
    {
        const nb::gil_scoped_release released;
        outcome = stand.evaluate(numbers, {.generation = generation,
                                           .is_final = is_final,
                                           .seed = seed,
                                           .tolerance = tolerance});
    }
    const std::size_t count = outcome.objectives.size();
    return nb::make_tuple(
        outcome.status == Status::done, outcome.message,
        to_array(outcome.objectives),
        to_array(outcome.randomisations,
                 {count, outcome.randomisations.size() /
                             std::max<std::size_t>(count, 1)}),
        outcome.violation, to_array(outcome.quantities));
}

//! The numbers of a day, in the order of columns.
constexpr std::pair<const char*, double (*)(const SeasonState&)> of_days[] = {
    {"thermal_time", [](const SeasonState& x) { return x.day.thermal_time; }},
    {"rain", [](const SeasonState& x) { return x.day.rain; }},
    {"irrigation", [](const SeasonState& x) { return x.irrigation; }},
    {"root_depth", [](const SeasonState& x) { return x.root_depth; }},
    {"potential_transpiration",
     [](const SeasonState& x) { return x.potential_transpiration; }},
    {"potential_evaporation",
     [](const SeasonState& x) { return x.potential_evaporation; }},
    {"available", [](const SeasonState& x) { return x.available; }},
    {"soil_water", [](const SeasonState& x) { return x.soil_water; }},
    {"depletion", [](const SeasonState& x) { return x.water.depletion; }},
    {"evaporable_depletion",
     [](const SeasonState& x) { return x.water.evaporable_depletion; }},
    {"transpiration",
     [](const SeasonState& x) { return x.fluxes.transpiration; }},
    {"evaporation", [](const SeasonState& x) { return x.fluxes.evaporation; }},
    {"drainage", [](const SeasonState& x) { return x.fluxes.drainage; }},
    {"runoff", [](const SeasonState& x) { return x.fluxes.runoff; }}};

nb::dict to_dict(const SeasonState& state) {
    nb::dict day;
    day["date"] = to_string(state.day.date);
    for (const auto& [name, value] : of_days) day[name] = value(state);
    return day;
}

nb::list run_season(CaseStand& stand, const Input<double, 1>& genome,
                    const std::optional<nb::callable>& control) {
    const ControlDay ask = [&](const SeasonState& state) {
        const nb::gil_scoped_acquire acquired;
        const nb::object answer = (*control)(to_dict(state));
        const auto [stress, irrigation] =
            nb::cast<std::tuple<std::optional<double>, std::optional<double>>>(
                answer);
        return DayControl{stress, irrigation};
    };
    const Genome numbers = to_vector(genome);
    std::vector<SeasonState> states;
    {
        const nb::gil_scoped_release released;
        states = stand.season(numbers, control ? ask : ControlDay{});
    }
    nb::list days;
    for (const SeasonState& state : states) days.append(to_dict(state));
    return days;
}

nb::tuple mesh(const CaseStand& stand, const Input<double, 1>& genome,
               std::size_t component, std::optional<double> thermal_time) {
    return mesh_tuple(stand.mesh(to_vector(genome), component, thermal_time));
}

//! Returns the names of the cases of a campaign, and the replicate of each.
nb::list case_names(const std::string& path, const Settings& settings) {
    nb::list list;
    const Campaign campaign = read_campaign(path, settings);
    for (const CaseName& each : cases(campaign).names())
        list.append(nb::make_tuple(each.name, each.replicate));
    return list;
}

//! Returns the clock hour of each instant [h], the light above the canopy [W
//! m-2], and the light on each sensor relative to it, with its standard error
//! [sensor, instant].
nb::tuple light_on_sensors(CaseStand& stand, const Input<double, 1>& genome,
                           const std::vector<double>& heights,
                           const std::vector<double>& positions, int fields,
                           int points) {
    std::vector<double> hours, incident, means, errors;
    for (const TimeStep& step : stand.light().steps) {
        hours.push_back(step.hour);
        incident.push_back(step.par.beam + step.par.diffuse);
    }
    {
        const Genome numbers = to_vector(genome);
        const nb::gil_scoped_release released;
        std::vector<Sensor> sensors;
        for (std::size_t i = 0; i < heights.size(); ++i)
            sensors.push_back({heights[i], positions.at(i)});
        for (const auto& sensor :
             stand.light_on_sensors(numbers, sensors, fields, points))
            for (const Estimate& estimate : sensor) {
                means.push_back(estimate.mean);
                errors.push_back(estimate.standard_error);
            }
    }
    return nb::make_tuple(to_array(hours, {hours.size()}),
                          to_array(incident, {hours.size()}),
                          to_array(means, {heights.size(), hours.size()}),
                          to_array(errors, {heights.size(), hours.size()}));
}

std::vector<std::string> warnings(const CaseStand& stand) {
    std::vector<std::string> texts;
    const Campaign& campaign = stand.campaign();
    for (const auto* problems : {&campaign.warnings, &campaign.outside_bounds})
        for (const Problem& each : *problems) texts.push_back(to_string(each));
    return texts;
}

//! Returns the key, its value and the values to try, for each accuracy key.
nb::list accuracy(const CaseStand& stand) {
    nb::list list;
    for (const AccuracyKey& each : accuracy_keys(stand.campaign().spec))
        list.append(nb::make_tuple(each.path, each.value, each.values));
    return list;
}

//! Returns, for each objective, its name, its unit and whether it is maximised.
nb::list objectives(const CaseStand& stand) {
    nb::list list;
    for (const Objective& each : stand.schema().objectives)
        list.append(nb::make_tuple(each.name, each.unit,
                                   each.sense == Sense::maximise));
    return list;
}

//! Returns, for each axis, its name, unit, meaning and coordinates.
nb::list axes(const CaseStand& stand) {
    nb::list list;
    for (const Axis& axis : stand.schema().measured.axes)
        list.append(nb::make_tuple(
            axis.name, axis.unit, axis.meaning,
            std::visit([](const auto& each) { return nb::cast(each); },
                       axis.coordinates)));
    return list;
}

//! Returns, for each quantity, its name, unit, meaning, axes and exactness, and
//! the category names of categorical quantities.
nb::list quantities(const CaseStand& stand) {
    nb::list list;
    for (const Quantity& quantity : stand.schema().measured.quantities)
        list.append(nb::make_tuple(
            quantity.name, quantity.unit, quantity.meaning, quantity.axes,
            quantity.certainty == Certainty::exact, quantity.names));
    return list;
}

}  // namespace

void bind_stand(nb::module_& module) {
    using Released = nb::call_guard<nb::gil_scoped_release>;
    module.def("case_names", &case_names, nb::arg("path"), nb::arg("settings"));
    nb::class_<CaseStand>(module, "CaseStand")
        .def_static("from_file", &from_file, Released(), nb::arg("path"),
                    nb::arg("case"), nb::arg("settings"), nb::arg("isa"))
        .def_static("from_text", &from_text, Released(), nb::arg("text"),
                    nb::arg("path"), nb::arg("case"), nb::arg("settings"),
                    nb::arg("isa"))
        .def_static("from_history", &from_history, Released(), nb::arg("text"),
                    nb::arg("path"), nb::arg("case"), nb::arg("genome"),
                    nb::arg("settings"), nb::arg("isa"))
        .def_prop_ro("name", [](const CaseStand& x) { return x.chosen().name; })
        .def_prop_ro("entries", &entries)
        .def_prop_ro(
            "key_count",
            [](const CaseStand& x) { return x.campaign().varied.keys.size(); })
        .def_prop_ro("isa", &CaseStand::isa)
        .def_prop_ro(
            "resolved",
            [](const CaseStand& x) { return resolved_text(x.campaign().spec); })
        .def_prop_ro("warnings", &warnings)
        .def_prop_ro("genes", &genes)
        .def_prop_ro("accuracy", &accuracy)
        .def_prop_ro("objectives", &objectives)
        .def_prop_ro("axes", &axes)
        .def_prop_ro("quantities", &quantities)
        .def("evaluate", &evaluate, nb::arg("genome"), nb::arg("generation"),
             nb::arg("is_final"), nb::arg("seed").none(),
             nb::arg("tolerance").none())
        .def_prop_ro(
            "components",
            [](const CaseStand& x) { return component_names(x.campaign()); })
        .def("mesh", &mesh, nb::arg("genome"), nb::arg("component"),
             nb::arg("thermal_time").none())
        .def("field_mesh",
             [](const CaseStand& x, const Input<double, 1>& genome) {
                 return mesh_tuple(x.field_mesh(to_vector(genome)));
             })
        .def_prop_ro(
            "scenarios",
            [](const CaseStand& x) { return names_of(scenarios(x.chosen())); })
        .def("light_on_sensors", &light_on_sensors)
        .def("season", &run_season, nb::arg("genome"),
             nb::arg("control").none())
        .def("crop_text", [](const CaseStand& x, const Input<double, 1>& genome,
                             std::size_t component) {
            return crop_text(x.campaign(),
                             x.grown(to_vector(genome)).at(component),
                             component);
        });
}

CaseStand::CaseStand(Campaign campaign, const Case& chosen,
                     const std::string& isa)
    : campaign_(std::move(campaign)),
      chosen_(chosen),
      stand_(campaign_, chosen_),
      devices_(isa.empty() ? Device::supported_isas().back() : isa) {
    // Fails if the instruction set is not supported.
    devices_.with([&](const Device& device) { stand_.prepare(device); });
}

Plants CaseStand::grown(const Genome& genome) const {
    Genome plain = genome;
    if (plain.size() == count_genes(campaign_) + campaign_.varied.keys.size())
        plain.resize(count_genes(campaign_));
    return grow(campaign_, plain);
}

std::unique_ptr<CaseStand> CaseStand::at_own_keys(Genome& genome) const {
    const std::size_t keys = campaign_.varied.keys.size();
    if (keys == 0 || genome.size() != count_genes(campaign_) + keys)
        return nullptr;
    return stand_at(campaign_, chosen_.name, genome, isa());
}

Outcome CaseStand::evaluate(const Genome& genome, const Task& task) {
    Genome plain = genome;
    if (const auto varied = at_own_keys(plain))
        return arranged_outcome(varied->evaluate(plain, task),
                                varied->stand_.schema(task.is_final),
                                stand_.schema(task.is_final));
    const Sampling sampling = sampling_of(task, campaign_, chosen_);
    OutcomeSchema schema = stand_.schema(task.is_final);
    schema.randomisations =
        static_cast<std::size_t>(sampling.accuracy.repetitions());
    try {
        const Plants plants = grow(campaign_, plain);
        return checked_outcome(schema, devices_.with([&](const Device& device) {
            return stand_.evaluate(plants, sampling, device);
        }));
    } catch (const Error& error) {
        return failed_outcome(schema, error.what());
    }
}

Mesh CaseStand::mesh(const Genome& genome, std::size_t component,
                     std::optional<double> thermal_time) const {
    if (component > 0 && component <= campaign_.components.size())
        if (const auto& mesh = campaign_.components[component - 1].mesh)
            return *mesh;
    Plant plant =
        at_density(campaign_, chosen_, component, grown(genome).at(component));
    if (thermal_time) {
        const Growth* growth = growth_of(campaign_, component);
        if (!growth)
            throw Error(
                "plants of this stand do not grow: their crop has no "
                "[growth]; leave thermal_time out");
        plant = age_plant(*growth, plant, *thermal_time);
    }
    return build_plant(plant, campaign_.spec.plant.tessellation);
}

Mesh CaseStand::field_mesh(const Genome& genome) const {
    Sampling sampling;
    sampling.randomness = {chosen_.seed};
    const CanopyRequest request =
        request_of(sampling, campaign_, chosen_, scene_of(campaign_, chosen_),
                   grown(genome));
    return draw_field(request.scene, request.randomness).mesh;
}

std::vector<std::vector<Estimate>> CaseStand::light_on_sensors(
    const Genome& genome, const std::vector<Sensor>& sensors, int fields,
    int points) {
    Genome plain = genome;
    if (const auto varied = at_own_keys(plain))
        return varied->light_on_sensors(plain, sensors, fields, points);
    Sampling sampling;
    sampling.accuracy = {1, fields};
    sampling.randomness = {chosen_.seed};
    const CanopyRequest request =
        request_of(sampling, campaign_, chosen_, scene_of(campaign_, chosen_),
                   grow(campaign_, plain));
    return devices_.with([&](const Device& device) {
        return ideotype::light_on_sensors(request, device, sensors, points);
    });
}

std::vector<SeasonState> CaseStand::season(const Genome& genome,
                                           const ControlDay& control) {
    Genome plain = genome;
    if (const auto varied = at_own_keys(plain))
        return varied->season(plain, control);
    if (!campaign_.spec.soil)
        throw Error(
            "the soil of this stand does not dry; add [soil] to its "
            "campaign");
    const Sampling sampling = sampling_of({}, campaign_, chosen_);
    return devices_.with([&](const Device& device) {
        return stand_.season(grow(campaign_, plain), sampling, device, control);
    });
}

LightSeries CaseStand::light() const {
    return light_of(campaign_, chosen_);
}

}  // namespace ideotype::python
