// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ideotype/core/random.hpp"
#include "ideotype/light/illumination.hpp"
#include "ideotype/light/leaf_points.hpp"
#include "ideotype/light/optics.hpp"
#include "ideotype/light/ray_scene.hpp"

namespace ideotype {

//! Returns whether light that travels in a direction comes straight to a point.
//! @param pose of what moves
bool is_lit(const RayScene& scene, const LeafPoint& point,
            const glm::dvec3& travel, std::uint32_t pose = 0);

//! Finds the light at points of leaves, by paths that are followed from there
//! back to its sources. This needs no field of light, but a path for every
//! point. It shares the scene with all that follows light forwards, and nothing
//! else. A path is of all sources for which what moves has one pose.
class BackwardLight {
  public:
    //! Keeps its arguments.
    //! @param groups,sources must outlive it, and so must the scene
    BackwardLight(const RayScene& scene, const std::vector<Group>& groups,
                  const Optics& optics, const std::vector<Source>& sources);

    //! Returns the irradiance of the beam of a source, on the face that it
    //! meets, over that on level ground; 0 in the shade. Light on a face that
    //! absorbs less than the other one counts by as much less.
    double beam(const LeafPoint& point, std::size_t source) const;

    //! Adds one sample of all light but beams that both faces receive, by
    //! source, over the light that level ground receives from it; faces count
    //! as for beam(). Its mean is without bias.
    //! @param light of each source
    void add_diffuse(const LeafPoint& point, RandomStream& random,
                     std::vector<double>& light) const;

    //! Adds one sample of the light that comes from above to a level place, by
    //! source, over the light that level ground receives from it above all
    //! plants.
    void add_level(const glm::dvec3& place, RandomStream& random,
                   std::vector<double>& light) const;

  private:
    //! Returns the face that sends light to the side from which it is seen.
    const Lambertian& surface(std::uint32_t group, bool is_adaxial) const {
        return group == Hit::soil
                   ? soil_
                   : optics_.of(groups_[group].material).face(is_adaxial);
    }

    //! Returns the light that a face of a leaf absorbs over that of the face
    //! that absorbs most.
    double weight(const LeafPoint& point, bool is_adaxial) const;

    //! Follows one path from a face, on the side of a normal.
    void follow(glm::dvec3 position, glm::dvec3 normal, double weight,
                std::uint32_t pose, RandomStream& random,
                std::vector<double>& light) const;
    //! Adds the light of beams that a surface sends on to the side of a normal.
    void add_beams(const glm::dvec3& position, const glm::dvec3& normal,
                   const Lambertian& surface, double weight, std::uint32_t pose,
                   std::vector<double>& light) const;

    const RayScene& scene_;
    const std::vector<Group>& groups_;
    const std::vector<Source>& sources_;
    std::vector<std::uint32_t> poses_;  //!< poses of sources
    Optics optics_;
    Lambertian soil_;
};

}  // namespace ideotype
