// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "breeder.hpp"
#include "optimizer.hpp"

namespace ideotype {

//! A genetic algorithm with real-valued genes.
//!
//! Generation 0 is the baseline in slot 0 and genomes uniform within their
//! bounds in all others. Every later generation begins with the elites, the
//! best distinct genomes of the parents, which are evaluated again; the rest
//! are children of couples chosen by tournament (see Breeder).
//!
//! As NSGA-II (Deb et al. 2002, doi:10.1109/4235.996017) all of a generation
//! are children. The best distinct, by front and crowding, of them and of their
//! parents are the next parents. These keep what they were evaluated to, which
//! may be luck: to evaluate them again under the random numbers of their
//! children costs more than it gains (campaigns/study/RESULTS.md).
class GeneticAlgorithm : public GenerationalOptimizer {
  public:
    GeneticAlgorithm(const SearchSettings& settings, SearchSpace space,
                     std::uint64_t seed);

    std::vector<Candidate> ask() const override;
    //! The best distinct of the next parents.
    std::vector<Candidate> best(std::size_t count) const override;

  private:
    void take(Population evaluated) override;
    bool is_pareto() const;
    void select(Population& all, std::vector<std::int64_t>& rows) const;
    std::size_t contest(RandomStream& stream) const;

    SearchSettings settings_;
    SearchSpace space_;
    Breeder breeder_;
    Population parents_;               //!< of the next generation
    std::vector<std::int64_t> rows_;   //!< of parents
    std::vector<std::size_t> places_;  //!< of parents, see places()
};

}  // namespace ideotype
