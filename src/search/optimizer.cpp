// SPDX-License-Identifier: Apache-2.0
#include "optimizer.hpp"

#include <limits>
#include <utility>

#include "sensitivity_design.hpp"

namespace ideotype {

void GenerationalOptimizer::tell(Population evaluated) {
    parents_row_ = row_;
    row_ += static_cast<std::int64_t>(evaluated.size());
    asked_.clear();
    learnt_.clear();
    take(std::move(evaluated));
    ++generation_;
}

const std::vector<Candidate>& GenerationalOptimizer::asked() const {
    if (asked_.empty()) asked_ = ask();
    return asked_;
}

std::size_t GenerationalOptimizer::size(std::uint32_t) const {
    return asked().size();
}

std::uint64_t GenerationalOptimizer::needs(std::uint32_t generation,
                                           std::uint32_t) const {
    return generation == generation_
               ? static_cast<std::uint64_t>(row_)
               : std::numeric_limits<std::uint64_t>::max();
}

Candidate GenerationalOptimizer::propose(std::uint32_t, std::uint32_t slot) {
    return asked()[slot];
}

void GenerationalOptimizer::learn(Individual row) {
    learnt_.push_back(std::move(row));
    if (learnt_.size() == asked().size()) tell(std::exchange(learnt_, {}));
}

std::unique_ptr<Optimizer> make_optimizer(const SearchSettings& settings,
                                          const SearchSpace& space,
                                          std::uint64_t seed) {
    if (settings.design)
        return std::make_unique<SensitivityDesign>(*settings.design, space,
                                                   seed);
    switch (settings.optimizer) {
        case OptimizerKind::ga:
            if (settings.window > 0)
                return make_steady_state(settings, space, seed);
            break;
        case OptimizerKind::nsga2:
            break;
        case OptimizerKind::cma_es:
            return make_cma_es(settings, space, seed);
        case OptimizerKind::random:
        case OptimizerKind::sobol:
            return make_random_search(settings, space, seed);
    }
    return make_genetic_algorithm(settings, space, seed);
}

}  // namespace ideotype
