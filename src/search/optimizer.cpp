#include "ideotype/search/optimizer.hpp"

#include "ideotype/search/genetic_algorithm.hpp"

namespace ideotype {

std::unique_ptr<Optimizer> make_optimizer(const SearchSettings& settings,
                                          const SearchSpace& space,
                                          std::uint64_t seed) {
    switch (settings.optimizer) {
        case OptimizerKind::ga:
            break;
    }
    return std::make_unique<GeneticAlgorithm>(settings, space, seed);
}

}  // namespace ideotype
