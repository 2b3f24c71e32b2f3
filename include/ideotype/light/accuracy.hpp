// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace ideotype {

//! The requested accuracy of light estimates, which determines the amount of
//! work.
struct Accuracy {
    //! Paths per randomisation; if there is a tolerance, the upper limit.
    int paths = 4096;
    int randomisations = 8;  //!< independent randomisations, at least 2
    //! The accepted relative standard error of the light absorbed by leaves; 0:
    //! exactly the given number of paths is used.
    double tolerance = 0;
    //! The number of random fields over which the randomisations are
    //! distributed evenly. With several fields, the standard error includes the
    //! variation between fields.
    int fields = 1;

    bool operator==(const Accuracy&) const = default;

    //! Returns the number of independent values of a figure, from which its
    //! error is estimated: one per field if there are several, otherwise one
    //! per randomisation.
    int repetitions() const { return fields > 1 ? fields : randomisations; }

    //! Returns the total number of paths of all randomisations.
    std::uint64_t all_paths() const {
        return static_cast<std::uint64_t>(paths) *
               static_cast<std::uint64_t>(randomisations);
    }
};

}  // namespace ideotype
