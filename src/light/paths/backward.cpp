// SPDX-License-Identifier: Apache-2.0
#include "ideotype/light/backward.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "beams/directions.hpp"
#include "ideotype/core/contract.hpp"
#include "travel.hpp"

namespace ideotype {

namespace {

//! Returns whether a surface sees the sky on the side of a normal.
bool sees_sky(const RayScene& scene, const glm::dvec3& position,
              const glm::dvec3& normal, const glm::dvec3& direction,
              std::uint32_t pose) {
    return travel(scene, scene.offset_origin(position, normal), direction, pose)
               .group == Hit::sky;
}

glm::dvec3 on_side_of(const glm::dvec3& direction, const glm::dvec3& normal) {
    return glm::dot(normal, direction) < 0 ? -normal : normal;
}

}  // namespace

bool is_lit(const RayScene& scene, const LeafPoint& point,
            const glm::dvec3& travel, std::uint32_t pose) {
    const glm::dvec3 sun = -not_level(travel);
    return !point.is_hidden &&
           sees_sky(scene, scene.placed(point.position),
                    on_side_of(sun, point.normal), sun, pose);
}

BackwardLight::BackwardLight(const RayScene& scene,
                             const std::vector<Group>& groups,
                             const Optics& optics,
                             const std::vector<Source>& sources)
    : scene_(scene),
      groups_(groups),
      sources_(sources),
      optics_(optics),
      soil_{optics.soil_albedo, 0} {
    for (const Source& source : sources)
        if (std::ranges::find(poses_, source.pose) == poses_.end())
            poses_.push_back(source.pose);
}

double BackwardLight::beam(const LeafPoint& point, std::size_t source) const {
    IDEOTYPE_EXPECT(source < sources_.size() && sources_[source].direction);
    const glm::dvec3 d = not_level(*sources_[source].direction);
    const double cosine = glm::dot(point.normal, d) / d.z;
    return is_lit(scene_, point, d, sources_[source].pose)
               ? weight(point, cosine > 0) * std::abs(cosine)
               : 0;
}

double BackwardLight::weight(const LeafPoint& point, bool is_adaxial) const {
    IDEOTYPE_EXPECT(point.group < groups_.size());
    const Material& leaf = optics_.of(groups_[point.group].material);
    const double most = leaf.most_absorbed();
    return most > 0 ? (1 - leaf.face(is_adaxial).scattered()) / most : 1;
}

void BackwardLight::add_diffuse(const LeafPoint& point, RandomStream& random,
                                std::vector<double>& light) const {
    IDEOTYPE_EXPECT(light.size() == sources_.size());
    if (point.is_hidden) return;
    for (const std::uint32_t pose : poses_)
        for (const double side : {1., -1.})
            follow(scene_.placed(point.position), side * point.normal,
                   weight(point, side > 0), pose, random, light);
}

void BackwardLight::add_level(const glm::dvec3& place, RandomStream& random,
                              std::vector<double>& light) const {
    IDEOTYPE_EXPECT(light.size() == sources_.size());
    static constexpr glm::dvec3 up{0, 0, 1};
    for (const std::uint32_t pose : poses_) {
        // Without a surface at this point, the whole beam passes through.
        add_beams(scene_.placed(place), up, {1, 0}, 1, pose, light);
        follow(scene_.placed(place), up, 1, pose, random, light);
    }
}

void BackwardLight::follow(glm::dvec3 position, glm::dvec3 normal,
                           double weight, std::uint32_t pose,
                           RandomStream& random,
                           std::vector<double>& light) const {
    // Directions follow Lambert's law and paths end with the matching
    // probability, so that all light found by a path has equal weight.
    for (;;) {
        const double u = random.uniform();
        const glm::dvec3 d = lambertian(normal, u, random.uniform());
        const Hit hit =
            travel(scene_, scene_.offset_origin(position, normal), d, pose);
        if (hit.group == Hit::sky) {
            for (std::size_t s = 0; s < sources_.size(); ++s)
                if (!sources_[s].direction && sources_[s].pose == pose)
                    light[s] +=
                        weight * sources_[s].sky.relative_brightness(-d);
            return;
        }
        const Lambertian& met = surface(hit.group, glm::dot(d, hit.normal) < 0);
        if (met.scattered() == 0) return;
        position = hit.position;
        normal = on_side_of(-d, hit.normal);
        add_beams(position, normal, met, weight, pose, light);
        const double choice = random.uniform();
        if (choice >= met.scattered()) return;
        if (choice >= met.reflectance) normal = -normal;
    }
}

void BackwardLight::add_beams(const glm::dvec3& position,
                              const glm::dvec3& normal,
                              const Lambertian& surface, double weight,
                              std::uint32_t pose,
                              std::vector<double>& light) const {
    for (std::size_t s = 0; s < sources_.size(); ++s) {
        if (!sources_[s].direction || sources_[s].pose != pose) continue;
        const glm::dvec3 sun = -not_level(*sources_[s].direction);
        const double cosine = glm::dot(normal, sun);
        const double part =
            cosine > 0 ? surface.reflectance : surface.transmittance;
        if (part > 0 &&
            sees_sky(scene_, position, on_side_of(sun, normal), sun, pose))
            light[s] += weight * part * std::abs(cosine) / sun.z;
    }
}

}  // namespace ideotype
