// SPDX-License-Identifier: Apache-2.0
#include "ideotype/light/resolution.hpp"

#include <algorithm>
#include <utility>

#include "ideotype/core/contract.hpp"
#include "resolution_of.hpp"

namespace ideotype {

Resolution combined(const Resolution& a, const Resolution& b) {
    IDEOTYPE_EXPECT(a.path_energy.size() == b.path_energy.size());
    IDEOTYPE_EXPECT(a.groups.size() == b.groups.size());
    IDEOTYPE_EXPECT(a.layers.size() == b.layers.size());
    Resolution both = a;
    for (std::size_t i = 0; i < b.path_energy.size(); ++i)
        both.path_energy[i] = std::max(a.path_energy[i], b.path_energy[i]);
    for (double Resolution::*part :
         {&Resolution::leaves, &Resolution::organs, &Resolution::objects,
          &Resolution::soil, &Resolution::reflected, &Resolution::unscattered,
          &Resolution::scattered})
        both.*part = std::max(a.*part, b.*part);
    for (std::size_t i = 0; i < b.groups.size(); ++i)
        both.groups[i] = std::max(a.groups[i], b.groups[i]);
    for (std::size_t i = 0; i < b.layers.size(); ++i)
        both.layers[i] = std::max(a.layers[i], b.layers[i]);
    return both;
}

Estimate at_least(Estimate x, double standard_error) {
    return {x.mean, std::max(x.standard_error, standard_error)};
}

Resolution resolution_of(const RayScene& scene,
                         const std::vector<Group>& groups, const Optics& optics,
                         const Layers& layers,
                         std::vector<double> path_energy) {
    IDEOTYPE_EXPECT(optics.soil_albedo >= 0 && optics.soil_albedo <= 1);
    Resolution result;
    result.path_energy = std::move(path_energy);
    result.groups.resize(groups.size());
    result.layers.resize(layers.count);
    // Light ends in absorbing groups, in absorbing soil or, if any surface
    // scatters light, in the sky.
    bool scatters = optics.soil_albedo > 0;
    const double soil_keeps = 1 - optics.soil_albedo;
    struct Kind {
        std::size_t absorbing = 0;  //!< number of absorbing groups
        double keeps = 0;           //!< largest fraction that a group absorbs
    } leaves, organs, objects;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const Interval heights = scene.heights(g);
        if (heights.lower > heights.upper) continue;
        const SurfaceId& id = groups[g].id;
        const Material& material = optics.of(groups[g].material);
        scatters |= material.most_scattered() > 0;
        const double kept = material.most_absorbed();
        if (!(kept > 0)) continue;
        result.groups[g] = kept;
        Kind& kind = id.is_leaf() ? leaves : id.is_object() ? objects : organs;
        ++kind.absorbing;
        kind.keeps = std::max(kind.keeps, kept);
        if (!id.is_leaf()) continue;
        for (std::size_t l = layers.at(heights.lower);
             l <= layers.at(heights.upper); ++l)
            result.layers[l] = std::max(result.layers[l], kept);
    }
    const std::size_t ends = leaves.absorbing + organs.absorbing +
                             objects.absorbing + (soil_keeps > 0 ? 1 : 0) +
                             (scatters ? 1 : 0);
    // A figure is open if light can end there but could also end elsewhere.
    const auto is_open = [ends](std::size_t own) {
        return own > 0 && ends > own;
    };
    if (is_open(leaves.absorbing)) result.leaves = leaves.keeps;
    if (is_open(organs.absorbing)) result.organs = organs.keeps;
    if (is_open(objects.absorbing)) result.objects = objects.keeps;
    if (is_open(1)) result.soil = soil_keeps;
    if (scatters && is_open(1)) result.reflected = 1;
    if (result.leaves > 0 || scatters) result.unscattered = leaves.keeps;
    if (scatters) result.scattered = leaves.keeps;
    if (!is_open(1)) result.groups.assign(groups.size(), 0);
    return result;
}

}  // namespace ideotype
