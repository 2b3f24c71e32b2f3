#include "stand.hpp"

namespace ideotype {

Campaign Stand::ames() {
    return read_campaign(IDEOTYPE_CAMPAIGNS "/ames.toml");
}

Stand::Stand(Campaign changed)
    : campaign(std::move(changed)),
      chosen(cases(campaign).front()),
      baseline(baseline_numbers(campaign.crop)),
      request(request_of({}, campaign, chosen, scenario_of(campaign, chosen),
                         campaign.crop.baseline)),
      device(Device::supported_isas().back()) {}

Field Stand::field(const Genome& genome) const {
    return draw_field(
        build_plant(grow(campaign.crop, genome), campaign.tessellation),
        request.scenario.field, request.randomness);
}

Scene Stand::scene(const Field& field) const {
    return build_scene(device, field);
}

double relative_error(const CanopyReport& report) {
    const Estimate& leaves = report.light.day.leaves;
    return leaves.standard_error / leaves.mean;
}

}  // namespace ideotype
