// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>

namespace ideotype {

//! Layers of equal thickness from the soil up; the last one is unbounded above.
struct Layers {
    double thickness = 1;  //!< thickness of each layer [m]
    std::size_t count = 1;

    //! Returns the number of the layer at a height [m].
    std::size_t at(double height) const {
        const double last = static_cast<double>(count - 1);
        return static_cast<std::size_t>(
            std::clamp(height / thickness, 0.0, last));
    }
};

}  // namespace ideotype
