// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "population.hpp"
#include "summary.hpp"

namespace ideotype {

//! The volume between a reference and the points that are better than it in
//! every objective (Zitzler and Thiele 1998, doi:10.1007/BFb0056872), exact, in
//! the product of the objectives' units. By slices: for fronts of some hundred
//! points.
//! @param points [point, objective]
double hypervolume(std::vector<std::vector<double>> points,
                   std::vector<double> reference,
                   const std::vector<Sense>& senses);

//! Of those of a population that keep all constraints; 0 without any. The
//! standard error is that of a jackknife over the randomisations, which rows
//! share; it knows nothing of the luck that put rows into the front.
Estimate hypervolume(const Population& population,
                     const std::vector<double>& reference,
                     const std::vector<Sense>& senses);

//! The worst of each objective among those that did not fail, if any.
std::vector<double> worst_of(const Population& population,
                             const std::vector<Sense>& senses);

//! Summarizes the generations of a case, in their order, those of several
//! objectives with the hypervolume of all rows so far.
class Summarizer {
  public:
    //! @param reference of the hypervolume; if empty, worst_of() the first
    //! generation in which any did not fail
    Summarizer(GeneSpace genes, std::vector<Sense> senses,
               std::vector<double> reference);

    GenerationSummary operator()(const Population& generation);

  private:
    GeneSpace genes_;
    std::vector<Sense> senses_;
    std::vector<double> reference_;
    Population front_;  //!< of all rows so far
};

}  // namespace ideotype
