#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "ideotype/core/random.hpp"
#include "ideotype/search/optimizer.hpp"

namespace ideotype {

//! A genetic algorithm with real-valued genes.
//!
//! Generation 0 is the baseline in slot 0 and genomes uniform within their
//! bounds in all others. Every later generation begins with the elites, the
//! best distinct genomes of the parents, which are evaluated again; the rest
//! are children of couples chosen by tournament, recombined by simulated
//! binary crossover (Deb and Agrawal 1995), after which each crossed gene goes
//! to either child (Deb et al. 2002), and varied by polynomial mutation (Deb
//! and Goyal 1996). On circular genes both act along the shorter arc. Genes
//! that are not free always keep the baseline's value. Of the past it needs
//! only the last generation.
//!
//! As NSGA-II (Deb et al. 2002, doi:10.1109/4235.996017) half of the population
//! are elites, by front and crowding, and they alone are parents. Since they
//! are evaluated again, parents and children are compared under the same random
//! numbers.
class GeneticAlgorithm : public Optimizer {
  public:
    GeneticAlgorithm(const SearchSettings& settings, SearchSpace space,
                     std::uint64_t seed);

    std::vector<Candidate> ask() const override;
    void tell(Population evaluated) override;
    //! The best distinct of the last generation.
    std::vector<Candidate> best(std::size_t count) const override;

  private:
    bool is_pareto() const;
    std::size_t elites() const;
    std::vector<Candidate> first_generation() const;
    std::pair<Candidate, Candidate> children(std::uint32_t slot) const;
    std::int32_t tournament(RandomStream& stream) const;
    void mutate_genome(Genome& genome, std::uint32_t slot) const;

    SearchSettings settings_;
    SearchSpace space_;
    std::uint64_t seed_;
    std::uint32_t generation_ = 0;      //!< the next one
    Population parents_;                //!< the generation before it
    std::vector<std::size_t> places_;   //!< of parents, see places()
    std::vector<std::uint32_t> mates_;  //!< slots of those that have children
};

}  // namespace ideotype
