// SPDX-License-Identifier: Apache-2.0
#include "water_table.hpp"

#include <fmt/format.h>

#include "checks.hpp"
#include "ideotype/canopy/quantities.hpp"
#include "schema.hpp"

namespace ideotype {

namespace {

Key number(const std::string& name, std::optional<double>& value,
           const std::string& initial, const std::string& meaning) {
    return Key(name, &value, meaning).set(&Key::initial, initial);
}

}  // namespace

Section water_section(WaterTable& table) {
    LeafWater& rules = table.rules;
    return {
        "water",
        {Key("leaf_temperature", &rules.has_leaf_temperature,
             "whether leaves have a temperature of their own, by their energy "
             "balance; else they have that of the air, and assimilate as "
             "without this table"),
         Key("canopy_air", &rules.has_canopy_air,
             "whether the canopy warms and moistens the air among its leaves; "
             "else that is the air above"),
         Key("stomata", choice(table.model),
             "model of stomata: that of Medlyn et al. 2011, or that of Ball, "
             "Woodrow and Berry 1987")
             .one_of({"medlyn", "ball_berry"}),
         number("slope", table.slope,
                "by Medlyn 1.6 of C4 leaves and photosynthesis.g1 of C3 "
                "leaves [kPa^0.5], by Ball and Berry 4.53",
                "of the conductance of stomata with assimilation over CO2")
             .within(0.01, 50),
         number("intercept", table.intercept,
                "0.01 by Medlyn, 0.017 by Ball and Berry",
                "conductance of stomata without assimilation")
             .within(0, 1, "mol m-2 s-1"),
         Key("emissivity", &rules.emissivity,
             "of leaves for longwave radiation")
             .within(0.5, 1),
         Key("stomatal_ratio", &rules.stomatal_ratio,
             "conductance of the lower face over that of the upper face")
             .within(0, 1000),
         Key("wind_attenuation", &rules.wind_attenuation,
             "how fast wind falls within the canopy: a in exp(-a (1 - z / h))")
             .within(0, 10),
         Key("hot", &rules.hot,
             "temperature above which the time of leaves counts as hot")
             .within(0, 60, "deg C"),
         Key("limit", &table.limit,
             "water that plants may transpire on all days; those that need "
             "more are not feasible; 0: any")
             .within(0, 1e5, "mm")}};
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

void check_water(const Draft& draft, Problems& problems) {
    const Campaign& campaign = draft.campaign;
    if (!draft.has_water) {
        for (const auto* list : {&campaign.maximised, &campaign.minimised})
            for (const std::string& each : *list)
                if (problems.usable({list}) && is_of_water(each))
                    problems.add(
                        list, fmt::format("the objective {} is of leaves that "
                                          "transpire; add [water]",
                                          each));
        return;
    }
    const auto check = [&](const Draft& kind, const std::string& whose) {
        if (kind.photosynthesis.model == LeafModel::hyperbola)
            problems.add(
                &kind.photosynthesis.model,
                fmt::format("photosynthesis.model{} is \"hyperbola\", which "
                            "does not follow CO2 (leaves exchange water in "
                            "[water]); use \"collatz\" or \"farquhar\"",
                            whose));
    };
    check(draft, "");
    for (const std::shared_ptr<Draft>& each : draft.components)
        check(*each, " of component \"" + each->campaign.name + "\"");
}

}  // namespace ideotype
