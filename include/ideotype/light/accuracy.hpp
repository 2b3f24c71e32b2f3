// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace ideotype {

//! The accuracy that an estimate of the light is to have, and so the work that
//! it may cost.
struct Accuracy {
    int paths = 4096;        //!< per randomisation; with a tolerance at most
    int randomisations = 8;  //!< independent, at least 2
    //! The relative standard error of the leaves' light that will do; 0: none,
    //! as many paths as given.
    double tolerance = 0;
    //! The number of random fields among which the randomisations are divided
    //! evenly. With several, the standard error also contains how fields
    //! differ.
    int fields = 1;

    //! Returns the number of independent values of each figure, whose spread
    //! gives its error: one of each field if there are several, else one of
    //! each randomisation.
    int repetitions() const { return fields > 1 ? fields : randomisations; }

    //! Returns the number of paths in all randomisations.
    std::uint64_t all_paths() const {
        return static_cast<std::uint64_t>(paths) *
               static_cast<std::uint64_t>(randomisations);
    }
};

}  // namespace ideotype
