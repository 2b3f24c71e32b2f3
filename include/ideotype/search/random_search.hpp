#pragma once

#include <cstdint>

#include "ideotype/search/optimizer.hpp"

namespace ideotype {

//! Genomes uniform within their bounds, which nothing is learnt from: what any
//! other search has to beat.
class RandomSearch : public Optimizer {
  public:
    RandomSearch(const SearchSettings& settings, SearchSpace space,
                 std::uint64_t seed);

    std::vector<Candidate> ask() const override;
    void tell(Population evaluated) override;
    //! The best distinct of all generations, without parents.
    std::vector<Candidate> best(std::size_t count) const override;

  private:
    std::size_t population_;
    SearchSpace space_;
    std::uint64_t seed_;
    std::uint32_t generation_ = 0;  //!< the next one
    Population best_;               //!< of all, as many as may be asked for
};

//! The baseline with free genes uniform within their bounds.
Genome random_genome(const SearchSpace& space, std::uint64_t seed,
                     std::uint32_t generation, std::uint32_t slot);

}  // namespace ideotype
