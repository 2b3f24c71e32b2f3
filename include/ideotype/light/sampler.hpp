// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "ideotype/core/random.hpp"
#include "ideotype/core/sobol.hpp"

namespace ideotype {

//! The number of leading dimensions of a path that use a low-discrepancy
//! sequence; further numbers are independent.
inline constexpr std::size_t path_dimensions = 16;

//! The uniform numbers for the paths of one source in one randomisation: a
//! scrambled Sobol' sequence of any length. Different sources and
//! randomisations use independent numbers.
class PathSampler {
  public:
    PathSampler(std::uint64_t seed, std::uint32_t generation,
                std::uint32_t randomisation, std::uint32_t source)
        : generation_(generation) {
        RandomStream of_randomisation(seed, Purpose::scramble, generation,
                                      randomisation);
        RandomStream stream(of_randomisation.bits64(), Purpose::scramble,
                            source);
        for (std::uint32_t& s : scramble_seeds_) s = stream.bits();
        tail_seed_ = stream.bits64();
    }

    //! Moves to a dimension of the numbers of a path, by default the first.
    void begin(std::uint32_t path, std::size_t dimension = 0) {
        path_ = path;
        dimension_ = dimension;
        tail_.reset();
    }

    //! Returns the next number of this path, uniform in [0, 1).
    double next() {
        if (dimension_ == path_dimensions) return next_of_tail();
        const std::uint32_t x =
            scrambled(sobol(path_, dimension_), scramble_seeds_[dimension_]);
        ++dimension_;
        return x * 0x1p-32;
    }

  private:
    double next_of_tail() {
        if (!tail_)
            tail_.emplace(tail_seed_, Purpose::scattering, generation_, path_);
        return tail_->uniform();
    }

    std::uint32_t generation_;
    std::array<std::uint32_t, path_dimensions> scramble_seeds_;
    std::uint64_t tail_seed_;
    std::uint32_t path_ = 0;
    std::size_t dimension_ = 0;
    std::optional<RandomStream> tail_;
};

}  // namespace ideotype
