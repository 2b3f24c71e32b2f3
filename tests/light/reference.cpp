// SPDX-License-Identifier: Apache-2.0
#include "reference.hpp"

#include <algorithm>
#include <cmath>

#include "ideotype/crop/obj_reader.hpp"

namespace ideotype {

const Device& widest_device() {
    static const Device device(Device::supported_isas().back());
    return device;
}

Mesh load_reference_mesh(const std::string& name) {
    return read_obj(std::string(IDEOTYPE_MESHES) + "/" + name + ".obj").mesh;
}

Illumination sun_from(double elevation, double azimuth) {
    return {{{beam_direction({90 - elevation, azimuth}), 1.0, {}}}};
}

Illumination sky_of(const SkyRadiance& sky) {
    return {{{std::nullopt, 1.0, SkySampler(sky)}}};
}

Illumination uniform_sky() {
    return sky_of({SkyModel::uniform, {}});
}

Illumination overcast_sky() {
    return sky_of({SkyModel::overcast, {}});
}

Fractions fractions_of(const std::vector<Tally>& tallies, std::size_t groups,
                       double incident) {
    Fractions result;
    const auto over = [&](auto figure) {
        std::vector<double> replicates;
        for (const Tally& tally : tallies)
            replicates.push_back(figure(tally) / incident);
        return estimate(replicates);
    };
    const auto part = [&](double Budget::*member) {
        return over([member](const Tally& tally) {
            double sum = 0;
            for (const Budget& b : tally.sources) sum += b.*member;
            return sum;
        });
    };
    result.leaves = part(&Budget::leaves);
    result.soil = part(&Budget::soil);
    result.reflected = part(&Budget::reflected);
    for (std::size_t g = 0; g < groups; ++g)
        result.groups.push_back(
            over([g](const Tally& tally) { return tally.groups[g]; }));
    for (const Tally& tally : tallies) {
        double sum = 0;
        for (const Budget& b : tally.sources) sum += b.total();
        result.balance_error =
            std::max(result.balance_error, std::abs(sum / incident - 1));
    }
    return result;
}

Fractions trace(const Mesh& mesh, GroundPeriod period, const Optics& optics,
                const Illumination& light, Accuracy accuracy,
                std::uint64_t seed) {
    const RayScene scene(widest_device(), mesh, period.x, period.y);
    return fractions_of(
        simulate(scene, mesh.groups, optics, light, accuracy, {seed, 0, 0}),
        mesh.groups.size(), light.energy());
}

Optics leaf_optics(double reflectance, double transmittance,
                   double soil_albedo) {
    return {{{reflectance, transmittance}}, soil_albedo};
}

double deviation(Estimate ours, Estimate reference) {
    // Exact values are compared to within rounding.
    return (ours.mean - reference.mean) /
           (std::hypot(ours.standard_error, reference.standard_error) + 1e-12);
}

void add_sheet(Mesh& mesh, GroundPeriod period, double height,
               std::uint32_t group) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {{0, 0, height},
                                               {period.x, 0, height},
                                               {period.x, period.y, height},
                                               {0, period.y, height}});
    mesh.faces.push_back({first, first + 1, first + 2, first + 3});
    mesh.face_group.push_back(group);
}

}  // namespace ideotype
