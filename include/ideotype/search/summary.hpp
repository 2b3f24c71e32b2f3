#pragma once

#include <cstdint>

#include "ideotype/search/population.hpp"

namespace ideotype {

//! What is kept of an evaluated generation.
struct GenerationSummary {
    std::uint32_t best_slot = 0;
    double best = 0;
    double best_standard_error = 0;
    //! Fitness of all that did not fail and, once any does, keep to their
    //! constraints.
    double mean = 0;
    double spread = 0;     //!< standard deviation of the fitness
    double diversity = 0;  //!< mean over free genes of the standard deviation
                           //!< over the range; circular for circular genes,
                           //!< 0.29 for values uniform over the range
    std::uint32_t failures = 0;
    std::uint32_t evaluations = 0;  //!< without copies of duplicates
    double wall_time = 0;           //!< since the case began, all sessions [s]
};

//! All but wall_time; NaN where every individual failed.
GenerationSummary summarize(const Population& population,
                            const GeneSpace& genes);

}  // namespace ideotype
