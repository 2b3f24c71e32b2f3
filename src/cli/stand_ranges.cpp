// SPDX-License-Identifier: Apache-2.0
#include "stand_ranges.hpp"

#include <set>
#include <utility>

#include "stand/stand.hpp"

namespace ideotype {

Stands stands_of(const Campaign& campaign, double leaf_area) {
    Stands all;
    for (const auto& [name, spacing] : campaign.spacings) {
        all.period_x.add(campaign.field.rows * spacing.row);
        all.period_y.add(campaign.field.plants * spacing.plant);
        all.lai.add(leaf_area / (spacing.row * spacing.plant));
    }
    std::set<std::pair<std::string, std::string>> seen;
    for (const Case& one : cases(campaign))
        for (const Case& each : scenarios(one)) {
            if (!seen.emplace(each.site.name, each.day_name).second) continue;
            const LightSeries light = light_of(campaign, each);
            all.steps.add(static_cast<double>(light.steps.size()));
            all.par.add(light.incident());
            all.diffuse.add(light.diffuse() / light.incident());
        }
    return all;
}

}  // namespace ideotype
