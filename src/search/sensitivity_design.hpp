// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "optimizer.hpp"
#include "population.hpp"
#include "sobol_sequence.hpp"

namespace ideotype {

//! Genes that are varied together.
struct Factor {
    std::string name;  //!< name of a gene, or of the trait of its genes
    std::vector<std::size_t> genes;  //!< indices of the factor's free genes
};

//! The rows of a sensitivity study. They are fixed before any evaluation, and
//! consist of samples with equal numbers of rows; all genes are uniform within
//! their bounds. For Sobol' indices, a sample consists of two points A and B of
//! a scrambled Sobol' sequence and, between them, A with one factor at a time
//! taken from B (Saltelli et al. 2010, doi:10.1016/j.cpc.2009.09.018). For the
//! method of Morris (1991, doi:10.1080/00401706.1991.10484804), it is a path on
//! a grid; each factor makes one step, in random order. The genes of a factor
//! change together (Campolongo et al. 2007, doi:10.1016/j.envsoft.2006.10.004).
//! The design replaces an optimizer: it proposes its rows sample after sample,
//! and does not learn.
class SensitivityDesign : public Optimizer {
  public:
    SensitivityDesign(const SensitivitySettings& settings, SearchSpace space,
                      std::uint64_t seed);

    const std::vector<Factor>& factors() const { return factors_; }
    std::size_t samples() const {
        return static_cast<std::size_t>(settings_.samples);
    }
    std::size_t rows_per_sample() const {
        const bool is_morris = settings_.method == SensitivityMethod::morris;
        return factors_.size() + (is_morris ? 1 : 2);
    }

    //! Makes the genome of one row of a sample.
    //! @param number index of the row in the sample, below rows_per_sample()
    Genome make_row(std::uint32_t sample, std::size_t number) const;

    std::size_t size(std::uint32_t generation) const override;
    //! Allows a thousand rows in flight, so that no worker waits.
    std::uint64_t needs(std::uint32_t generation) const override;
    Candidate propose(std::uint32_t generation, std::uint32_t slot) override;
    void learn(Individual) override {}
    //! Returns nothing: a design has no best plant.
    std::vector<Candidate> best(std::size_t) const override { return {}; }

  private:
    std::vector<double> make_path_point(std::uint32_t sample,
                                        std::size_t row) const;
    std::vector<double> make_cube_point(std::uint32_t sample,
                                        std::size_t row) const;

    SensitivitySettings settings_;
    SearchSpace space_;
    std::uint64_t seed_;
    std::vector<Factor> factors_;
    std::vector<std::size_t> free_;  //!< indices of the free genes
    SobolSequence sequence_;
};

//! The number of samples stored as one generation of a history.
inline constexpr int samples_per_generation = 16;

//! Returns the number of rows per generation of a sensitivity study.
int generation_size(const SensitivitySettings& settings,
                    const GeneSpace& genes);
int count_generations(const SensitivitySettings& settings);

}  // namespace ideotype
