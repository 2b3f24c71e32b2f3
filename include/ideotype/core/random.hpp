// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace ideotype {

//! What random numbers are drawn for; no two purposes share a draw.
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
};

//! Which random numbers an evaluation uses: they are a function of these.
struct Randomness {
    std::uint64_t seed = 0;
    std::uint32_t generation = 0;
    //! The others count up from it; each has its own random numbers.
    std::uint32_t first_randomisation = 0;
    //! Whether fields are those of all generations and randomisations: those
    //! of rows whose other random numbers differ.
    bool has_common_fields = false;
};

//! Philox-4x32-10: four random words as a pure function of counter and key
//! (Salmon et al. 2011, doi:10.1145/2063384.2063405).
std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                        std::array<std::uint32_t, 2> key);

//! A sequence of random numbers that is a pure function of what it is for.
//! Two streams with the same key give the same numbers, on any rank.
class RandomStream {
  public:
    RandomStream(std::uint64_t seed, Purpose purpose,
                 std::uint32_t generation = 0, std::uint32_t slot = 0);

    //! 32 random bits.
    std::uint32_t bits();

    //! 64 random bits.
    std::uint64_t bits64() {
        const std::uint64_t high = bits();
        return high << 32 | bits();
    }

    //! Uniform in [0, 1), with 53 random bits.
    double uniform() { return static_cast<double>(bits64() >> 11) * 0x1p-53; }

    //! Uniform in [lower, upper).
    double uniform(double lower, double upper) {
        return lower + (upper - lower) * uniform();
    }

    //! Two independent numbers of a standard normal distribution (Box and
    //! Muller 1958, doi:10.1214/aoms/1177706645).
    std::array<double, 2> normal();

    //! Uniform whole number in [0, n), n > 0, without bias.
    std::uint32_t below(std::uint32_t n);

  private:
    std::array<std::uint32_t, 2> key_;
    std::array<std::uint32_t, 4> counter_;
    std::array<std::uint32_t, 4> block_{};
    unsigned used_ = 4;
};

}  // namespace ideotype
