// SPDX-License-Identifier: Apache-2.0
#include "ideotype/crop/grain.hpp"

#include <algorithm>

namespace ideotype {

double kernels_per_plant(const Grain& grain, double growth) {
    if (grain.rule == KernelRule::andrade) {
        constexpr double threshold = 1.17, saturation = 0.67;
        const double above = std::max(growth - threshold, 0.);
        return grain.kernels * above / (1 + saturation * above);
    }
    if (!(growth > 0)) return 0;
    constexpr double per_growth = 680. / 7200, fewest = 50;
    return std::min(grain.kernels,
                    grain.kernels * per_growth * growth + fewest);
}

double filling_rate(double temperature) {
    constexpr double coldest = 5.5, cool = 16, warm = 27, hottest = 35;
    if (temperature <= coldest || temperature >= hottest) return 0;
    return std::min({1., (temperature - coldest) / (cool - coldest),
                     (hottest - temperature) / (hottest - warm)});
}

void fill(double sink, double growth, Filling& filling) {
    const double taken =
        std::clamp(sink, 0., std::max(0., growth + filling.reserves));
    const double left = growth - taken;
    filling.grain += taken;
    if (left < 0) {
        // Maintenance that nothing else covers is paid by grain.
        filling.reserves += left;
        filling.grain += std::min(filling.reserves, 0.);
        filling.grain = std::max(filling.grain, 0.);
        filling.reserves = std::max(filling.reserves, 0.);
        return;
    }
    filling.reserves += left / 2;
    filling.surplus += left / 2;
}

}  // namespace ideotype
