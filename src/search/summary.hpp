// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "population.hpp"

namespace ideotype {

//! What is kept of an evaluated generation.
struct GenerationSummary {
    std::uint32_t best_slot = 0;
    double best = 0;                 //!< its objective 0
    double best_standard_error = 0;  //!< of that
    //! Of objective 0 over those that meet all constraints or, where none does,
    //! over all that did not fail.
    double mean = 0;
    double spread = 0;     //!< standard deviation of the same
    double diversity = 0;  //!< mean over free genes of the standard deviation
                           //!< over the range; circular for circular genes,
                           //!< 0.29 for values uniform over the range
    std::uint32_t failures = 0;
    std::uint32_t evaluations = 0;  //!< without copies of duplicates
    double wall_time = 0;           //!< since the case began, all sessions [s]
    double violation = 0;           //!< of the best; a history has it by row
    //! Of several objectives, of all rows so far; else NaN.
    double hypervolume = std::numeric_limits<double>::quiet_NaN();
    double hypervolume_standard_error = hypervolume;
};

//! All but wall_time and hypervolume; NaN where every individual failed.
//! @param sense of objective 0
GenerationSummary summarize(const Population& population,
                            const GeneSpace& genes, Sense sense);

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
