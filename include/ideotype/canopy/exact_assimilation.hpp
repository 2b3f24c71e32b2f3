// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/canopy/assimilation.hpp"
#include "ideotype/core/random.hpp"
#include "ideotype/light/accuracy.hpp"

namespace ideotype {

//! Assimilation as random points of leaves tell it.
struct ExactAssimilation {
    std::vector<FluxTally> tallies;  //!< by randomisation
    int points = 0;                  //!< in each randomisation
    bool is_capped = false;  //!< more would be needed to meet the tolerance
};

//! Finds the gross assimilation of leaves in one field without any bias, to
//! check assimilate() by: it takes random points of leaves, each with its own
//! ray to each sun and its own paths of diffuse light D, no pieces of leaves.
//!
//! The response f to the mean of D is more than its mean over noisy samples of
//! D. The limit of many samples is estimated from few: by the response to the
//! mean of two, and by one step from a number of samples to twice as many, the
//! number drawn at random and the step divided by its odds (Blanchet and Glynn
//! 2015, doi:10.1109/WSC.2015.7408524; Blanchet, Glynn and Pei 2019,
//! arXiv:1904.09929). The step is taken as f of the mean of all less the mean
//! of f of both halves, so that its variance falls with the square of their
//! number; odds that fall with the power 1.5 keep variance and cost finite.
//!
//! @param lit with the scene of the mesh
//! @param accuracy as many points as paths; the tolerance is that of gross
//! assimilation
ExactAssimilation assimilate_exactly(const Mesh& mesh, const LitLeaves& lit,
                                     const Accuracy& accuracy,
                                     const Randomness& randomness);

}  // namespace ideotype
