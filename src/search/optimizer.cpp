#include "ideotype/search/optimizer.hpp"

#include "ideotype/search/cma_es.hpp"
#include "ideotype/search/genetic_algorithm.hpp"
#include "ideotype/search/random_search.hpp"

namespace ideotype {

std::unique_ptr<Optimizer> make_optimizer(const SearchSettings& settings,
                                          const SearchSpace& space,
                                          std::uint64_t seed) {
    switch (settings.optimizer) {
        case OptimizerKind::ga:
        case OptimizerKind::nsga2:
            break;
        case OptimizerKind::cma_es:
            return std::make_unique<CmaEs>(settings, space, seed);
        case OptimizerKind::random:
            return std::make_unique<RandomSearch>(settings, space, seed);
    }
    return std::make_unique<GeneticAlgorithm>(settings, space, seed);
}

}  // namespace ideotype
