// SPDX-License-Identifier: Apache-2.0
#include "ideotype/light/sampler.hpp"

namespace ideotype {

PathSampler::PathSampler(std::uint64_t seed, std::uint32_t generation,
                         std::uint32_t randomisation, std::uint32_t source)
    : generation_(generation) {
    RandomStream of_randomisation(seed, Purpose::scramble, generation,
                                  randomisation);
    RandomStream stream(of_randomisation.bits64(), Purpose::scramble, source);
    for (std::uint32_t& s : scramble_seeds_) s = stream.bits();
    tail_seed_ = stream.bits64();
}

double PathSampler::next_of_tail() {
    if (!tail_)
        tail_.emplace(tail_seed_, Purpose::scattering, generation_, path_);
    return tail_->uniform();
}

}  // namespace ideotype
