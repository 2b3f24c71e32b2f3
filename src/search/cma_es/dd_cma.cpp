// SPDX-License-Identifier: Apache-2.0
#include "dd_cma.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>

#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

std::vector<double> raw_weights(std::size_t population) {
    std::vector<double> weights(population);
    for (std::size_t i = 0; i < population; ++i)
        weights[i] = std::log((static_cast<double>(population) + 1) / 2) -
                     std::log(static_cast<double>(i + 1));
    return weights;
}

//! Returns the number of equal weights with the variance of the weights of one
//! sign.
double effective(const std::vector<double>& weights, double sign) {
    double sum = 0, squares = 0;
    for (const double w : weights)
        if (w * sign > 0) {
            sum += w;
            squares += w * w;
        }
    return sum * sum / squares;
}

}  // namespace

DdCma::Rates DdCma::rates(double n, double degrees_of_freedom,
                          const std::vector<double>& raw_weights) {
    const double mu = effective(raw_weights, 1);
    const auto population = static_cast<double>(raw_weights.size());
    Rates rates;
    rates.rank_one =
        1 / (2 * (degrees_of_freedom / n + 1) * std::pow(n + 1, .75) + mu / 2);
    rates.rank_mu =
        std::min(1 - rates.rank_one,
                 (mu + 1 / mu - 2 + population / (2 * (population + 5))) *
                     rates.rank_one);
    rates.path = std::min(1.0, std::sqrt(mu * rates.rank_one) / 2);
    double positive = 0, negative = 0;
    for (const double w : raw_weights) (w > 0 ? positive : negative) += w;
    const double most_negative =
        std::min(1 + rates.rank_one / rates.rank_mu,
                 1 + 2 * effective(raw_weights, -1) / (mu + 2));
    rates.weights.resize(static_cast<Eigen::Index>(raw_weights.size()));
    for (std::size_t i = 0; i < raw_weights.size(); ++i)
        rates.weights[static_cast<Eigen::Index>(i)] =
            raw_weights[i] /
            (raw_weights[i] > 0 ? positive : -negative / most_negative);
    return rates;
}

void DdCma::Path::add(const VectorXd& step, double rate,
                      double effective_parents, bool is_usual) {
    steps *= 1 - rate;
    share *= (1 - rate) * (1 - rate);
    if (!is_usual) return;
    steps += std::sqrt(rate * (2 - rate) * effective_parents) * step;
    share += rate * (2 - rate);
}

DdCma::DdCma(VectorXd mean, VectorXd deviations, std::size_t population)
    : mean_(std::move(mean)), scales_(std::move(deviations)) {
    IDEOTYPE_EXPECT(mean_.size() > 0 && mean_.size() == scales_.size());
    IDEOTYPE_EXPECT((scales_.array() > 0).all());
    set_population(population);
    const auto n = static_cast<double>(mean_.size());
    usual_length_ = std::sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n));
    step_path_.steps = path_of_correlation_.steps = path_of_scales_.steps =
        VectorXd::Zero(mean_.size());
    correlation_ = root_ = inverse_root_ =
        MatrixXd::Identity(mean_.size(), mean_.size());
}

void DdCma::set_population(std::size_t population) {
    IDEOTYPE_EXPECT(population >= 4);
    const auto n = static_cast<double>(mean_.size());
    const std::vector<double> weights = raw_weights(population);
    effective_parents_ = effective(weights, 1);
    parents_ = population / 2;
    of_correlation_ = rates(n, n * (n + 1) / 2, weights);
    of_scales_ = rates(n, n, weights);
    const double mu = effective_parents_;
    step_rate_ = (mu + 2) / (n + mu + 5);
    step_damping_ =
        1 + 2 * std::max(0.0, std::sqrt((mu - 1) / (n + 1)) - 1) + step_rate_;
}

VectorXd DdCma::sample(const VectorXd& normal) const {
    IDEOTYPE_EXPECT(normal.size() == mean_.size());
    return mean_ + step_size_ * scales_.cwiseProduct(root_ * normal);
}

void DdCma::update(const MatrixXd& ranked) {
    IDEOTYPE_EXPECT(ranked.rows() == mean_.size());
    IDEOTYPE_EXPECT(ranked.cols() == of_correlation_.weights.size());
    IDEOTYPE_EXPECT(ranked.allFinite());
    const auto n = static_cast<double>(mean_.size());
    // Columns would be standard normal vectors without selection.
    const MatrixXd white = inverse_root_ *
                           (scales_ * step_size_).cwiseInverse().asDiagonal() *
                           (ranked.colwise() - mean_);
    const auto parents = static_cast<Eigen::Index>(parents_);
    const VectorXd step =
        white.leftCols(parents) * of_correlation_.weights.head(parents);
    const VectorXd moved = scales_.cwiseProduct(root_ * step);
    mean_ += step_size_ * moved;

    step_path_.add(step, step_rate_, effective_parents_, true);
    const double length = step_path_.steps.norm();
    const bool is_usual =
        length * length < (2 + 4 / (n + 1)) * n * step_path_.share;

    // Vectors with negative weights count as if they had the expected length.
    const auto weighted = [&](const VectorXd& weights) {
        VectorXd scaled = weights;
        for (Eigen::Index i = 0; i < weights.size(); ++i)
            if (weights[i] < 0)
                scaled[i] *= n / std::max(white.col(i).squaredNorm(), 1e-8);
        return scaled;
    };
    const auto whitened = [&](const Path& path) -> VectorXd {
        return inverse_root_ * path.steps.cwiseQuotient(scales_);
    };

    path_of_correlation_.add(moved, of_correlation_.path, effective_parents_,
                             is_usual);
    const VectorXd along = whitened(path_of_correlation_);
    const VectorXd weights = weighted(of_correlation_.weights);
    MatrixXd change = of_correlation_.rank_mu *
                          (white * weights.asDiagonal() * white.transpose()) +
                      of_correlation_.rank_one * (along * along.transpose());
    change.diagonal().array() -=
        of_correlation_.rank_mu * of_correlation_.weights.sum() +
        of_correlation_.rank_one * path_of_correlation_.share;
    // A bounded change leaves the correlation positive definite.
    constexpr double most = 0.75;
    const double least =
        Eigen::SelfAdjointEigenSolver<MatrixXd>(change, Eigen::EigenvaluesOnly)
            .eigenvalues()
            .minCoeff();
    if (least < -most) change *= most / -least;

    path_of_scales_.add(moved, of_scales_.path, effective_parents_, is_usual);
    const VectorXd squares_of_path = whitened(path_of_scales_).cwiseAbs2();
    const VectorXd squares = white.cwiseAbs2() * weighted(of_scales_.weights);
    const VectorXd growth =
        of_scales_.rank_mu *
            (squares.array() - of_scales_.weights.sum()).matrix() +
        of_scales_.rank_one *
            (squares_of_path.array() - path_of_scales_.share).matrix();
    // D changes more slowly if the directions of C are poorly known.
    const double damping =
        1 + std::max(0.0, std::sqrt(correlation_condition_) - 2);

    correlation_ += root_ * change * root_;
    scales_.array() *= (growth.array() / (2 * damping)).exp();
    step_size_ *=
        std::exp(step_rate_ / step_damping_ *
                 (length / usual_length_ - std::sqrt(step_path_.share)));
    decompose();
}

//! Makes C a correlation matrix again by moving its variances to the scales,
//! and computes its roots.
void DdCma::decompose() {
    const VectorXd deviations = correlation_.diagonal().cwiseSqrt();
    scales_.array() *= deviations.array();
    const VectorXd inverse = deviations.cwiseInverse();
    correlation_ = (inverse.asDiagonal() *
                    ((correlation_ + correlation_.transpose()) / 2).eval() *
                    inverse.asDiagonal())
                       .eval();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(correlation_);
    // Rounding may leave an axis without extent.
    constexpr double least = 1e-14;
    const VectorXd values = solver.eigenvalues().cwiseMax(least);
    const MatrixXd& axes = solver.eigenvectors();
    root_ = axes * values.cwiseSqrt().asDiagonal() * axes.transpose();
    inverse_root_ = axes * values.cwiseSqrt().cwiseInverse().asDiagonal() *
                    axes.transpose();
    IDEOTYPE_ENSURE((correlation_.diagonal().array() - 1).abs().maxCoeff() <
                    1e-9);
    correlation_condition_ = values.maxCoeff() / values.minCoeff();
}

}  // namespace ideotype
