// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>

#include "breeder.hpp"
#include "optimizer.hpp"

namespace ideotype {

//! The genetic algorithm without a barrier between generations. The candidate
//! of row k follows from rows 0 to k - window alone: its parents are chosen by
//! tournament from the last of these, as many as a generation has, so that as
//! many as the window can be evaluated at the same time while nobody waits.
//! Rows that have no such parents are founders. As in GeneticAlgorithm, the
//! first slots of each generation are the best distinct parents, evaluated
//! again.
class SteadyState : public Optimizer {
  public:
    SteadyState(const SearchSettings& settings, SearchSpace space,
                std::uint64_t seed);

    std::size_t size(std::uint32_t) const override { return population_; }
    std::uint64_t needs(std::uint32_t generation,
                        std::uint32_t slot) const override;
    Candidate propose(std::uint32_t generation, std::uint32_t slot) override;
    void learn(Individual row) override;
    //! The best distinct of the last generation.
    std::vector<Candidate> best(std::size_t count) const override;

  private:
    std::uint64_t row(std::uint32_t generation, std::uint32_t slot) const;

    SearchSettings settings_;
    SearchSpace space_;
    Breeder breeder_;
    std::uint64_t population_, window_;
    std::deque<Individual> known_;  //!< the last rows
    std::uint64_t first_known_ = 0;
};

}  // namespace ideotype
