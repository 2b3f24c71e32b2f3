// SPDX-License-Identifier: Apache-2.0
#include "ideotype/light/sampler.hpp"

#include "ideotype/core/sobol.hpp"

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

void PathSampler::begin(std::uint32_t path, std::size_t dimension) {
    path_ = path;
    dimension_ = dimension;
    tail_.reset();
}

double PathSampler::next() {
    if (dimension_ < path_dimensions) {
        const std::uint32_t x =
            scrambled(sobol(path_, dimension_), scramble_seeds_[dimension_]);
        ++dimension_;
        return x * 0x1p-32;
    }
    if (!tail_)
        tail_.emplace(tail_seed_, Purpose::scattering, generation_, path_);
    return tail_->uniform();
}

}  // namespace ideotype
