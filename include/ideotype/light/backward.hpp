// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ideotype/core/random.hpp"
#include "ideotype/light/illumination.hpp"
#include "ideotype/light/leaf_points.hpp"
#include "ideotype/light/optics.hpp"
#include "ideotype/light/ray_scene.hpp"

namespace ideotype {

//! Returns whether light that travels in a direction reaches a point on a leaf
//! without meeting another surface.
//! @param pose orientation index of moving objects
bool is_lit(const RayScene& scene, const LeafPoint& point,
            const glm::dvec3& travel, std::uint32_t pose = 0);

//! Computes the light at points on leaves by tracing paths from the points back
//! to the light sources. Each point uses separate paths. Only the scene is
//! shared with the code for forward tracing. One path serves all sources that
//! use the same orientations of moving objects.
class BackwardLight {
  public:
    //! @param groups,sources objects that must outlive this one, as must the
    //! scene
    BackwardLight(const RayScene& scene, const std::vector<Group>& groups,
                  const Optics& optics, const std::vector<Source>& sources);

    //! Returns the irradiance of the face that the beam of a source meets,
    //! relative to that of level ground; 0 in the shade. For the less absorbing
    //! face of a leaf, the value is reduced by the ratio of the absorptances.
    double beam(const LeafPoint& point, std::size_t source) const;

    //! Adds one sample of the light that both faces receive from each source
    //! except directly from beams. The sample is relative to the source's
    //! irradiance of level ground; faces are weighted as in beam(). Samples are
    //! unbiased.
    //! @param light one value per source, to which the sample is added
    void add_diffuse(const LeafPoint& point, RandomStream& random,
                     std::vector<double>& light) const;

    //! Adds one sample of the light from above that a level point receives from
    //! each source, relative to the source's irradiance above the canopy.
    void add_level(const glm::dvec3& place, RandomStream& random,
                   std::vector<double>& light) const;

  private:
    //! Returns the optics of the visible face of a group or of the soil.
    const Lambertian& surface(std::uint32_t group, bool is_adaxial) const {
        return group == Hit::soil
                   ? soil_
                   : optics_.of(groups_[group].material).face(is_adaxial);
    }

    //! Returns the absorptance of a face of a leaf relative to that of the more
    //! absorbing face.
    double weight(const LeafPoint& point, bool is_adaxial) const;

    //! Traces one path from a face, starting on the side of the given normal.
    void follow(glm::dvec3 position, glm::dvec3 normal, double weight,
                std::uint32_t pose, RandomStream& random,
                std::vector<double>& light) const;
    //! Adds beam light that a surface scatters to the side of a normal.
    void add_beams(const glm::dvec3& position, const glm::dvec3& normal,
                   const Lambertian& surface, double weight, std::uint32_t pose,
                   std::vector<double>& light) const;

    const RayScene& scene_;
    const std::vector<Group>& groups_;
    const std::vector<Source>& sources_;
    //! Distinct orientation indices of the sources.
    std::vector<std::uint32_t> poses_;
    Optics optics_;
    Lambertian soil_;
};

}  // namespace ideotype
