#pragma once

#include <vector>

#include "ideotype/core/mesh.hpp"
#include "ideotype/light/illumination.hpp"
#include "ideotype/light/optics.hpp"
#include "ideotype/light/scene.hpp"
#include "ideotype/light/transport.hpp"

namespace ideotype {

//! The part of the leaf area from which the sun can be seen, one-sided; for
//! each source, 0 for skies. Points are spread evenly over all leaves, the
//! same for every sun, and sent towards it. What is below the soil is shaded.
//! @param mesh that the scene was built from
//! @param sampling as many points as paths, for each randomisation
//! @return one vector over the sources per randomisation
std::vector<std::vector<double>> sunlit_fractions(
    const Scene& scene, const Mesh& mesh, const Illumination& illumination,
    const Sampling& sampling, const Randomness& randomness);

}  // namespace ideotype
