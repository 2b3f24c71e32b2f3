// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/canopy/assimilation.hpp"
#include "ideotype/core/random.hpp"
#include "ideotype/light/accuracy.hpp"

namespace ideotype {

//! Assimilation as estimated at random points of leaves.
struct ExactAssimilation {
    std::vector<FluxTally> tallies;  //!< tallies by randomisation
    int points = 0;                  //!< points in each randomisation
    bool is_capped = false;          //!< too few points for the tolerance
};

//! Finds the gross assimilation of leaves in one field without bias, as a check
//! of assimilate(): it takes random points of leaves, each with its own ray to
//! each sun and its own paths of diffuse light D, and no pieces of leaves.
//!
//! The response f to the mean of D is higher than the mean of f over noisy
//! samples of D. The limit of many samples is estimated from few: by the
//! response to the mean of two samples, and by one step from a number of
//! samples to twice as many; the number is drawn at random and the step divided
//! by its odds (Blanchet and Glynn 2015, doi:10.1109/WSC.2015.7408524;
//! Blanchet, Glynn and Pei 2019, arXiv:1904.09929). The step is f of the mean
//! of all samples less the mean of f of both halves, so that its variance falls
//! with the square of the number of samples; odds that fall with the power 1.5
//! keep variance and cost finite.
//!
//! @param lit lit leaves with the scene of the mesh
//! @param accuracy accuracy with as many points as paths; its tolerance is that
//! of gross assimilation
ExactAssimilation assimilate_exactly(const Mesh& mesh, const LitLeaves& lit,
                                     const Accuracy& accuracy,
                                     const Randomness& randomness);

}  // namespace ideotype
