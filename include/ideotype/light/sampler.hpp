// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "ideotype/core/random.hpp"

namespace ideotype {

//! Numbers of a path that are of a low-discrepancy sequence; beyond them they
//! are independent.
inline constexpr std::size_t path_dimensions = 16;

//! Uniform numbers for the paths of one source in one randomisation: a
//! scrambled Sobol' sequence, as long as is asked for. Those of other sources
//! and randomisations are independent.
class PathSampler {
  public:
    PathSampler(std::uint64_t seed, std::uint32_t generation,
                std::uint32_t randomisation, std::uint32_t source);

    //! Goes to a number of a path, its first one unless said otherwise.
    void begin(std::uint32_t path, std::size_t dimension = 0);

    //! The next number of this path, uniform in [0, 1).
    double next();

  private:
    std::uint32_t generation_;
    std::array<std::uint32_t, path_dimensions> scramble_seeds_;
    std::uint64_t tail_seed_;
    std::uint32_t path_ = 0;
    std::size_t dimension_ = 0;
    std::optional<RandomStream> tail_;
};

}  // namespace ideotype
