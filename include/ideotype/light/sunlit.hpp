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

//! The sunlit part of the leaf area by randomisation.
struct SunlitFractions {
    //! The sunlit parts as [randomisation][source]; 0 for skies.
    std::vector<std::vector<double>> fractions;
    //! The sunlit part that a single point or path of each source contributes
    //! in one randomisation; 0 without leaves.
    std::vector<double> steps;
};

//! Returns, for each source, the part of the one-sided leaf area that sees the
//! sun. Rays go towards each sun from the same points, spread evenly over all
//! leaves. Points below the soil are shaded. Faces that lie on each other are
//! one surface, see RayScene: of faces with equal corners only the first can be
//! sunlit, and other coincident faces share the sunlit area equally.
//! @param mesh surfaces that the scene was built from
//! @param accuracy number of points for each randomisation, given as paths
SunlitFractions sunlit_fractions(const RayScene& scene, const Mesh& mesh,
                                 const Illumination& illumination,
                                 const Accuracy& accuracy,
                                 const Randomness& randomness);

//! Returns the sunlit part of the area of pieces of leaves, from the absorbed
//! light of first hits. Leaves that absorb no light and organs are left out.
//! @param tallies results of a simulation with the light of pieces
//! @param groups all groups of the scene's mesh
//! @param leaf_area area of all pieces of leaves [m2]
SunlitFractions sunlit_fractions(const std::vector<Tally>& tallies,
                                 const RayScene& scene,
                                 const std::vector<Group>& groups,
                                 const Optics& optics,
                                 const Illumination& illumination,
                                 double leaf_area);

//! Returns the part of a beam that a triangle of the scene's surfaces absorbs.
//! @param groups all groups of the scene's mesh
double beam_absorptance(const RayScene& scene, const std::vector<Group>& groups,
                        const Optics& optics, std::uint32_t triangle,
                        const glm::dvec3& direction);

//! Returns the irradiance of a triangle by a beam over that of level ground.
double beam_cosine(const RayScene& scene, std::uint32_t triangle,
                   const glm::dvec3& direction);

}  // namespace ideotype
