// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "population.hpp"

namespace ideotype {

//! Statistics of an evaluated generation, most of which are stored.
struct GenerationSummary {
    std::uint32_t best_slot = 0;
    double best = 0;                 //!< objective 0 of the best row
    double best_standard_error = 0;  //!< standard error of `best`
    //! Mean of objective 0 over individuals that meet all constraints or, if
    //! none does, over all that did not fail.
    double mean = 0;
    //! Standard deviation of objective 0 over the same individuals.
    double spread = 0;
    //! Standard deviation of a gene relative to its range, averaged over free
    //! genes; circular genes use circular statistics, and choices the
    //! probability that two values differ. It is 0.29 for uniform values.
    double diversity = 0;
    std::uint32_t failures = 0;
    std::uint32_t evaluations = 0;  //!< number of distinct genomes
    double wall_time = 0;  //!< time since the case began, over all sessions [s]
    //! Violation of the best row. A history stores violations by row, not here.
    double violation = 0;
    //! Expected objective 0 of the best row without selection bias, see
    //! shrink(). It is not stored.
    Estimate expected_best{};
    //! Hypervolume of all rows so far; NaN with a single objective.
    double hypervolume = std::numeric_limits<double>::quiet_NaN();
    double hypervolume_standard_error = hypervolume;
};

//! Summarizes a population, except for wall_time and hypervolume. Statistics
//! are NaN if every individual failed.
//! @param sense whether objective 0 is maximised or minimised
GenerationSummary summarize(const Population& population,
                            const GeneSpace& genes, Sense sense);

//! Returns the hypervolume: the volume between a reference and the points that
//! are better than it in every objective (Zitzler and Thiele 1998,
//! doi:10.1007/BFb0056872). Its unit is the product of the objectives' units.
//! It is computed exactly, by slicing, which is practical for fronts of some
//! hundred points.
//! @param points values [point, objective]
double hypervolume(std::vector<std::vector<double>> points,
                   std::vector<double> reference,
                   const std::vector<Sense>& senses);

//! Returns the hypervolume of the individuals that meet all constraints, or 0
//! if there are none. The standard error is a jackknife estimate over shared
//! randomisations; it does not include the selection of the front.
Estimate hypervolume(const Population& population,
                     const std::vector<double>& reference,
                     const std::vector<Sense>& senses);

//! Finds the worst value of each objective among the individuals that did not
//! fail; returns nothing if all failed.
std::vector<double> find_worst(const Population& population,
                               const std::vector<Sense>& senses);

//! Summarizes the generations of a case in order. With several objectives, also
//! computes the hypervolume of all rows so far.
class Summarizer {
  public:
    //! @param reference reference point of the hypervolume. If it is empty,
    //! find_worst() sets it from the first generation in which any individual
    //! succeeded.
    Summarizer(GeneSpace genes, std::vector<Sense> senses,
               std::vector<double> reference);

    GenerationSummary operator()(const Population& generation);

  private:
    GeneSpace genes_;
    std::vector<Sense> senses_;
    std::vector<double> reference_;
    Population front_;  //!< non-dominated rows so far
};

}  // namespace ideotype
