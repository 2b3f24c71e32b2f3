// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/random.hpp"
#include "ideotype/core/sobol.hpp"

namespace ideotype {

//! Low-discrepancy points of a unit cube: the Sobol' sequence with Owen's
//! nested scrambling. Any 2^m points form a digital net if the index of the
//! first is a multiple of 2^m. Coordinates beyond sobol_dimensions are
//! independent random numbers. Each coordinate is a pure function of (seed,
//! point, dimension).
class SobolSequence {
  public:
    SobolSequence(std::uint64_t seed, std::size_t dimensions) : seed_(seed) {
        RandomStream stream(seed, Purpose::sequence);
        while (scramble_seeds_.size() < dimensions)
            scramble_seeds_.push_back(stream.bits());
    }

    //! Returns one coordinate of a point, uniform in [0, 1).
    double at(std::uint32_t point, std::size_t dimension) const {
        IDEOTYPE_EXPECT(dimension < scramble_seeds_.size());
        if (dimension >= sobol_dimensions)
            return RandomStream(seed_, Purpose::sequence,
                                static_cast<std::uint32_t>(dimension), point)
                .uniform();
        return scrambled(sobol(point, dimension), scramble_seeds_[dimension]) *
               0x1p-32;
    }

  private:
    std::uint64_t seed_;
    std::vector<std::uint32_t> scramble_seeds_;  //!< seeds by dimension
};

}  // namespace ideotype
