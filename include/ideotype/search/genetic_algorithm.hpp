#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ideotype/search/breeder.hpp"
#include "ideotype/search/optimizer.hpp"

namespace ideotype {

//! A genetic algorithm with real-valued genes.
//!
//! Generation 0 is the baseline in slot 0 and genomes uniform within their
//! bounds in all others. Every later generation begins with the elites, the
//! best distinct genomes of the parents, which are evaluated again; the rest
//! are children of couples chosen by tournament (see Breeder). Of the past it
//! needs only the last generation.
//!
//! As NSGA-II (Deb et al. 2002, doi:10.1109/4235.996017) half of the population
//! are elites, by front and crowding, and they alone are parents. Since they
//! are evaluated again, parents and children are compared under the same random
//! numbers.
class GeneticAlgorithm : public GenerationalOptimizer {
  public:
    GeneticAlgorithm(const SearchSettings& settings, SearchSpace space,
                     std::uint64_t seed);

    std::vector<Candidate> ask() const override;
    //! The best distinct of the last generation.
    std::vector<Candidate> best(std::size_t count) const override;

  private:
    void take(Population evaluated) override;
    bool is_pareto() const;
    std::size_t elites() const;
    std::size_t contest(RandomStream& stream) const;

    SearchSettings settings_;
    SearchSpace space_;
    Breeder breeder_;
    Population parents_;                //!< the generation before the next
    std::vector<std::size_t> places_;   //!< of parents, see places()
    std::vector<std::uint32_t> mates_;  //!< slots of those that have children
};

}  // namespace ideotype
