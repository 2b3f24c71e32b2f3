// SPDX-License-Identifier: Apache-2.0
#include "water_table.hpp"

#include <fmt/format.h>

#include "checks.hpp"
#include "ideotype/canopy/quantities.hpp"
#include "schema.hpp"

namespace ideotype {

Section water_section(WaterTable& table) {
    LeafWater& rules = table.rules;
    Section keys{"water"};
    keys.add("leaf_temperature", rules.has_leaf_temperature,
             "whether leaves have a temperature of their own, by their energy "
             "balance; else they have that of the air, and assimilate as "
             "without this table");
    keys.add("canopy_air", rules.has_canopy_air,
             "whether the canopy warms and moistens the air among its leaves; "
             "else that is the air above");
    keys.add("stomata", table.model,
             {{"medlyn", Stomata::Model::medlyn},
              {"ball_berry", Stomata::Model::ball_berry}},
             "model of stomata: that of Medlyn et al. 2011, or that of Ball, "
             "Woodrow and Berry 1987");
    keys.add("slope", table.slope, {0.01, 50},
             "of the conductance of stomata with assimilation over CO2")
        .defaults(
            "by Medlyn 1.6 of C4 leaves and photosynthesis.g1 of C3 leaves "
            "[kPa^0.5], by Ball and Berry 4.53");
    keys.add("intercept", table.intercept, {0, 1, "mol m-2 s-1"},
             "conductance of stomata without assimilation")
        .defaults("0.01 by Medlyn, 0.017 by Ball and Berry");
    keys.add("emissivity", rules.emissivity, {0.5, 1},
             "of leaves for longwave radiation");
    keys.add("stomatal_ratio", rules.stomatal_ratio, {0, 1000},
             "conductance of the lower face over that of the upper face");
    keys.add("wind_attenuation", rules.wind_attenuation, {0, 10},
             "how fast wind falls within the canopy: a in exp(-a (1 - z / h))");
    keys.add("hot", rules.hot, {0, 60, "deg C"},
             "temperature above which the time of leaves counts as hot");
    keys.add("limit", table.limit, {0, 1e5, "mm"},
             "water that plants may transpire on all days; those that need "
             "more are not feasible; 0: any");
    return keys;
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
    if (!draft.has_water) {
        for (const auto& [key, name] : objective_keys(draft.campaign, problems))
            if (is_of_water(name))
                problems.add(key,
                             "the objective {} is of leaves that transpire; "
                             "add [water]",
                             name);
        return;
    }
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
