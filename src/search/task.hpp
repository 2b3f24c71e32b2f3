// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace ideotype {

//! Which evaluation is meant: slot of a generation of a case. Generation and
//! slot also select the random numbers, so that an evaluation is a pure
//! function of its task and genome.
struct Task {
    std::uint32_t case_index = 0;
    std::uint32_t generation = 0;
    std::uint32_t slot = 0;
    std::uint32_t attempt = 1;
    //! Final evaluations use fresh random numbers and higher accuracy.
    bool is_final = false;

    bool operator==(const Task&) const = default;
};

}  // namespace ideotype
