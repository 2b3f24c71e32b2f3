// SPDX-License-Identifier: Apache-2.0
#include "ideotype/light/sunlit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

#include "ideotype/core/contract.hpp"
#include "ideotype/light/backward.hpp"
#include "ideotype/light/leaf_points.hpp"
#include "ideotype/light/report.hpp"
#include "ideotype/light/sampler.hpp"

namespace ideotype {

SunlitFractions sunlit_fractions(const RayScene& scene, const Mesh& mesh,
                                 const Illumination& illumination,
                                 const Accuracy& accuracy,
                                 const Randomness& randomness) {
    IDEOTYPE_EXPECT(accuracy.paths > 0 && accuracy.randomisations > 0);
    const std::vector<Source>& sources = illumination.sources;
    const LeafPoints leaves(mesh);
    const auto points = static_cast<std::uint32_t>(accuracy.paths);
    SunlitFractions result;
    result.fractions.assign(static_cast<std::size_t>(accuracy.randomisations),
                            std::vector<double>(sources.size()));
    result.steps.resize(sources.size());
    if (!(leaves.area() > 0)) return result;
    const double step = 1. / points;
    result.steps.assign(sources.size(), step);
    auto randomisation = randomness.first_randomisation;
    for (std::vector<double>& fractions : result.fractions) {
        PathSampler sampler(randomness.seed, randomness.generation,
                            randomisation++, 0);
        for (std::uint32_t i = 0; i < points; ++i) {
            sampler.begin(i);
            const double share = sampler.next();
            const double s = sampler.next();
            const LeafPoint point = leaves.at(share, s, sampler.next());
            const double part = own_part(scene, point);
            for (std::size_t k = 0; k < sources.size(); ++k) {
                const auto& beam = sources[k].direction;
                if (beam && part > 0 &&
                    is_lit(scene, point, *beam, sources[k].pose))
                    fractions[k] += part * step;
            }
        }
    }
    return result;
}

namespace {

//! The smallest cosine between a leaf's normal and the sun that is counted. A
//! hit on a leaf edge-on to the sun would represent an infinite leaf area. With
//! this bound, hits miss less than a thousandth of the leaf area.
constexpr double least_cosine = 1e-3;

}  // namespace

SunlitFractions sunlit_fractions(const std::vector<Tally>& tallies,
                                 const RayScene& scene,
                                 const std::vector<Group>& groups,
                                 const Optics& optics,
                                 const Illumination& illumination,
                                 double leaf_area) {
    const std::vector<Source>& sources = illumination.sources;
    SunlitFractions result;
    result.fractions.assign(tallies.size(),
                            std::vector<double>(sources.size()));
    result.steps.resize(sources.size());
    if (!(leaf_area > 0)) return result;
    for (std::size_t s = 0; s < sources.size(); ++s) {
        const auto& sun = sources[s].direction;
        if (!sun || !(sources[s].energy > 0)) continue;
        const double share =
            scene.ground_area() / (leaf_area * sources[s].energy);
        for (std::size_t r = 0; r < tallies.size(); ++r)
            for (const auto& [triangle, energy] :
                 tallies[r].leaf_light[s].beam) {
                const std::uint32_t group =
                    scene.surfaces().face_group[triangle / 2];
                if (!groups[group].id.is_leaf()) continue;
                result.fractions[r][s] +=
                    share * energy /
                    (beam_absorptance(scene, groups, optics, triangle, *sun) *
                     std::max(beam_cosine(scene, triangle, *sun),
                              least_cosine));
            }
        IDEOTYPE_EXPECT(tallies.front().resolution != nullptr);
        result.steps[s] = share * tallies.front().resolution->path_energy[s];
    }
    return result;
}

double beam_absorptance(const RayScene& scene, const std::vector<Group>& groups,
                        const Optics& optics, std::uint32_t triangle,
                        const glm::dvec3& direction) {
    const Surfaces& all = scene.surfaces();
    IDEOTYPE_EXPECT(triangle < all.normals.size());
    const bool is_adaxial = glm::dot(all.normals[triangle], direction) < 0;
    const Group& group = groups[all.face_group[triangle / 2]];
    return 1 - optics.of(group.material).face(is_adaxial).scattered();
}

double beam_cosine(const RayScene& scene, std::uint32_t triangle,
                   const glm::dvec3& direction) {
    IDEOTYPE_EXPECT(triangle < scene.surfaces().normals.size());
    return std::abs(glm::dot(scene.surfaces().normals[triangle], direction) /
                    direction.z);
}

SunlitReport report(const SunlitFractions& sunlit,
                    const SeriesIllumination& illumination) {
    const LightSeries& series = illumination.series;
    IDEOTYPE_EXPECT(sunlit.steps.size() == illumination.light.sources.size());
    // Returns a weighted mean over steps by randomisation. Without any sun, the
    // mean and its error are exactly 0.
    const auto mean = [&](const std::vector<std::size_t>& steps,
                          const auto& weight,
                          std::vector<double>& randomisations) {
        randomisations.assign(sunlit.fractions.size(), 0);
        bool has_sun = false;
        double least = 0;
        for (const std::size_t i : steps) {
            if (illumination.beam_of[i] < 0) continue;
            has_sun = true;
            const auto beam = static_cast<std::size_t>(illumination.beam_of[i]);
            const double part = weight(series.steps[i]);
            least = std::max(least, part * sunlit.steps[beam]);
            for (std::size_t r = 0; r < randomisations.size(); ++r)
                randomisations[r] += part * sunlit.fractions[r][beam];
        }
        return has_sun ? at_least(
                             estimate(randomisations),
                             least / static_cast<double>(randomisations.size()))
                       : Estimate{};
    };
    SunlitReport result;
    std::vector<double> of_hour;
    for (const std::vector<std::size_t>& steps : series.steps_of_hours())
        result.hours.push_back(mean(
            steps, [&](const TimeStep&) { return 1. / series.days; }, of_hour));
    const double lit = series.lit_seconds();
    std::vector<std::size_t> all(series.steps.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    result.mean = mean(
        all, [&](const TimeStep& step) { return step.seconds / lit; },
        result.mean_by_randomisation);
    return result;
}

}  // namespace ideotype
