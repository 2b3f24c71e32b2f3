// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

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

}  // namespace ideotype
