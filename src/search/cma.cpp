// SPDX-License-Identifier: Apache-2.0
#include "cma.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Eigenvalues>

namespace ideotype {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

Eigen::Index index(std::size_t i) {
    return static_cast<Eigen::Index>(i);
}

}  // namespace

Cma::Cma(VectorXd mean, double step_size, std::size_t population,
         bool adapts_learning_rates)
    : weights_(population),
      parents_(population / 2),
      adapts_learning_rates_(adapts_learning_rates),
      mean_(std::move(mean)),
      step_size_(step_size) {
    const auto n = static_cast<double>(mean_.size());
    for (std::size_t i = 0; i < population; ++i)
        weights_[i] = std::log((static_cast<double>(population) + 1) / 2) -
                      std::log(static_cast<double>(i + 1));
    const auto middle =
        weights_.begin() + static_cast<std::ptrdiff_t>(parents_);
    const auto effective = [](auto first, auto last) {
        double sum = 0, squares = 0;
        for (; first != last; ++first) {
            sum += *first;
            squares += *first * *first;
        }
        return sum * sum / squares;
    };
    effective_parents_ = effective(weights_.begin(), middle);
    const double mu = effective_parents_;
    rank_one_rate_ = 2 / ((n + 1.3) * (n + 1.3) + mu);
    rank_mu_rate_ = std::min(1 - rank_one_rate_ - 1e-8,
                             2 * (mu - 2 + 1 / mu) / ((n + 2) * (n + 2) + mu));
    // The covariance matrix stays positive definite (eq. 50 to 53).
    const double most_negative =
        std::min({1 + rank_one_rate_ / rank_mu_rate_,
                  1 + 2 * effective(middle, weights_.end()) / (mu + 2),
                  (1 - rank_one_rate_ - rank_mu_rate_) / (n * rank_mu_rate_)});
    double positive = 0, negative = 0;
    for (const double w : weights_) (w > 0 ? positive : negative) += w;
    for (double& w : weights_)
        w *= w >= 0 ? 1 / positive : -most_negative / negative;

    path_rate_ = (4 + mu / n) / (n + 4 + 2 * mu / n);
    step_rate_ = (mu + 2) / (n + mu + 5);
    step_damping_ =
        1 + 2 * std::max(0.0, std::sqrt((mu - 1) / (n + 1)) - 1) + step_rate_;
    usual_length_ = std::sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n));

    path_ = step_path_ = VectorXd::Zero(mean_.size());
    covariance_ = axes_ = MatrixXd::Identity(mean_.size(), mean_.size());
    deviations_ = VectorXd::Ones(mean_.size());
    mean_learning_.mean_change = VectorXd::Zero(mean_.size());
    covariance_learning_.mean_change =
        MatrixXd::Zero(mean_.size(), mean_.size());
}

VectorXd Cma::sample(const VectorXd& normal) const {
    return mean_ +
           step_size_ * (axes_ * deviations_.cwiseProduct(normal).eval());
}

void Cma::update(const MatrixXd& ranked) {
    const auto n = static_cast<double>(mean_.size());
    const double mu = effective_parents_;
    const MatrixXd whitening =
        axes_ * deviations_.cwiseInverse().asDiagonal() * axes_.transpose();
    const Before before{mean_, step_size_, covariance_, whitening};
    ++updates_;

    const MatrixXd steps = (ranked.colwise() - mean_) / step_size_;
    VectorXd step = VectorXd::Zero(mean_.size());
    for (std::size_t i = 0; i < parents_; ++i)
        step += weights_[i] * steps.col(index(i));
    mean_ += step_size_ * step;

    step_path_ =
        (1 - step_rate_) * step_path_ +
        std::sqrt(step_rate_ * (2 - step_rate_) * mu) * (whitening * step);
    const double length = step_path_.norm();
    step_size_ *=
        std::exp(step_rate_ / step_damping_ * (length / usual_length_ - 1));

    // A long step path means that the step size still grows: then the path of
    // the covariance waits.
    const bool is_usual =
        length / std::sqrt(1 - std::pow(1 - step_rate_, 2 * (updates_ + 1))) <
        (1.4 + 2 / (n + 1)) * usual_length_;
    path_ *= 1 - path_rate_;
    if (is_usual) path_ += std::sqrt(path_rate_ * (2 - path_rate_) * mu) * step;
    const double lost = is_usual ? 0 : path_rate_ * (2 - path_rate_);

    const MatrixXd white = whitening * steps;
    const double sum = std::accumulate(weights_.begin(), weights_.end(), 0.0);
    covariance_ *= 1 + rank_one_rate_ * (lost - 1) - rank_mu_rate_ * sum;
    covariance_ += rank_one_rate_ * path_ * path_.transpose();
    for (std::size_t i = 0; i < weights_.size(); ++i) {
        const auto one = steps.col(index(i));
        constexpr double tiny = 1e-8;
        const double scale =
            weights_[i] >= 0 ? 1
                             : n / (white.col(index(i)).squaredNorm() + tiny);
        covariance_ +=
            rank_mu_rate_ * weights_[i] * scale * one * one.transpose();
    }
    if (adapts_learning_rates_) damp(before);
    decompose();
}

void Cma::damp(const Before& before) {
    const auto n = static_cast<double>(mean_.size());
    const VectorXd moved = mean_ - before.mean;
    const MatrixXd old =
        before.step_size * before.step_size * before.covariance;
    const MatrixXd changed = step_size_ * step_size_ * covariance_ - old;
    const MatrixXd whitening = before.whitening / before.step_size;
    const double rate_before = mean_learning_.rate;
    mean_learning_.adapt(whitening * moved);
    covariance_learning_.adapt(whitening * changed * whitening / std::sqrt(2));
    mean_ = before.mean + mean_learning_.rate * moved;
    const MatrixXd full = old + covariance_learning_.rate * changed;
    const VectorXd eigenvalues =
        Eigen::SelfAdjointEigenSolver<MatrixXd>(full, Eigen::EigenvaluesOnly)
            .eigenvalues();
    step_size_ = std::exp(eigenvalues.array().log().sum() / 2 / n);
    covariance_ = full / (step_size_ * step_size_);
    step_size_ *= rate_before / mean_learning_.rate;
}

void Cma::LearningRate::adapt(const MatrixXd& change) {
    constexpr double wanted = 1.4, damping = 0.1;
    mean_change = (1 - smoothing) * mean_change + smoothing * change;
    mean_square =
        (1 - smoothing) * mean_square + smoothing * change.squaredNorm();
    const double square_mean = mean_change.squaredNorm();
    const double signal =
        (square_mean - smoothing / (2 - smoothing) * mean_square) /
        (mean_square - square_mean);
    const double excess = std::clamp(signal / wanted / rate - 1, -1.0, 1.0);
    rate = std::min(
        1.0, rate * std::exp(std::min(damping * rate, smoothing) * excess));
}

void Cma::decompose() {
    covariance_ = ((covariance_ + covariance_.transpose()) / 2).eval();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(covariance_);
    // Rounding may leave an axis without extent.
    constexpr double least = 1e-16;
    axes_ = solver.eigenvectors();
    deviations_ = solver.eigenvalues().cwiseMax(least).cwiseSqrt();
}

double Cma::condition() const {
    const double ratio = deviations_.maxCoeff() / deviations_.minCoeff();
    return ratio * ratio;
}

}  // namespace ideotype
