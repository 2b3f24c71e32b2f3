// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "population.hpp"
#include "settings.hpp"

namespace ideotype {

//! The search space of plants, and whether each objective is maximised or
//! minimised.
struct SearchSpace {
    GeneSpace genes;
    Genome baseline;  //!< starting point of the search
    std::vector<Sense> senses{Sense::maximise};  //!< senses of the objectives
    bool is_constrained = false;  //!< whether plants may violate constraints
};

//! Proposes candidates row by row. A candidate depends only on the settings,
//! the seed and the evaluated rows 0 to needs() - 1; other rows and their order
//! of arrival have no effect. Random numbers are a function of (seed, purpose,
//! generation, slot). After a restart, a new optimizer learns the stored rows
//! and continues with bit-identical proposals. Row numbers continue through all
//! generations. The rows of a generation use common random numbers and are
//! committed together.
class Optimizer {
  public:
    virtual ~Optimizer() = default;

    //! Returns the number of rows of a generation, never 0. Call it once the
    //! first row of the generation can be proposed.
    virtual std::size_t size(std::uint32_t generation) const = 0;

    //! Returns the number of rows that must be learnt before a generation can
    //! be proposed, or the largest number while this is unknown.
    virtual std::uint64_t needs(std::uint32_t generation) const = 0;

    //! Returns the candidate of a slot; calls must follow the order of rows.
    virtual Candidate propose(std::uint32_t generation, std::uint32_t slot) = 0;

    //! Adds the next evaluated row.
    virtual void learn(Individual row) = 0;

    //! Returns the candidates for the final evaluations, best first. Call it
    //! only after complete generations.
    virtual std::vector<Candidate> best(std::size_t count) const = 0;
};

//! Proposes one generation at a time, based on all earlier generations.
class GenerationalOptimizer : public Optimizer {
  public:
    //! Returns the number of candidates of the next generation, which may vary.
    virtual std::size_t next_size() const = 0;

    //! Returns a candidate of the next generation. It does not change before
    //! tell().
    virtual Candidate candidate(std::uint32_t slot) = 0;

    //! Returns all candidates of the next generation, by slot.
    std::vector<Candidate> ask();

    //! Adds the evaluated candidates of the next generation, by slot.
    void tell(Population evaluated);

    std::size_t size(std::uint32_t generation) const override;
    std::uint64_t needs(std::uint32_t generation) const override;
    Candidate propose(std::uint32_t generation, std::uint32_t slot) override;
    void learn(Individual row) override;

  protected:
    //! Learns from the evaluated next generation.
    virtual void take(Population evaluated) = 0;

    //! Returns the number of the next generation.
    std::uint32_t generation() const { return generation_; }
    //! Returns the first row of the last learnt generation.
    std::int64_t parents_row() const { return parents_row_; }

  private:
    std::uint32_t generation_ = 0;
    std::int64_t parents_row_ = 0;
    std::int64_t row_ = 0;  //!< first row of the next generation
    Population learnt_;     //!< rows learnt of the next generation
};

//! Returns the baseline with free genes uniform within their bounds.
Genome random_genome(const SearchSpace& space, std::uint64_t seed,
                     std::uint32_t generation, std::uint32_t slot);

//! Returns the baseline for generation 0 and slot 0, else a random genome.
Candidate make_founder(const SearchSpace& space, std::uint64_t seed,
                       std::uint32_t generation, std::uint32_t slot);

//! The following functions make optimizers of each kind before the first row;
//! their sources describe the algorithms.
std::unique_ptr<GenerationalOptimizer> make_genetic_algorithm(
    const SearchSettings& settings, SearchSpace space, std::uint64_t seed);
std::unique_ptr<GenerationalOptimizer> make_atlas(
    const SearchSettings& settings, SearchSpace space, std::uint64_t seed);
std::unique_ptr<GenerationalOptimizer> make_cma_es(
    const SearchSettings& settings, SearchSpace space, std::uint64_t seed);
std::unique_ptr<GenerationalOptimizer> make_auto_search(
    const SearchSettings& settings, SearchSpace space, std::uint64_t seed);

//! Makes the optimizer selected by the settings, before the first row.
std::unique_ptr<Optimizer> make_optimizer(const SearchSettings& settings,
                                          const SearchSpace& space,
                                          std::uint64_t seed);

}  // namespace ideotype
