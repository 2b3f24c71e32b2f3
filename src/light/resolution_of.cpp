// SPDX-License-Identifier: Apache-2.0
#include "resolution_of.hpp"

#include <algorithm>
#include <utility>

namespace ideotype {

namespace {

double scattered_part(const Lambertian& surface) {
    return surface.reflectance + surface.transmittance;
}

}  // namespace

Resolution resolution_of(const Scene& scene, const std::vector<Group>& groups,
                         const Optics& optics, const Layers& layers,
                         std::vector<double> path_energy) {
    Resolution result;
    result.path_energy = std::move(path_energy);
    result.groups.resize(groups.size());
    result.layers.resize(layers.count);
    // Light ends in groups that absorb, in soil that absorbs, or, if anything
    // scatters it, in the sky.
    bool scatters = optics.soil_albedo > 0;
    const double soil_keeps = 1 - optics.soil_albedo;
    std::size_t absorbing_leaves = 0, absorbing_stalks = 0;
    double leaves_keep = 0, stalks_keep = 0;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const std::optional<Heights> heights = scene.heights(g);
        if (!heights) continue;
        const bool is_leaf = groups[g].tissue == Tissue::leaf;
        const double scattered = scattered_part(optics.of(groups[g].tissue));
        scatters |= scattered > 0;
        if (!(scattered < 1)) continue;
        const double kept = 1 - scattered;
        result.groups[g] = kept;
        ++(is_leaf ? absorbing_leaves : absorbing_stalks);
        double& most = is_leaf ? leaves_keep : stalks_keep;
        most = std::max(most, kept);
        if (!is_leaf) continue;
        for (std::size_t l = layers.at(heights->lower);
             l <= layers.at(heights->upper); ++l)
            result.layers[l] = std::max(result.layers[l], kept);
    }
    const std::size_t ends = absorbing_leaves + absorbing_stalks +
                             (soil_keeps > 0 ? 1 : 0) + (scatters ? 1 : 0);
    // Where light can end, and could have ended elsewhere.
    const auto is_open = [ends](std::size_t own) {
        return own > 0 && ends > own;
    };
    if (is_open(absorbing_leaves)) result.leaves = leaves_keep;
    if (is_open(absorbing_stalks)) result.stalks = stalks_keep;
    if (is_open(1)) result.soil = soil_keeps;
    if (scatters && is_open(1)) result.reflected = 1;
    if (result.leaves > 0 || scatters) result.unscattered = leaves_keep;
    if (scatters) result.scattered = leaves_keep;
    if (!is_open(1)) result.groups.assign(groups.size(), 0);
    return result;
}

}  // namespace ideotype
