// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace ideotype {

//! The wished accuracy of an estimate of the light, which also sets its work.
struct Accuracy {
    //! Paths per randomisation; their limit if there is a tolerance.
    int paths = 4096;
    int randomisations = 8;  //!< independent randomisations, at least 2
    //! The accepted relative standard error of the light of leaves; 0 asks for
    //! exactly the given number of paths.
    double tolerance = 0;
    //! The number of random fields among which the randomisations are divided
    //! evenly. With several fields, the standard error includes the differences
    //! among fields.
    int fields = 1;

    //! Returns the number of independent values of a figure; their spread gives
    //! its error: one for each field if there are several, else for each
    //! randomisation.
    int repetitions() const { return fields > 1 ? fields : randomisations; }

    //! Returns the number of paths in all randomisations.
    std::uint64_t all_paths() const {
        return static_cast<std::uint64_t>(paths) *
               static_cast<std::uint64_t>(randomisations);
    }
};

}  // namespace ideotype
