// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "ideotype/core/contract.hpp"

namespace ideotype {

//! The number of dimensions of the Sobol' sequence.
inline constexpr std::size_t sobol_dimensions = 337;

//! The direction numbers of one dimension. If bit i of an index is set, counted
//! from the lowest, entry i is combined into the coordinate by exclusive or.
using SobolDirections = std::array<std::uint32_t, 32>;

//! The direction numbers of each dimension, from Joe and Kuo (2008,
//! doi:10.1137/070709359).
extern const std::array<SobolDirections, sobol_dimensions> sobol_directions;

//! Returns one coordinate of a point of the unscrambled Sobol' sequence, as a
//! 32-bit fraction.
inline std::uint32_t sobol(std::uint32_t index, std::size_t dimension) {
    IDEOTYPE_EXPECT(dimension < sobol_dimensions);
    std::uint32_t x = 0;
    for (; index; index &= index - 1)
        x ^= sobol_directions[dimension]
                             [static_cast<unsigned>(std::countr_zero(index))];
    return x;
}

//! Returns the bits of x in reversed order.
constexpr std::uint32_t reversed(std::uint32_t x) {
    x = (x & 0x55555555u) << 1 | (x >> 1 & 0x55555555u);
    x = (x & 0x33333333u) << 2 | (x >> 2 & 0x33333333u);
    x = (x & 0x0F0F0F0Fu) << 4 | (x >> 4 & 0x0F0F0F0Fu);
    return __builtin_bswap32(x);
}

//! Scrambles x by a random permutation of [0, 2^32) that maps dyadic intervals
//! to dyadic intervals: nested uniform scrambling by hashing (Owen 1995,
//! doi:10.1007/978-1-4612-2552-2_19; Laine and Karras 2011,
//! doi:10.1111/j.1467-8659.2011.02000.x; constants of Vegdahl 2021).
constexpr std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
    // In each step a bit affects only higher bits. After the reversal these are
    // the lower bits, as nested scrambling requires.
    x = reversed(x);
    x ^= x * 0x3D20ADEAu;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526C56u;
    x ^= x * 0x53A22864u;
    return reversed(x);
}

}  // namespace ideotype
