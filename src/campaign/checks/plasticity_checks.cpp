// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "checks.hpp"
#include "ideotype/crop/measures.hpp"

namespace ideotype {

namespace {

//! Checks the measures of one list of a response.
//! @param problems problems of the response
void check_measures(const std::string& key,
                    const std::vector<std::string>& names,
                    const DensityResponse& response, Plant plant,
                    const Problems& problems) {
    for (const std::string& name : names) {
        const auto measure = find_measure(plant, name);
        if (!measure) {
            problems.add(key, ProblemCode::unknown_name,
                         "response.{} names \"{}\" (the plant has no such "
                         "measure); {}",
                         key, name, did_you_mean(name, measure_names(plant)));
            continue;
        }
        problems.rule({key, "slope"},
                      !measure->is_of_leaves && response.slopes.size() > 1,
                      "response.slope has {} values for {} (which the plant "
                      "has once); give one value",
                      response.slopes.size(), name);
        problems.rule(
            {key}, follows_internodes(plant, name),
            "response.{} names {} (which follows from the internodes); name "
            "leaf.internode",
            key, name);
    }
}

}  // namespace

void check_plasticity(const CropSpec& crop, const Problems& problems) {
    const Plant& plant = crop.baseline;
    const Plasticity& plasticity = plant.plasticity;
    problems.rule({"plasticity.reference"},
                  !plasticity.responses.empty() && !(plasticity.reference > 0),
                  "plasticity.reference is not given (responses are relative "
                  "to this density); give the plants per m2 at which plants "
                  "have the measures of the file");
    const auto& [first, last] = plasticity.turning;
    problems.rule({"plasticity.turning", "plasticity.turn"},
                  plasticity.turn > 0 && !(first > 0 && first < last),
                  "plasticity.turning is {} .. {} (leaves turn by {} between "
                  "two densities); give the density at which they begin to "
                  "turn and a higher one",
                  first, last, plasticity.turn);
    for (std::size_t i = 0; i < plasticity.responses.size(); ++i) {
        const DensityResponse& response = plasticity.responses[i];
        const Problems of_response = problems.in("response", i);
        of_response.rule({"scales", "shifts"},
                         response.scales.empty() && response.shifts.empty(),
                         "response has neither scales nor shifts (so that it "
                         "has no effect); name measures in one of them");
        check_measures("scales", response.scales, response, plant, of_response);
        check_measures("shifts", response.shifts, response, plant, of_response);
    }
}

void doubt_densities(const Spec& spec, const Problems& problems) {
    const auto warn = [&](const CropSpec& crop, const std::string& name) {
        if (!crop.is_known || !spec.plant.is_plastic) return;
        Range known{0, 0};
        for (const DensityResponse& each : crop.baseline.plasticity.responses)
            if (each.densities.lower < each.densities.upper)
                known =
                    known.upper == 0
                        ? each.densities
                        : Range{std::max(known.lower, each.densities.lower),
                                std::min(known.upper, each.densities.upper)};
        if (known.upper == 0) return;
        for (std::size_t i = 0; i < spec.spacings.size(); ++i) {
            const Spacing& spacing = spec.spacings[i].value;
            const double density = spacing.plants_per_area();
            problems.in("spacing", i)
                .doubt(
                    {"row", "plant"},
                    density < known.lower || density > known.upper,
                    "spacing \"{}\" has {:.3g} plants m-2 (responses of {} to "
                    "density are known from {:.3g} to {:.3g}); plants are as "
                    "at "
                    "the nearest of them",
                    spec.spacings[i].name, density, name, known.lower,
                    known.upper);
        }
    };
    warn(spec.plant.crop, spec.plant.crop.baseline.name);
    for (const ComponentSpec& component : spec.components)
        if (!component.has_mesh()) warn(component.crop, component.name);
}

}  // namespace ideotype
