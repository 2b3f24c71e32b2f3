// SPDX-License-Identifier: Apache-2.0
#include "stand.hpp"

#include "campaign/stages.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype::python {

CaseStand::CaseStand(Campaign campaign, const Case& chosen,
                     const std::string& isa)
    : campaign_(std::move(campaign)),
      chosen_(chosen),
      stand_(campaign_, chosen_),
      devices_(isa.empty() ? Device::supported_isas().back() : isa) {
    devices_.with([](const Device&) {
    });  // checks that the processor has the instruction set
    stand_.prepare();
}

Outcome CaseStand::evaluate(const Genome& genome, const Task& task) {
    const Sampling sampling = sampling_of(task, campaign_, chosen_);
    OutcomeSchema schema = stand_.schema(task.is_final);
    schema.randomisations =
        static_cast<std::size_t>(sampling.accuracy.repetitions());
    try {
        const Plants plants = grow(campaign_, genome);
        return checked_outcome(schema, devices_.with([&](const Device& device) {
            return stand_.evaluate(plants, sampling, device);
        }));
    } catch (const Error& error) {
        return failed_outcome(schema, error.what());
    }
}

Mesh CaseStand::mesh(const Genome& genome, std::size_t component,
                     std::optional<double> thermal_time) const {
    Plant plant = grow(campaign_, genome).at(component);
    if (thermal_time) {
        const Growth* growth = growth_of(campaign_, component);
        if (!growth)
            throw Error(
                "plants of this stand do not grow: their crop has no "
                "[growth]; leave thermal_time out");
        plant = plant_at(*growth, plant, *thermal_time);
    }
    return build_plant(plant, campaign_.tessellation);
}

std::vector<std::vector<Estimate>> CaseStand::light_on_sensors(
    const Genome& genome, const std::vector<Sensor>& sensors, int fields,
    int points) {
    Sampling sampling;
    sampling.accuracy = {1, fields};
    sampling.randomness = {chosen_.seed};
    const CanopyRequest request =
        request_of(sampling, campaign_, chosen_, scene_of(campaign_, chosen_),
                   grow(campaign_, genome));
    return devices_.with([&](const Device& device) {
        return ideotype::light_on_sensors(request, device, sensors, points);
    });
}

LightSeries CaseStand::light() const {
    return light_of(campaign_, chosen_);
}

}  // namespace ideotype::python
