#include "stand.hpp"

namespace ideotype {

Campaign Stand::ames() {
    return read_campaign(IDEOTYPE_CAMPAIGNS "/ames.toml");
}

Stand::Stand(Campaign changed)
    : campaign(std::move(changed)),
      chosen(cases(campaign).front()),
      model(canopy_model(campaign, chosen)),
      baseline(to_genome(campaign.baseline)),
      device(Device::supported_isas().back()) {}

Field Stand::field(const Genome& genome) const {
    return build_field(model, build_plant(model, to_traits(genome)),
                       {chosen.seed, 0, campaign.sampling}, 0);
}

Scene Stand::scene(const Field& field) const {
    return build_scene(device, field);
}

double relative_error(const CanopyReport& report) {
    const Estimate& leaves = report.light.day.leaves;
    return leaves.standard_error / leaves.mean;
}

}  // namespace ideotype
