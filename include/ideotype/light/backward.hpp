// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ideotype/core/random.hpp"
#include "ideotype/light/illumination.hpp"
#include "ideotype/light/leaf_points.hpp"
#include "ideotype/light/optics.hpp"
#include "ideotype/light/scene.hpp"

namespace ideotype {

//! Whether light that travels in a direction comes straight to a point.
bool is_lit(const Scene& scene, const LeafPoint& point,
            const glm::dvec3& travel);

//! The light at points of leaves, by paths that are followed from there back
//! to its sources: what needs no field of light, but a path for every point.
//! It shares the scene with all that follows light forwards, and nothing else.
class BackwardLight {
  public:
    //! @param groups,sources must outlive it, and so must the scene
    BackwardLight(const Scene& scene, const std::vector<Group>& groups,
                  const Optics& optics, const std::vector<Source>& sources);

    //! Irradiance of the beam of a source, on the face that it meets, over
    //! that on level ground; 0 in the shade.
    double beam(const LeafPoint& point, std::size_t source) const;

    //! Adds one sample of all other light that both faces receive, by source,
    //! over what level ground receives from it. Its mean is without bias.
    //! @param light of each source
    void add_diffuse(const LeafPoint& point, RandomStream& random,
                     std::vector<double>& light) const;

    //! Adds one sample of the light that comes from above to a level place, by
    //! source, over what level ground receives from it above all plants.
    void add_level(const glm::dvec3& place, RandomStream& random,
                   std::vector<double>& light) const;

  private:
    const Lambertian& surface(std::uint32_t group) const {
        return group == Hit::soil ? soil_ : optics_.of(groups_[group].tissue);
    }

    //! Along one path from a face on the side of a normal.
    void follow(glm::dvec3 position, glm::dvec3 normal, RandomStream& random,
                std::vector<double>& light) const;
    //! What a surface sends on of the beams that it meets, to the side of a
    //! normal.
    void add_beams(const glm::dvec3& position, const glm::dvec3& normal,
                   const Lambertian& surface, std::vector<double>& light) const;

    const Scene& scene_;
    const std::vector<Group>& groups_;
    const std::vector<Source>& sources_;
    Optics optics_;
    Lambertian soil_;
};

}  // namespace ideotype
