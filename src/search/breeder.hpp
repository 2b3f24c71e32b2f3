// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <utility>

#include "ideotype/core/random.hpp"
#include "optimizer.hpp"

namespace ideotype {

//! An individual that may have children.
struct Parent {
    const Individual& individual;
    std::int64_t row = no_parent;
};

//! A function that selects a parent with random numbers.
using Contest = std::function<Parent(RandomStream&)>;

//! Makes children from parents, with the random numbers of a generation and
//! slot. Genes are recombined by simulated binary crossover (Deb and Agrawal
//! 1995), and each crossed gene goes to either child (Deb et al. 2002).
//! Polynomial mutation follows (Deb and Goyal 1996). On circular genes both
//! operators act along the shorter arc. Integers are rounded; choices are
//! inherited from either parent, and mutate to any other value. Genes that are
//! not free keep the value of the baseline.
class Breeder {
  public:
    Breeder(const GaSettings& settings, SearchSpace space, std::uint64_t seed);

    //! Makes the two children of a couple, for `slot` and the slot after it.
    std::pair<Candidate, Candidate> make_children(const Contest& contest,
                                                  std::uint32_t generation,
                                                  std::uint32_t slot) const;

  private:
    void mutate_genome(Genome& genome, std::uint32_t generation,
                       std::uint32_t slot) const;

    GaSettings settings_;
    SearchSpace space_;
    std::uint64_t seed_;
};

}  // namespace ideotype
