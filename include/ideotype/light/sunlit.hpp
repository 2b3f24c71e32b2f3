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

//! The sunlit fraction of the leaf area by randomisation.
struct SunlitFractions {
    //! The sunlit fractions [randomisation][source]; 0 for skies.
    std::vector<std::vector<double>> fractions;
    //! The sunlit fraction that a single point or path of each source
    //! contributes in one randomisation; 0 without leaves.
    std::vector<double> steps;
};

//! Returns, for each source, the fraction of the one-sided leaf area that the
//! sun reaches. All suns use rays from the same points, which are spread
//! uniformly over all leaves. Points below the soil are shaded. Coincident
//! faces are one surface, see RayScene: of faces with the same corners only the
//! first can be sunlit; other coincident faces share the sunlit area equally.
//! @param mesh surfaces that the scene was built from
//! @param accuracy accuracy in which points replace paths
SunlitFractions sunlit_fractions(const RayScene& scene, const Mesh& mesh,
                                 const Illumination& illumination,
                                 const Accuracy& accuracy,
                                 const Randomness& randomness);

//! Returns the sunlit fraction of the area of pieces of leaves, from the light
//! absorbed at first hits. Leaves that absorb no light and organs are excluded.
//! @param tallies results of a simulation with light tallied by piece
//! @param groups all groups of the scene's mesh
//! @param leaf_area area of all pieces of leaves [m2]
SunlitFractions sunlit_fractions(const std::vector<Tally>& tallies,
                                 const RayScene& scene,
                                 const std::vector<Group>& groups,
                                 const Optics& optics,
                                 const Illumination& illumination,
                                 double leaf_area);

//! Returns the fraction of a beam that a triangle of the scene's surfaces
//! absorbs.
//! @param groups all groups of the scene's mesh
double beam_absorptance(const RayScene& scene, const std::vector<Group>& groups,
                        const Optics& optics, std::uint32_t triangle,
                        const glm::dvec3& direction);

//! Returns the irradiance of a triangle by a beam, relative to that of level
//! ground.
double beam_cosine(const RayScene& scene, std::uint32_t triangle,
                   const glm::dvec3& direction);

}  // namespace ideotype
