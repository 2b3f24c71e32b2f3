#pragma once

#include <vector>

#include "ideotype/core/mesh.hpp"
#include "ideotype/light/illumination.hpp"
#include "ideotype/light/optics.hpp"
#include "ideotype/light/scene.hpp"
#include "ideotype/light/transport.hpp"

namespace ideotype {

//! Replicates of the sunlit part of the leaf area.
struct SunlitFractions {
    //! [randomisation][source]; 0 for skies.
    std::vector<std::vector<double>> fractions;
    //! Of one point in one randomisation: what its points can tell; 0 where
    //! there are no leaves.
    double step = 0;
};

//! The part of the leaf area from which the sun can be seen, one-sided; for
//! each source. Points are spread evenly over all leaves, the same for every
//! sun, and sent towards it. What is below the soil is shaded. Faces that lie
//! on each other are one surface, see Scene: of faces with the same corners
//! only the first can be sunlit, others share equally what is.
//! @param mesh that the scene was built from
//! @param accuracy as many points as paths, for each randomisation
SunlitFractions sunlit_fractions(const Scene& scene, const Mesh& mesh,
                                 const Illumination& illumination,
                                 const Accuracy& accuracy,
                                 const Randomness& randomness);

}  // namespace ideotype
