// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "optimizer.hpp"
#include "unbounded_genes.hpp"

namespace ideotype {

class Cma;

//! CMA-ES (Hansen, arXiv:1604.00772) over the UnboundedGenes of the free genes.
//! The distribution begins around the start or the baseline; plants are ranked
//! as by is_better(), so that those that meet the constraints come first. Its
//! state follows from the generations that it was told, since it draws their
//! points again. A search that has converged begins anew around a random plant
//! with twice the population (IPOP, Auger and Hansen 2005,
//! doi:10.1109/CEC.2005.1554902) as often as the settings allow; after that it
//! goes on as it is.
class CmaEs : public GenerationalOptimizer {
  public:
    CmaEs(const SearchSettings& settings, SearchSpace space,
          std::uint64_t seed);
    ~CmaEs() override;

    std::vector<Candidate> ask() const override;
    //! The plant at the mean of the distribution, then the best of the last
    //! generation.
    std::vector<Candidate> best(std::size_t count) const override;

  private:
    void take(Population evaluated) override;
    std::vector<double> point(std::uint32_t slot) const;
    void restart();

    SearchSettings settings_;
    SearchSpace space_;
    UnboundedGenes coordinates_;
    std::uint64_t seed_;
    std::size_t population_;
    int restarts_ = 0;
    std::unique_ptr<Cma> cma_;
    Population last_;
};

}  // namespace ideotype
