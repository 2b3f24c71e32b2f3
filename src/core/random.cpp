// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/random.hpp"

#include <cmath>
#include <numbers>

namespace ideotype {

namespace {

struct Product {
    std::uint32_t high;
    std::uint32_t low;
};

Product multiply(std::uint32_t a, std::uint32_t b) {
    const std::uint64_t product = std::uint64_t{a} * b;
    return {static_cast<std::uint32_t>(product >> 32),
            static_cast<std::uint32_t>(product)};
}

}  // namespace

std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                        std::array<std::uint32_t, 2> key) {
    for (int round = 0; round < 10; ++round) {
        const Product p = multiply(0xD2511F53u, counter[0]);
        const Product q = multiply(0xCD9E8D57u, counter[2]);
        counter = {q.high ^ counter[1] ^ key[0], q.low,
                   p.high ^ counter[3] ^ key[1], p.low};
        key = {key[0] + 0x9E3779B9u, key[1] + 0xBB67AE85u};
    }
    return counter;
}

RandomStream::RandomStream(std::uint64_t seed, Purpose purpose,
                           std::uint32_t generation, std::uint32_t slot)
    : key_{static_cast<std::uint32_t>(seed),
           static_cast<std::uint32_t>(seed >> 32)},
      counter_{0, slot, generation, static_cast<std::uint32_t>(purpose)} {}

std::uint32_t RandomStream::bits() {
    if (used_ == 4) {
        block_ = philox4x32(counter_, key_);
        ++counter_[0];
        used_ = 0;
    }
    return block_[used_++];
}

std::uint64_t RandomStream::bits64() {
    const std::uint64_t high = bits();
    return high << 32 | bits();
}

double RandomStream::uniform() {
    return static_cast<double>(bits64() >> 11) * 0x1p-53;
}

double RandomStream::uniform(double lower, double upper) {
    return lower + (upper - lower) * uniform();
}

std::array<double, 2> RandomStream::normal() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    const double angle = 2 * std::numbers::pi * uniform();
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

std::uint32_t RandomStream::below(std::uint32_t n) {
    // Reject the last, incomplete run of n values.
    const std::uint32_t rejected = (0u - n) % n;
    std::uint32_t x = bits();
    while (x < rejected) x = bits();
    return x % n;
}

}  // namespace ideotype
