// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "ideotype/core/random.hpp"

namespace ideotype {

//! The categorical distributions of CatCMA with margin (Hamano et al. 2025,
//! arXiv:2504.07884): independent probabilities of the values of each choice.
//! They follow the natural gradient with a step that adapts to the ratio of
//! signal and noise (ASNG, Akimoto et al. 2019, PMLR 97:171). No probability
//! falls below a margin.
class ChoiceDistribution {
  public:
    //! The entry of each choice.
    using Entries = std::vector<std::size_t>;

    //! @param probabilities of the entries of each choice; there are one or
    //! more choices with two or more entries each
    //! @param margin smallest probability of all entries but one together
    ChoiceDistribution(std::vector<std::vector<double>> probabilities,
                       double margin);

    //! Draws an entry of each choice.
    Entries draw(RandomStream& stream) const;

    //! Updates the probabilities with the entries of a generation, of which the
    //! better half has the weights of CMA-ES.
    //! @param ranked entries of each point, best first
    void update(const std::vector<Entries>& ranked);

    //! Returns the most probable entry of each choice.
    Entries mode() const;

    const std::vector<std::vector<double>>& probabilities() const {
        return probabilities_;
    }

  private:
    void correct();

    std::vector<std::vector<double>> probabilities_;
    double margin_;
    double noise_ = 1;          //!< inverse of the trust region
    double reached_ = 0;        //!< share of variance that the path reached
    std::vector<double> path_;  //!< accumulated steps
};

}  // namespace ideotype
