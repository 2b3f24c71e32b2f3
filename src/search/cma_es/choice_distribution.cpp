// SPDX-License-Identifier: Apache-2.0
#include "choice_distribution.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "dd_cma.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/mapped.hpp"

namespace ideotype {

ChoiceDistribution::ChoiceDistribution(
    std::vector<std::vector<double>> probabilities, double margin)
    : probabilities_(std::move(probabilities)), margin_(margin) {
    IDEOTYPE_EXPECT(!probabilities_.empty());
    IDEOTYPE_EXPECT(margin > 0 && margin < 0.5);
    std::size_t free = 0;
    for (const std::vector<double>& each : probabilities_) {
        IDEOTYPE_EXPECT(each.size() >= 2);
        free += each.size() - 1;
    }
    path_.resize(free);
}

ChoiceDistribution::Entries ChoiceDistribution::draw(
    RandomStream& stream) const {
    return mapped(probabilities_, [&](const std::vector<double>& each) {
        double rest = stream.uniform();
        std::size_t entry = 0;
        while (entry + 1 < each.size() && rest >= each[entry])
            rest -= each[entry++];
        return entry;
    });
}

void ChoiceDistribution::update(const std::vector<Entries>& ranked) {
    std::vector<double> weights = make_raw_weights(ranked.size());
    weights.resize(ranked.size() / 2);
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    // The natural gradient, and the same in coordinates in which the Fisher
    // information is 1 (Akimoto et al. 2019, appendix B).
    std::vector<std::vector<double>> gradient;
    std::vector<double> white;
    for (std::size_t c = 0; c < probabilities_.size(); ++c) {
        const std::vector<double>& p = probabilities_[c];
        std::vector<double>& slope = gradient.emplace_back(p.size());
        for (std::size_t i = 0; i < weights.size(); ++i)
            for (std::size_t k = 0; k < p.size(); ++k)
                slope[k] += weights[i] / total *
                            ((ranked[i].at(c) == k ? 1 : 0) - p[k]);
        const double sum = std::accumulate(slope.begin(), slope.end() - 1, 0.0);
        for (std::size_t k = 0; k + 1 < p.size(); ++k)
            white.push_back(slope[k] / std::sqrt(p[k]) +
                            std::sqrt(p[k]) * sum /
                                (p.back() + std::sqrt(p.back())));
    }
    const double length = std::sqrt(
        std::inner_product(white.begin(), white.end(), white.begin(), 0.0));
    constexpr double tiny = 1e-8;
    const double rate = 1 / (noise_ * (length + tiny));
    for (std::size_t c = 0; c < probabilities_.size(); ++c)
        for (std::size_t k = 0; k < probabilities_[c].size(); ++k)
            probabilities_[c][k] += rate * gradient[c][k];

    // The step size follows the length of the accumulated steps.
    constexpr double signal_to_noise = 1.5;
    const double cumulation = std::min(
        1.0, 1 / (noise_ * std::sqrt(static_cast<double>(path_.size()))));
    double squares = 0;
    for (std::size_t i = 0; i < path_.size(); ++i) {
        path_[i] = (1 - cumulation) * path_[i] +
                   std::sqrt(cumulation * (2 - cumulation)) * white[i] /
                       std::max(length, tiny);
        squares += path_[i] * path_[i];
    }
    reached_ = (1 - cumulation) * (1 - cumulation) * reached_ +
               cumulation * (2 - cumulation);
    noise_ *= std::exp(cumulation * (reached_ - squares / signal_to_noise));
    correct();
}

//! Raises probabilities to the margin, and lowers the others in proportion to
//! what they have above it.
void ChoiceDistribution::correct() {
    for (std::vector<double>& p : probabilities_) {
        const double least = margin_ / static_cast<double>(p.size() - 1);
        for (double& each : p) each = std::max(each, least);
        const double sum = std::accumulate(p.begin(), p.end(), 0.0);
        const double above = sum - least * static_cast<double>(p.size());
        for (double& each : p) each -= (sum - 1) * (each - least) / above;
        const double total = std::accumulate(p.begin(), p.end(), 0.0);
        for (double& each : p) each /= total;
    }
}

ChoiceDistribution::Entries ChoiceDistribution::mode() const {
    return mapped(probabilities_, [](const std::vector<double>& each) {
        return static_cast<std::size_t>(
            std::max_element(each.begin(), each.end()) - each.begin());
    });
}

}  // namespace ideotype
