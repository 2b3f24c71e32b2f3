#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "ideotype/core/random.hpp"

namespace ideotype {

//! Dimensions of the low-discrepancy sequence; beyond them numbers are
//! independent.
inline constexpr std::size_t sobol_dimensions = 16;

//! The unscrambled Sobol' point of an index as 32-bit fractions, with the
//! direction numbers of Joe and Kuo (2008, doi:10.1137/070709359).
std::uint32_t sobol(std::uint32_t index, std::size_t dimension);

//! A random permutation of [0, 2^32) that keeps every dyadic interval whole:
//! nested uniform scrambling by hashing (Owen 1995,
//! doi:10.1007/978-1-4612-2552-2_19; Laine and Karras 2011,
//! doi:10.1111/j.1467-8659.2011.02000.x; constants of Vegdahl 2021).
std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed);

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
    std::array<std::uint32_t, sobol_dimensions> scramble_seeds_;
    std::uint64_t tail_seed_;
    std::uint32_t path_ = 0;
    std::size_t dimension_ = 0;
    std::optional<RandomStream> tail_;
};

}  // namespace ideotype
