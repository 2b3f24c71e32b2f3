// SPDX-License-Identifier: Apache-2.0
#include "ideotype/canopy/sensors.hpp"

#include <cmath>

#include "ideotype/canopy/canopy.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/random.hpp"
#include "ideotype/light/backward.hpp"

namespace ideotype {

namespace {

//! Adds the light on a point at each instant, relative to light above the
//! canopy. The light of each source is given relative to level ground.
void add_instants(const SeriesIllumination& light,
                  const std::vector<double>& sources,
                  std::vector<double>& sums) {
    const auto of = [&](int source) {
        return source < 0 ? 0 : sources[static_cast<std::size_t>(source)];
    };
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const auto [beam, diffuse] = light.series.steps[i].par;
        if (beam + diffuse > 0)
            sums[i] +=
                (beam * of(light.beam_of[i]) + diffuse * of(light.sky_of[i])) /
                (beam + diffuse);
    }
}

}  // namespace

std::vector<std::vector<Estimate>> light_on_sensors(
    const CanopyRequest& request, const Device& device,
    std::span<const Sensor> sensors, int points) {
    IDEOTYPE_EXPECT(points > 0);
    const Scene& scene = request.scene;
    const Cell& cell = scene.cell;
    const int fields = request.accuracy.randomisations;
    if (cell.rows.empty() || fields < 2)
        throw Error(
            "sensors need plants in rows and two fields or more (from "
            "which their errors follow); ask for two randomisations or more");
    const SeriesIllumination& light = scene.light();
    const std::size_t steps = light.series.steps.size();
    // [sensor, instant, field]
    std::vector found(sensors.size(),
                      std::vector(steps, std::vector<double>()));
    Randomness randomness = request.randomness;
    for (int f = 0; f < fields; ++f, ++randomness.first_randomisation) {
        const Field field = draw_field(scene, randomness);
        const RayScene surfaces = build_scene(device, field);
        const BackwardLight backward(surfaces, field.mesh.groups,
                                     scene.bands.front().optics,
                                     light.light.sources);
        RandomStream random(randomness.seed, Purpose::backward,
                            randomness.generation,
                            randomness.first_randomisation);
        for (std::size_t s = 0; s < sensors.size(); ++s) {
            std::vector<double> sums(steps);
            for (int i = 0; i < points; ++i) {
                const double row = cell.rows[random.below(
                    static_cast<std::uint32_t>(cell.rows.size()))];
                // The side of the row is random, since the mean over both sides
                // is wanted.
                const double side = random.bits() % 2 == 0 ? 1 : -1;
                const double across = random.uniform(0, cell.row_distance);
                const double position = sensors[s].position;
                const glm::dvec3 place{
                    row + side * (std::isnan(position) ? across : position),
                    random.uniform(0, cell.period_y), sensors[s].height};
                std::vector<double> sources(light.light.sources.size());
                backward.add_level(place, random, sources);
                add_instants(light, sources, sums);
            }
            for (std::size_t i = 0; i < steps; ++i)
                found[s][i].push_back(sums[i] / points);
        }
    }
    std::vector<std::vector<Estimate>> estimates(sensors.size());
    for (std::size_t s = 0; s < sensors.size(); ++s)
        for (const std::vector<double>& by_field : found[s])
            estimates[s].push_back(estimate(by_field));
    return estimates;
}

}  // namespace ideotype
