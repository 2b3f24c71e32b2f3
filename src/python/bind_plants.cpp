// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>

#include "bindings.hpp"
#include "ideotype/crop/measures.hpp"
#include "spec/files.hpp"
#include "stand.hpp"

namespace ideotype::python {

namespace {

//! The plant of the main crop, followed by plants of optimised components.
struct AnyPlants {
    Plants plants;
};

AnyPlants read_plant(const std::string& path) {
    return {{read_crop(path).baseline}};
}

//! Returns the texts of the built-in crop files, by name.
nb::dict known_crops() {
    nb::dict fields;
    for (const std::string& name : known_crop_names())
        fields[name.c_str()] = known_crop(name).value();
    return fields;
}

//! Returns name, unit and limits of each measure of a leaf.
nb::list measures_of_leaves() {
    nb::list leaves;
    for (const Measure<Leaf>& each : leaf_measures)
        leaves.append(nb::make_tuple(each.name, each.unit, each.limits.lower,
                                     each.limits.upper));
    return leaves;
}

AnyPlants grown_plants(const CaseStand& stand, const Input<double, 1>& genome) {
    return {stand.grown(to_vector(genome))};
}

//! Returns the largest height that any leaf of the plants can reach [m].
double reach_of(const AnyPlants& grown) {
    double top = 0;
    for (const Plant& plant : grown.plants)
        for (const Leaf& leaf : plant.leaves)
            top = std::max(top, furthest(plant, leaf));
    return top;
}

//! Returns the name, unit and values of each measure of leaves, the lowest leaf
//! first. Optional measures are left out if all their values are 0.
nb::list leaves_of(const AnyPlants& grown, std::size_t component) {
    const std::vector<Leaf>& leaves = grown.plants.at(component).leaves;
    nb::list list;
    for (std::size_t m = 0; m < leaf_measures.size(); ++m) {
        std::vector<double> values;
        for (const Leaf& leaf : leaves)
            values.push_back(leaf.*leaf_measures[m].value);
        if (m < usual_leaf_measures ||
            std::ranges::any_of(values, [](double x) { return x != 0; }))
            list.append(nb::make_tuple(leaf_measures[m].name,
                                       leaf_measures[m].unit,
                                       to_array(values, {values.size()})));
    }
    return list;
}

nb::tuple mesh_of(const AnyPlants& grown, const CaseStand& under,
                  std::size_t component) {
    if (component > 0)
        if (const auto& mesh =
                under.campaign().components.at(component - 1).mesh)
            return mesh_tuple(*mesh);
    return mesh_tuple(build_plant(grown.plants.at(component),
                                  under.campaign().spec.plant.tessellation));
}

//! Evaluates plants of any shape in one case of a campaign, or in one of the
//! case's scenarios. Several threads may evaluate at a time.
class PlantStand : public CaseStand {
  public:
    //! @param reach largest height of any leaf of the plants to be compared [m]
    //! @param scenario index of a scenario; if empty, all scenarios are
    //! combined
    PlantStand(const CaseStand& under, const AnyPlants& any, double reach,
               std::optional<std::size_t> scenario)
        : CaseStand(with(under.campaign(), any.plants, reach),
                    scenario ? scenarios(under.chosen()).at(*scenario)
                             : under.chosen(),
                    under.isa()),
          plants_(any.plants) {}

    //! Returns four arrays: objectives as estimates and by randomisation
    //! [objective, randomisation]; all values of quantities as estimates and by
    //! randomisation [randomisation, value]. Unknown numbers are NaN.
    //! @throws Error if the evaluation fails.
    nb::tuple evaluate(std::uint32_t generation, bool is_final,
                       std::optional<std::uint64_t> seed,
                       std::optional<double> tolerance) {
        RandomisedOutcome result;
        {
            const nb::gil_scoped_release released;
            const Sampling sampling = sampling_of({.generation = generation,
                                                   .is_final = is_final,
                                                   .seed = seed,
                                                   .tolerance = tolerance},
                                                  campaign_, chosen_);
            result = devices_.with([&](const Device& device) {
                return stand_.evaluate_by_randomisation(plants_, sampling,
                                                        device);
            });
        }
        const auto& [outcome, by_randomisation] = result;
        std::vector<double> numbers;
        for (const std::vector<double>& each : by_randomisation)
            numbers.insert(numbers.end(), each.begin(), each.end());
        const std::size_t count = by_randomisation.size();
        return nb::make_tuple(
            to_array(outcome.objectives),
            to_array(outcome.randomisations,
                     {outcome.objectives.size(), count}),
            to_array(outcome.quantities),
            to_array(numbers, {count, outcome.quantities.size()}));
    }

  private:
    static Campaign with(Campaign campaign, const Plants& plants,
                         double reach) {
        campaign.reach = std::max(campaign.reach, reach);
        for (std::size_t i = 0; i < plants.size(); ++i) {
            Crop& crop =
                i == 0 ? campaign.crop : campaign.components.at(i - 1).crop;
            crop.baseline = plants[i];
        }
        return campaign;
    }

    Plants plants_;
};

}  // namespace

void bind_plants(nb::module_& module) {
    using Released = nb::call_guard<nb::gil_scoped_release>;
    module.def("read_plant", &read_plant, nb::arg("path"));
    module.def("known_crops", &known_crops);
    module.def("leaf_measures", &measures_of_leaves);
    module.def("grown_plants", &grown_plants, nb::arg("stand"),
               nb::arg("genome"));
    nb::class_<AnyPlants>(module, "Plants")
        .def_prop_ro("name",
                     [](const AnyPlants& x) { return x.plants.front().name; })
        .def_prop_ro("reach", &reach_of)
        .def("leaves", &leaves_of, nb::arg("component"))
        .def("mesh", &mesh_of, nb::arg("under"), nb::arg("component"));
    nb::class_<PlantStand, CaseStand>(module, "PlantStand")
        .def(nb::init<const CaseStand&, const AnyPlants&, double,
                      std::optional<std::size_t>>(),
             Released(), nb::arg("under"), nb::arg("plants"), nb::arg("reach"),
             nb::arg("scenario").none())
        .def("evaluate", &PlantStand::evaluate, nb::arg("generation"),
             nb::arg("is_final"), nb::arg("seed").none(),
             nb::arg("tolerance").none());
}

}  // namespace ideotype::python
