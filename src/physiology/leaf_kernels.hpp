// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "ideotype/physiology/hyperbola.hpp"

namespace ideotype {

//! Computes Response::expand() at many levels of light. It is inlined into
//! functions that are compiled for an instruction set each.
//! @param response a copy, so that writing results cannot change it
template <class Response>
[[gnu::always_inline]] inline void expand_all(const Response response,
                                              std::size_t count,
                                              const double* __restrict light,
                                              double* __restrict value,
                                              double* __restrict slope,
                                              double* __restrict curvature) {
    for (std::size_t i = 0; i < count; ++i) {
        const Expansion at = response.expand(light[i]);
        value[i] = at.value;
        slope[i] = at.slope;
        curvature[i] = at.curvature;
    }
}

}  // namespace ideotype
