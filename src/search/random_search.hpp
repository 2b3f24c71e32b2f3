// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "optimizer.hpp"
#include "sobol_sequence.hpp"

namespace ideotype {

//! Genomes that fill the space within their bounds evenly, independent or as
//! points of a SobolSequence. Nothing is learnt from them: it is what any other
//! search has to beat.
class RandomSearch : public Optimizer {
  public:
    RandomSearch(const SearchSettings& settings, SearchSpace space,
                 std::uint64_t seed);

    std::size_t size(std::uint32_t) const override { return population_; }
    //! Two generations may be under way, so that nobody waits for the last
    //! plants of one.
    std::uint64_t needs(std::uint32_t generation,
                        std::uint32_t slot) const override;
    Candidate propose(std::uint32_t generation, std::uint32_t slot) override;
    void learn(Individual row) override;
    //! The best distinct of all generations, without parents.
    std::vector<Candidate> best(std::size_t count) const override;

  private:
    std::size_t population_;
    SearchSpace space_;
    std::uint64_t seed_;
    std::optional<SobolSequence> sequence_;  //!< of free genes
    Population best_;  //!< of all, as many as may be asked for
};

//! The baseline with free genes uniform within their bounds.
Genome random_genome(const SearchSpace& space, std::uint64_t seed,
                     std::uint32_t generation, std::uint32_t slot);

}  // namespace ideotype
