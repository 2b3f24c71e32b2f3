// SPDX-License-Identifier: Apache-2.0
#include "sobol_sequence.hpp"

#include "ideotype/core/contract.hpp"
#include "ideotype/core/random.hpp"
#include "ideotype/core/sobol.hpp"

namespace ideotype {

SobolSequence::SobolSequence(std::uint64_t seed, std::size_t dimensions)
    : seed_(seed) {
    RandomStream stream(seed, Purpose::sequence);
    while (scramble_seeds_.size() < dimensions)
        scramble_seeds_.push_back(stream.bits());
}

double SobolSequence::at(std::uint32_t point, std::size_t dimension) const {
    IDEOTYPE_EXPECT(dimension < scramble_seeds_.size());
    if (dimension >= sobol_dimensions)
        return RandomStream(seed_, Purpose::sequence,
                            static_cast<std::uint32_t>(dimension), point)
            .uniform();
    return scrambled(sobol(point, dimension), scramble_seeds_[dimension]) *
           0x1p-32;
}

}  // namespace ideotype
