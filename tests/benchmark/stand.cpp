// SPDX-License-Identifier: Apache-2.0
#include "stand.hpp"

namespace ideotype {

Campaign BenchStand::ames() {
    return read_campaign(IDEOTYPE_CAMPAIGNS "/ames.toml");
}

BenchStand::BenchStand(Campaign changed)
    : campaign(std::move(changed)),
      chosen(cases(campaign).front()),
      baseline(baseline_genome(campaign)),
      request(request_of(sampling_of(Task{}, campaign, chosen), campaign,
                         chosen, scene_of(campaign, chosen),
                         {campaign.crop.baseline})),
      device(Device::supported_isas().back()) {}

Field BenchStand::field(const Genome& genome) const {
    Scene scene = request.scene;
    set_plant(scene.components.front(), grow(campaign.crop, genome));
    return draw_field(scene, request.randomness);
}

RayScene BenchStand::scene(const Field& field) const {
    return build_scene(device, field);
}

double relative_error(const CanopyReport& report) {
    const Estimate& leaves = report.par().light.day.leaves;
    return leaves.standard_error / leaves.mean;
}

}  // namespace ideotype
