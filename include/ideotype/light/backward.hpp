// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ideotype/core/random.hpp"
#include "ideotype/light/illumination.hpp"
#include "ideotype/light/leaf_points.hpp"
#include "ideotype/light/optics.hpp"
#include "ideotype/light/ray_scene.hpp"

namespace ideotype {

//! Returns whether light that travels in a direction reaches a point of a leaf
//! unhindered.
//! @param pose number of the pose of moving objects
bool is_lit(const RayScene& scene, const LeafPoint& point,
            const glm::dvec3& travel, std::uint32_t pose = 0);

//! Finds the light at points of leaves, by paths that are followed from the
//! points back to the sources of light. Each point needs separate paths. Only
//! the scene is shared with the code that follows light forwards. A path counts
//! for all sources that meet moving objects in one pose.
class BackwardLight {
  public:
    //! Makes the object, which keeps references to all arguments.
    //! @param groups,sources objects that must outlive this one, as the scene
    //! must
    BackwardLight(const RayScene& scene, const std::vector<Group>& groups,
                  const Optics& optics, const std::vector<Source>& sources);

    //! Returns the irradiance of the face that the beam of a source meets, over
    //! the irradiance of level ground; 0 in the shade. For the less absorbing
    //! face of a leaf, the value is reduced in proportion.
    double beam(const LeafPoint& point, std::size_t source) const;

    //! Adds one sample of the light without beams that both faces receive from
    //! each source, over the light of this source on level ground. Faces count
    //! as for beam(). The mean of samples has no bias.
    //! @param light values of each source, to which the sample is added
    void add_diffuse(const LeafPoint& point, RandomStream& random,
                     std::vector<double>& light) const;

    //! Adds one sample of the light from above that a level place receives from
    //! each source, over the light of this source above all plants.
    void add_level(const glm::dvec3& place, RandomStream& random,
                   std::vector<double>& light) const;

  private:
    //! Returns the optics of the visible face of a group, or of the soil.
    const Lambertian& surface(std::uint32_t group, bool is_adaxial) const {
        return group == Hit::soil
                   ? soil_
                   : optics_.of(groups_[group].material).face(is_adaxial);
    }

    //! Returns the absorptance of a face of a leaf over that of the more
    //! absorbing face.
    double weight(const LeafPoint& point, bool is_adaxial) const;

    //! Follows one path from a face, on the side to which a normal points.
    void follow(glm::dvec3 position, glm::dvec3 normal, double weight,
                std::uint32_t pose, RandomStream& random,
                std::vector<double>& light) const;
    //! Adds the light of beams that a surface scatters to the side of a normal.
    void add_beams(const glm::dvec3& position, const glm::dvec3& normal,
                   const Lambertian& surface, double weight, std::uint32_t pose,
                   std::vector<double>& light) const;

    const RayScene& scene_;
    const std::vector<Group>& groups_;
    const std::vector<Source>& sources_;
    std::vector<std::uint32_t> poses_;  //!< distinct poses of the sources
    Optics optics_;
    Lambertian soil_;
};

}  // namespace ideotype
