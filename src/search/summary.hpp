// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "population.hpp"

namespace ideotype {

//! The stored figures of an evaluated generation.
struct GenerationSummary {
    std::uint32_t best_slot = 0;
    double best = 0;                 //!< objective 0 of the best row
    double best_standard_error = 0;  //!< standard error of `best`
    //! The mean of objective 0 over individuals that meet all constraints or,
    //! if none does, over all that did not fail.
    double mean = 0;
    //! The standard deviation of objective 0 over the individuals of `mean`.
    double spread = 0;
    //! Mean over free genes of the standard deviation over the range, circular
    //! for circular genes; 0.29 for uniform values.
    double diversity = 0;
    std::uint32_t failures = 0;
    std::uint32_t evaluations = 0;  //!< number of rows without copies
    double wall_time = 0;  //!< time since the case began, over all sessions [s]
    //! Violation of the best row, which a history stores by row.
    double violation = 0;
    //! Objective 0 of the best row without the luck of its choice, by
    //! shrunken(); it is not stored.
    Estimate expected_best{};
    //! The hypervolume of all rows so far; NaN if there is one objective.
    double hypervolume = std::numeric_limits<double>::quiet_NaN();
    double hypervolume_standard_error = hypervolume;
};

//! Returns the summary of a population without wall_time and hypervolume; its
//! figures are NaN if every individual failed.
//! @param sense of objective 0
GenerationSummary summarize(const Population& population,
                            const GeneSpace& genes, Sense sense);

//! Returns the volume between a reference and the points that are better than
//! the reference in every objective (Zitzler and Thiele 1998,
//! doi:10.1007/BFb0056872), in the product of the objectives' units. It is
//! exact and summed by slices, for fronts of some hundred points.
//! @param points values [point, objective]
double hypervolume(std::vector<std::vector<double>> points,
                   std::vector<double> reference,
                   const std::vector<Sense>& senses);

//! Returns the hypervolume of the individuals of a population that meet all
//! constraints; 0 if none does. The standard error is that of a jackknife over
//! shared randomisations, without the luck of the selection of the front.
Estimate hypervolume(const Population& population,
                     const std::vector<double>& reference,
                     const std::vector<Sense>& senses);

//! Returns the worst value of each objective among the individuals that did not
//! fail, or nothing if all failed.
std::vector<double> worst_of(const Population& population,
                             const std::vector<Sense>& senses);

//! Summarizes the generations of a case in order, with the hypervolume of all
//! rows so far for several objectives.
class Summarizer {
  public:
    //! @param reference point of the hypervolume; if empty, worst_of() the
    //! first generation that did not fail entirely
    Summarizer(GeneSpace genes, std::vector<Sense> senses,
               std::vector<double> reference);

    GenerationSummary operator()(const Population& generation);

  private:
    GeneSpace genes_;
    std::vector<Sense> senses_;
    std::vector<double> reference_;
    Population front_;  //!< rows that no row so far dominates
};

}  // namespace ideotype
