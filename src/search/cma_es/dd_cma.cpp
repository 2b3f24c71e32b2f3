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

// Equations of Akimoto and Hansen (2019), doi:10.1162/evco_a_00260, for n
// coordinates and a population of l points x_1 (best) to x_l (worst). The
// distribution is N(m, s^2 D C D), with D diagonal and C a correlation matrix.
//
// Weights, from w'_i = ln((l + 1) / 2) - ln i: positive ones sum to 1, and the
// number of equal weights with the same variance is
//
//     mu = (sum w'_i)^2 / sum w'_i^2, over w'_i > 0.                        (1)
//
// Rates of a matrix with k degrees of freedom, n (n + 1) / 2 of C and n of D:
//
//     c_1  = 1 / (2 (k / n + 1) (n + 1)^(3/4) + mu / 2),                    (2)
//     c_mu = min(1 - c_1, c_1 (mu + 1 / mu - 2 + l / (2 (l + 5)))),         (3)
//     c_c  = min(1, sqrt(mu c_1) / 2);                                      (4)
//
// negative weights sum to the smaller of 1 + c_1 / c_mu and
// 1 + 2 mu_- / (mu + 2), where mu_- is (1) over w'_i < 0.                   (5)
//
// An update whitens points, z_i = C^(-1/2) D^-1 (x_i - m) / s, and moves the
// mean by s D C^(1/2) z, z = sum w_i z_i over positive weights.             (6)
// Cumulation of z changes the step size:
//
//     p_s <- (1 - c_s) p_s + sqrt(c_s (2 - c_s) mu) z,                      (7)
//     c_s = (mu + 2) / (n + mu + 5),
//     d_s = 1 + 2 max(0, sqrt((mu - 1) / (n + 1)) - 1) + c_s,
//     s <- s exp(c_s / d_s (|p_s| / E|N(0, I)| - sqrt(g_s))),               (8)
//
// with g <- (1 - c)^2 g + c (2 - c), the variance that a path has reached.
// A path that is too long, |p_s|^2 >= (2 + 4 / (n + 1)) n g_s, does not enter
// the paths p_c of C and D.                                                 (9)
// With u = C^(-1/2) D^-1 p_c, and negative weights times n / |z_i|^2,      (10)
//
//     Z = c_mu (sum w_i z_i z_i' - sum w_i I) + c_1 (u u' - g_c I),        (11)
//     C <- C^(1/2) (I + Z) C^(1/2),                                        (12)
//     D <- D exp(diag of (11) with the rates of D, over 2 b),              (13)
//     b = 1 + max(0, sqrt(cond C) - 2).                                    (14)

//! Returns the effective number of the weights of one sign, equation (1).
double count_effective(const std::vector<double>& weights, double sign) {
    double sum = 0, squares = 0;
    for (const double w : weights)
        if (w * sign > 0) {
            sum += w;
            squares += w * w;
        }
    return sum * sum / squares;
}

}  // namespace

// The weights w' before normalisation.
std::vector<double> make_raw_weights(std::size_t population) {
    std::vector<double> weights(population);
    for (std::size_t i = 0; i < population; ++i)
        weights[i] = std::log((static_cast<double>(population) + 1) / 2) -
                     std::log(static_cast<double>(i + 1));
    return weights;
}

DdCma::Rates DdCma::compute_rates(double n, double degrees_of_freedom,
                                  const std::vector<double>& raw_weights) {
    const double mu = count_effective(raw_weights, 1);
    const auto population = static_cast<double>(raw_weights.size());
    // Equations (2) to (4).
    Rates rates;
    rates.rank_one =
        1 / (2 * (degrees_of_freedom / n + 1) * std::pow(n + 1, .75) + mu / 2);
    rates.rank_mu =
        std::min(1 - rates.rank_one,
                 (mu + 1 / mu - 2 + population / (2 * (population + 5))) *
                     rates.rank_one);
    rates.path = std::min(1.0, std::sqrt(mu * rates.rank_one) / 2);
    // Equation (5).
    double positive = 0, negative = 0;
    for (const double w : raw_weights) (w > 0 ? positive : negative) += w;
    const double most_negative =
        std::min(1 + rates.rank_one / rates.rank_mu,
                 1 + 2 * count_effective(raw_weights, -1) / (mu + 2));
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
    step_path_.steps = correlation_path_.steps = scale_path_.steps =
        VectorXd::Zero(mean_.size());
    correlation_ = root_ = inverse_root_ =
        MatrixXd::Identity(mean_.size(), mean_.size());
}

void DdCma::set_population(std::size_t population) {
    IDEOTYPE_EXPECT(population >= 4);
    const auto n = static_cast<double>(mean_.size());
    const std::vector<double> weights = make_raw_weights(population);
    effective_parents_ = count_effective(weights, 1);
    parents_ = population / 2;
    correlation_rates_ = compute_rates(n, n * (n + 1) / 2, weights);
    scale_rates_ = compute_rates(n, n, weights);
    const double mu = effective_parents_;
    step_rate_ = (mu + 2) / (n + mu + 5);
    step_damping_ =
        1 + 2 * std::max(0.0, std::sqrt((mu - 1) / (n + 1)) - 1) + step_rate_;
}

VectorXd DdCma::sample(const VectorXd& normal) const {
    IDEOTYPE_EXPECT(normal.size() == mean_.size());
    return mean_ + step_size_ * scales_.cwiseProduct(root_ * normal);
}

void DdCma::set_marginal(std::size_t coordinate, double mean,
                         double deviation) {
    IDEOTYPE_EXPECT(std::isfinite(mean) && deviation > 0);
    const auto i = static_cast<Eigen::Index>(coordinate);
    // The paths are in units of the scales.
    const double change = deviation / (step_size_ * scales_[i]);
    correlation_path_.steps[i] *= change;
    scale_path_.steps[i] *= change;
    scales_[i] *= change;
    mean_[i] = mean;
}

void DdCma::update(const MatrixXd& ranked) {
    IDEOTYPE_EXPECT(ranked.rows() == mean_.size());
    IDEOTYPE_EXPECT(ranked.cols() == correlation_rates_.weights.size());
    IDEOTYPE_EXPECT(ranked.allFinite());
    const auto n = static_cast<double>(mean_.size());
    // Equation (6). Without selection, the columns would be standard normal.
    const MatrixXd white = inverse_root_ *
                           (scales_ * step_size_).cwiseInverse().asDiagonal() *
                           (ranked.colwise() - mean_);
    const auto parents = static_cast<Eigen::Index>(parents_);
    const VectorXd step =
        white.leftCols(parents) * correlation_rates_.weights.head(parents);
    const VectorXd moved = scales_.cwiseProduct(root_ * step);
    mean_ += step_size_ * moved;

    // Equations (7) and (9).
    step_path_.add(step, step_rate_, effective_parents_, true);
    const double length = step_path_.steps.norm();
    const bool is_usual =
        length * length < (2 + 4 / (n + 1)) * n * step_path_.share;

    // Equation (10): vectors with negative weights are scaled to their expected
    // length.
    const auto scale_negative = [&](const VectorXd& weights) {
        VectorXd scaled = weights;
        for (Eigen::Index i = 0; i < weights.size(); ++i)
            if (weights[i] < 0)
                scaled[i] *= n / std::max(white.col(i).squaredNorm(), 1e-8);
        return scaled;
    };
    const auto whiten = [&](const Path& path) -> VectorXd {
        return inverse_root_ * path.steps.cwiseQuotient(scales_);
    };

    // Equation (11) for C.
    correlation_path_.add(moved, correlation_rates_.path, effective_parents_,
                          is_usual);
    const VectorXd along = whiten(correlation_path_);
    const VectorXd weights = scale_negative(correlation_rates_.weights);
    MatrixXd change = correlation_rates_.rank_mu *
                          (white * weights.asDiagonal() * white.transpose()) +
                      correlation_rates_.rank_one * (along * along.transpose());
    change.diagonal().array() -=
        correlation_rates_.rank_mu * correlation_rates_.weights.sum() +
        correlation_rates_.rank_one * correlation_path_.share;
    // Bounding the smallest eigenvalue keeps the correlation matrix positive
    // definite.
    constexpr double limit = 0.75;
    const double smallest =
        Eigen::SelfAdjointEigenSolver<MatrixXd>(change, Eigen::EigenvaluesOnly)
            .eigenvalues()
            .minCoeff();
    if (smallest < -limit) change *= limit / -smallest;

    // Diagonal of (11) for D.
    scale_path_.add(moved, scale_rates_.path, effective_parents_, is_usual);
    const VectorXd path_squares = whiten(scale_path_).cwiseAbs2();
    const VectorXd squares =
        white.cwiseAbs2() * scale_negative(scale_rates_.weights);
    const VectorXd growth =
        scale_rates_.rank_mu *
            (squares.array() - scale_rates_.weights.sum()).matrix() +
        scale_rates_.rank_one *
            (path_squares.array() - scale_path_.share).matrix();
    // Equation (14): D changes more slowly if C is far from a sphere.
    const double damping =
        1 + std::max(0.0, std::sqrt(correlation_condition_) - 2);

    // Equations (12), (13) and (8).
    correlation_ += root_ * change * root_;
    scales_.array() *= (growth.array() / (2 * damping)).exp();
    step_size_ *=
        std::exp(step_rate_ / step_damping_ *
                 (length / usual_length_ - std::sqrt(step_path_.share)));
    decompose();
}

//! Makes the diagonal of C equal to 1 by moving its variances into the scales
//! D, and computes the square roots of C.
void DdCma::decompose() {
    const VectorXd deviations = correlation_.diagonal().cwiseSqrt();
    scales_.array() *= deviations.array();
    const VectorXd inverse = deviations.cwiseInverse();
    correlation_ = (inverse.asDiagonal() *
                    ((correlation_ + correlation_.transpose()) / 2).eval() *
                    inverse.asDiagonal())
                       .eval();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(correlation_);
    // Rounding may reduce the length of an axis to zero.
    constexpr double smallest = 1e-14;
    const VectorXd values = solver.eigenvalues().cwiseMax(smallest);
    const MatrixXd& axes = solver.eigenvectors();
    root_ = axes * values.cwiseSqrt().asDiagonal() * axes.transpose();
    inverse_root_ = axes * values.cwiseSqrt().cwiseInverse().asDiagonal() *
                    axes.transpose();
    IDEOTYPE_ENSURE((correlation_.diagonal().array() - 1).abs().maxCoeff() <
                    1e-9);
    correlation_condition_ = values.maxCoeff() / values.minCoeff();
}

}  // namespace ideotype
