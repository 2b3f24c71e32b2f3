// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "arm.hpp"
#include "ideotype/core/contract.hpp"
#include "search/optimizer.hpp"
#include "search/order.hpp"

namespace ideotype {

namespace {

//! A search by dd-CMA-ES from the configured start, by default the baseline.
class CmaEs : public GenerationalOptimizer {
  public:
    CmaEs(const SearchSettings& settings, SearchSpace space, std::uint64_t seed)
        : space_(std::move(space)),
          seed_(seed),
          arm_(UnboundedGenes(space_.genes),
               settings.start.empty() ? space_.baseline : settings.start,
               static_cast<std::size_t>(settings.population)) {}

    std::size_t next_size() const override { return arm_.population(); }

    Candidate candidate(std::uint32_t slot) override {
        return arm_.candidate(seed_, generation(), 0, slot, space_.baseline);
    }

    //! Returns the plant at the mean of the distribution, then the best of the
    //! last generation.
    std::vector<Candidate> best(std::size_t count) const override {
        IDEOTYPE_EXPECT(count > 0);
        std::vector<Candidate> candidates{arm_.centre(space_.baseline)};
        for (const Candidate& candidate :
             select_best(last_, count - 1, space_.senses, parents_row()))
            candidates.push_back(candidate);
        return candidates;
    }

  private:
    void take(Population evaluated) override {
        arm_.learn(evaluated, space_.senses, seed_, generation(), 0);
        last_ = std::move(evaluated);
    }

    SearchSpace space_;
    std::uint64_t seed_;
    Arm arm_;
    Population last_;
};

}  // namespace

std::unique_ptr<GenerationalOptimizer> make_cma_es(
    const SearchSettings& settings, SearchSpace space, std::uint64_t seed) {
    return std::make_unique<CmaEs>(settings, std::move(space), seed);
}

}  // namespace ideotype
