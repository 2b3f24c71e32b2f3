// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "ideotype/core/mesh.hpp"
#include "ideotype/light/illumination.hpp"
#include "ideotype/light/optics.hpp"
#include "ideotype/light/ray_scene.hpp"
#include "ideotype/light/tally.hpp"
#include "ideotype/light/transport.hpp"

namespace ideotype {

//! The sunlit part of the leaf area, by randomisation.
struct SunlitFractions {
    //! The parts [randomisation][source]; 0 for skies.
    std::vector<std::vector<double>> fractions;
    //! The part that one point or path of each source tells in one
    //! randomisation; 0 where there are no leaves.
    std::vector<double> steps;
};

//! Returns the part of the leaf area from which the sun can be seen, one-sided;
//! for each source. Points are spread evenly over all leaves, the same for
//! every sun, and sent towards it. What is below the soil is shaded. Faces that
//! lie on each other are one surface, see RayScene: of faces with the same
//! corners only the first can be sunlit, others share equally what is.
//! @param mesh that the scene was built from
//! @param accuracy as many points as paths, for each randomisation
SunlitFractions sunlit_fractions(const RayScene& scene, const Mesh& mesh,
                                 const Illumination& illumination,
                                 const Accuracy& accuracy,
                                 const Randomness& randomness);

//! Returns the sunlit part of the area of pieces of leaves, from first hits
//! that are known anyway, by the light that they absorb. Nothing is known, and
//! told, of leaves that absorb nothing.
//! @param tallies with the light of pieces
//! @param groups of the scene's mesh
//! @param leaf_area of all pieces [m2]
SunlitFractions sunlit_fractions(const std::vector<Tally>& tallies,
                                 const RayScene& scene,
                                 const std::vector<Group>& groups,
                                 const Optics& optics,
                                 const Illumination& illumination,
                                 double leaf_area);

//! Returns the part of a beam that a triangle of the scene's surfaces absorbs.
//! @param groups of the scene's mesh
double beam_absorptance(const RayScene& scene, const std::vector<Group>& groups,
                        const Optics& optics, std::uint32_t triangle,
                        const glm::dvec3& direction);

//! Returns the irradiance of a beam on a triangle of the scene's surfaces over
//! that on level ground.
double beam_cosine(const RayScene& scene, std::uint32_t triangle,
                   const glm::dvec3& direction);

}  // namespace ideotype
