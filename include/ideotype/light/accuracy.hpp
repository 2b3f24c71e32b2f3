// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace ideotype {

//! How accurate an estimate of the light is to be: how much work it may cost.
struct Accuracy {
    int paths = 4096;        //!< per randomisation; with a tolerance at most
    int randomisations = 8;  //!< independent, at least 2
    //! Relative standard error of the leaves' light that will do; 0: none, as
    //! many paths as given.
    double tolerance = 0;
    //! Random fields among which the randomisations are divided evenly. With
    //! several, the standard error also contains how fields differ.
    int fields = 1;

    //! Independent values of each figure, whose spread gives its error: of
    //! several fields one each, else one of each randomisation.
    int replicates() const { return fields > 1 ? fields : randomisations; }

    //! Paths in all randomisations.
    std::uint64_t all_paths() const {
        return static_cast<std::uint64_t>(paths) *
               static_cast<std::uint64_t>(randomisations);
    }
};

}  // namespace ideotype
