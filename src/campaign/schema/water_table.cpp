// SPDX-License-Identifier: Apache-2.0
#include "water_table.hpp"

#include "campaign/problems.hpp"
#include "schema.hpp"

namespace ideotype {

Section water_section(WaterTable& table) {
    LeafWater& rules = table.rules;
    return {"water",
            {{"leaf_temperature", &rules.has_leaf_temperature},
             {"canopy_air", &rules.has_canopy_air},
             {"stomata", choice(table.model,
                                {{"medlyn", Stomata::Model::medlyn},
                                 {"ball_berry", Stomata::Model::ball_berry}})},
             {"slope", &table.slope},
             {"intercept", &table.intercept},
             {"emissivity", &rules.emissivity},
             {"stomatal_ratio", &rules.stomatal_ratio},
             {"wind_attenuation", &rules.wind_attenuation},
             {"hot", &rules.hot},
             {"limit", &table.limit}}};
}

Stomata to_stomata(const WaterTable& table,
                   const Photosynthesis& photosynthesis) {
    Stomata result{table.model};
    const bool is_medlyn = table.model == Stomata::Model::medlyn;
    const auto* c3 = std::get_if<FarquharLeaf>(&photosynthesis.rates.front());
    result.intercept = table.intercept.value_or(is_medlyn ? 0.01 : 0.017);
    result.slope = table.slope.value_or(is_medlyn ? (c3 ? c3->g1 : 1.6) : 4.53);
    return result;
}

void check_water(const Draft& draft, const Problems& problems) {
    if (!draft.has_water) return;
    const auto check = [](const Draft& kind, const Problems& own,
                          const std::string& whose) {
        if (kind.photosynthesis.model == LeafModel::hyperbola)
            own.add("photosynthesis.model",
                    "photosynthesis.model{} is \"hyperbola\", which does not "
                    "follow CO2 (leaves exchange water in [water]); use "
                    "\"collatz\" or \"farquhar\"",
                    whose);
    };
    check(draft, problems, "");
    for (std::size_t i = 0; i < draft.components.size(); ++i) {
        const Draft& each = *draft.components[i];
        check(each, problems.in("component", i),
              " of component \"" + each.campaign.name + "\"");
    }
}

}  // namespace ideotype
