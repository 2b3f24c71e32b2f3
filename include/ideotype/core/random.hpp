// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "ideotype/core/contract.hpp"

namespace ideotype {

//! The purposes of random numbers; different purposes use independent streams.
enum class Purpose : std::uint32_t {
    initial_population = 1,
    selection = 2,
    crossover = 3,
    mutation = 4,
    jitter = 5,
    scramble = 6,
    scattering = 7,
    backward = 8,
    sample = 9,
    sequence = 10,
    bootstrap = 11,
    variation = 12,
    stream = 13,
    mixture = 14,
    leaf_point = 15,
    position = 16,
};

//! Selects the random numbers of an evaluation, which are a function of all
//! members.
struct Randomness {
    std::uint64_t seed = 0;
    std::uint32_t generation = 0;
    //! Number of the first randomisation. The following randomisations count up
    //! from it and use independent random numbers.
    std::uint32_t first_randomisation = 0;
    //! Whether all generations and randomisations use common fields, so that
    //! rows with different light paths share their plants.
    bool has_common_fields = false;
};

//! Returns four random words as a pure function of counter and key:
//! Philox-4x32-10 (Salmon et al. 2011, doi:10.1145/2063384.2063405).
std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                        std::array<std::uint32_t, 2> key);

//! A sequence of random numbers, a pure function of seed, purpose, generation
//! and slot. Equal arguments give equal numbers on any rank.
class RandomStream {
  public:
    RandomStream(std::uint64_t seed, Purpose purpose,
                 std::uint32_t generation = 0, std::uint32_t slot = 0);

    //! Returns 32 random bits.
    std::uint32_t bits();

    //! Returns 64 random bits.
    std::uint64_t bits64() {
        const std::uint64_t high = bits();
        return high << 32 | bits();
    }

    //! Returns a number uniform in [0, 1), with 53 random bits.
    double uniform() { return static_cast<double>(bits64() >> 11) * 0x1p-53; }

    //! Returns a number uniform in [lower, upper).
    double uniform(double lower, double upper) {
        IDEOTYPE_EXPECT(lower <= upper);
        return lower + (upper - lower) * uniform();
    }

    //! Returns two independent standard normal numbers (Box and Muller 1958,
    //! doi:10.1214/aoms/1177706645).
    std::array<double, 2> normal();

    //! Returns a whole number uniform in [0, n), without bias.
    std::uint32_t below(std::uint32_t n);

  private:
    std::array<std::uint32_t, 2> key_;
    std::array<std::uint32_t, 4> counter_;
    std::array<std::uint32_t, 4> block_{};
    unsigned used_ = 4;
};

}  // namespace ideotype
