// SPDX-License-Identifier: Apache-2.0
#include "cma_es.hpp"

#include <cmath>
#include <numbers>

#include "cma.hpp"
#include "ideotype/core/random.hpp"
#include "order.hpp"
#include "pareto.hpp"

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

}  // namespace

CmaEs::CmaEs(const SearchSettings& settings, SearchSpace space,
             std::uint64_t seed)
    : settings_(settings),
      space_(std::move(space)),
      coordinates_(space_.genes),
      seed_(seed),
      population_(static_cast<std::size_t>(settings.population)),
      cma_(std::make_unique<Cma>(
          to_vector(coordinates_.of(settings.cma.start.empty()
                                        ? space_.baseline
                                        : settings.cma.start)),
          settings.cma.step, population_, settings.cma.adapts_learning_rates)) {
}

CmaEs::~CmaEs() = default;

std::vector<double> CmaEs::point(std::uint32_t slot) const {
    const VectorXd x = cma_->sample(standard_normal(
        RandomStream(seed_, Purpose::sample, generation(), slot),
        coordinates_.size()));
    return {x.begin(), x.end()};
}

std::vector<Candidate> CmaEs::ask() const {
    std::vector<Candidate> candidates;
    for (std::uint32_t slot = 0; slot < population_; ++slot)
        candidates.push_back({coordinates_.genome(point(slot), space_.baseline),
                              Origin::sample});
    return candidates;
}

void CmaEs::take(Population evaluated) {
    const std::vector<std::uint32_t> order = ranking(evaluated, space_.senses);
    Eigen::MatrixXd ranked(coordinates_.size(), order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        ranked.col(static_cast<Eigen::Index>(i)) = to_vector(point(order[i]));
    cma_->update(ranked);
    last_ = std::move(evaluated);
    constexpr double worst_condition = 1e14;
    if (restarts_ < settings_.cma.restarts &&
        (cma_->widest() < settings_.cma.smallest_step ||
         cma_->condition() > worst_condition))
        restart();
}

void CmaEs::restart() {
    ++restarts_;
    population_ *= 2;
    RandomStream stream(seed_, Purpose::initial_population, generation() + 1);
    std::vector<double> mean;
    while (mean.size() < coordinates_.size()) mean.push_back(stream.uniform());
    cma_ =
        std::make_unique<Cma>(to_vector(mean), settings_.cma.step, population_,
                              settings_.cma.adapts_learning_rates);
}

std::vector<Candidate> CmaEs::best(std::size_t count) const {
    const VectorXd& mean = cma_->mean();
    std::vector<Candidate> candidates{
        {coordinates_.genome({mean.begin(), mean.end()}, space_.baseline),
         Origin::sample}};
    for (const Candidate& each :
         best_of(last_, count - 1, space_.senses, parents_row()))
        candidates.push_back(each);
    return candidates;
}

}  // namespace ideotype
