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

//! Computes the gross assimilation of the leaves in one field without bias, as
//! a check of assimilate(). Leaves are not cut into pieces: each of many random
//! points on leaves has one ray to each sun position and separate paths of
//! diffuse light D.
//!
//! The response f to the mean of D is higher than the mean of f over noisy
//! samples of D. The limit of infinitely many samples is estimated without bias
//! from a few. The estimate is f at the mean of two samples, plus one random
//! term of the series of differences between n and 2 n samples. The number n of
//! that term is random, and the term is divided by its probability (Blanchet
//! and Glynn 2015, doi:10.1109/WSC.2015.7408524; Blanchet, Glynn and Pei 2019,
//! arXiv:1904.09929). A term is f at the mean of all samples less the mean of f
//! at the means of both halves, so its variance falls as n^-2. Probabilities
//! that fall as n^-1.5 keep both variance and cost finite.
//!
//! @param lit field with the scene of the mesh
//! @param accuracy accuracy in which points replace paths; its tolerance
//! applies to gross assimilation
ExactAssimilation assimilate_exactly(const Mesh& mesh, const LitLeaves& lit,
                                     const Accuracy& accuracy,
                                     const Randomness& randomness);

}  // namespace ideotype
