// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <utility>

#include "cma.hpp"
#include "ideotype/core/random.hpp"
#include "optimizer.hpp"
#include "order.hpp"
#include "unbounded_genes.hpp"

namespace ideotype {

namespace {

using Eigen::VectorXd;

VectorXd to_vector(const std::vector<double>& x) {
    return Eigen::Map<const VectorXd>(x.data(),
                                      static_cast<Eigen::Index>(x.size()));
}

//! Independent standard normal numbers.
VectorXd standard_normal(RandomStream stream, std::size_t size) {
    VectorXd x(static_cast<Eigen::Index>(size));
    for (Eigen::Index i = 0; i < x.size(); i += 2) {
        const auto [first, second] = stream.normal();
        x[i] = first;
        if (i + 1 < x.size()) x[i + 1] = second;
    }
    return x;
}

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
    CmaEs(const SearchSettings& settings, SearchSpace space, std::uint64_t seed)
        : settings_(settings.cma),
          space_(std::move(space)),
          coordinates_(space_.genes),
          seed_(seed),
          population_(static_cast<std::size_t>(settings.population)),
          cma_(begun_at(coordinates_.of(
              settings_.start.empty() ? space_.baseline : settings_.start))) {}

    std::vector<Candidate> ask() const override {
        std::vector<Candidate> candidates;
        for (std::uint32_t slot = 0; slot < population_; ++slot)
            candidates.push_back(sample(point(slot)));
        return candidates;
    }

    //! Returns the plant at the mean of the distribution, then the best of the
    //! last generation.
    std::vector<Candidate> best(std::size_t count) const override {
        std::vector<Candidate> candidates{sample(cma_.mean())};
        for (const Candidate& each :
             best_of(last_, count - 1, space_.senses, parents_row()))
            candidates.push_back(each);
        return candidates;
    }

  private:
    void take(Population evaluated) override {
        const std::vector<std::uint32_t> order =
            ranking(evaluated, space_.senses);
        Eigen::MatrixXd ranked(coordinates_.size(), order.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            ranked.col(static_cast<Eigen::Index>(i)) = point(order[i]);
        cma_.update(ranked);
        last_ = std::move(evaluated);
        constexpr double worst_condition = 1e14;
        if (restarts_ < settings_.restarts &&
            (cma_.widest() < settings_.smallest_step ||
             cma_.condition() > worst_condition))
            restart();
    }

    VectorXd point(std::uint32_t slot) const {
        return cma_.sample(standard_normal(
            RandomStream(seed_, Purpose::sample, generation(), slot),
            coordinates_.size()));
    }

    Candidate sample(const VectorXd& x) const {
        return {coordinates_.genome({x.begin(), x.end()}, space_.baseline),
                Origin::sample};
    }

    Cma begun_at(const std::vector<double>& mean) const {
        return {to_vector(mean), settings_.step, population_,
                settings_.adapts_learning_rates};
    }

    void restart() {
        ++restarts_;
        population_ *= 2;
        RandomStream stream(seed_, Purpose::initial_population,
                            generation() + 1);
        std::vector<double> mean;
        while (mean.size() < coordinates_.size())
            mean.push_back(stream.uniform());
        cma_ = begun_at(mean);
    }

    CmaSettings settings_;
    SearchSpace space_;
    UnboundedGenes coordinates_;
    std::uint64_t seed_;
    std::size_t population_;
    int restarts_ = 0;
    Cma cma_;
    Population last_;
};

}  // namespace

std::unique_ptr<GenerationalOptimizer> make_cma_es(
    const SearchSettings& settings, SearchSpace space, std::uint64_t seed) {
    return std::make_unique<CmaEs>(settings, std::move(space), seed);
}

}  // namespace ideotype
