// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace ideotype {

//! Which random numbers an evaluation uses: they are a function of these.
struct Randomness {
    std::uint64_t seed = 0;
    std::uint32_t generation = 0;
    //! The others count up from it; each has its own random numbers.
    std::uint32_t first_randomisation = 0;
    //! One random field for all randomisations makes candidates comparable at
    //! least cost; one for each makes the standard error include the jitter.
    //! The common one is also that of rows with other random numbers.
    enum class Fields { one, each, common } fields = Fields::one;
};

}  // namespace ideotype
