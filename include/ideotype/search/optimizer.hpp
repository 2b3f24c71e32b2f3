#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "ideotype/search/genome.hpp"
#include "ideotype/search/population.hpp"
#include "ideotype/search/settings.hpp"

namespace ideotype {

//! What is searched for the best plant.
struct SearchSpace {
    GeneSpace genes;
    Genome baseline;                             //!< where the search begins
    std::vector<Sense> senses{Sense::maximise};  //!< of the objectives
};

//! Proposes candidates generation by generation. What it proposes depends on
//! its settings, its seed and the generations that it was told, and on nothing
//! else: random numbers are a function of (seed, purpose, generation, slot). To
//! resume, a new optimizer is told the stored generations and goes on with the
//! same bits. Generations may differ in size.
class Optimizer {
  public:
    virtual ~Optimizer() = default;

    //! The candidates of the next generation, by slot; the same for each call
    //! until tell().
    virtual std::vector<Candidate> ask() const = 0;

    //! Takes the evaluated candidates of that generation, by slot.
    virtual void tell(Population evaluated) = 0;

    //! What to evaluate again at the end, best first; after a generation that
    //! was told. Parents are slots of that.
    virtual std::vector<Candidate> best(std::size_t count) const = 0;
};

//! The optimizer that the settings name, before the first generation.
std::unique_ptr<Optimizer> make_optimizer(const SearchSettings& settings,
                                          const SearchSpace& space,
                                          std::uint64_t seed);

}  // namespace ideotype
