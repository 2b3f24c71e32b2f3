// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/random.hpp"

#include <cmath>
#include <numbers>

#include "ideotype/core/contract.hpp"

namespace ideotype {

std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                        std::array<std::uint32_t, 2> key) {
    for (int round = 0; round < 10; ++round) {
        const std::uint64_t p = std::uint64_t{0xD2511F53u} * counter[0];
        const std::uint64_t q = std::uint64_t{0xCD9E8D57u} * counter[2];
        counter = {static_cast<std::uint32_t>(q >> 32) ^ counter[1] ^ key[0],
                   static_cast<std::uint32_t>(q),
                   static_cast<std::uint32_t>(p >> 32) ^ counter[3] ^ key[1],
                   static_cast<std::uint32_t>(p)};
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

std::array<double, 2> RandomStream::normal() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    const double angle = 2 * std::numbers::pi * uniform();
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

std::uint32_t RandomStream::below(std::uint32_t n) {
    IDEOTYPE_EXPECT(n > 0);
    // Reject values of the last, incomplete run of n values.
    const std::uint32_t rejected = (0u - n) % n;
    std::uint32_t x = bits();
    while (x < rejected) x = bits();
    return x % n;
}

}  // namespace ideotype
