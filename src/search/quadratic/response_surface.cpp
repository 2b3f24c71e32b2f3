// SPDX-License-Identifier: Apache-2.0
#include "response_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

//! Rows of all generations. The terms u_i and u_i^2 / 2 and the values are
//! centred within generations and multiplied by the root of the weight.
struct CentredRows {
    MatrixXd terms;  //!< [rows, 2 n]
    VectorXd values;
    double degrees_of_freedom = 0;
};

CentredRows centre(const std::vector<SurfaceRows>& generations) {
    Index count = 0;
    for (const SurfaceRows& rows : generations) count += rows.values.size();
    const Index n = generations.front().points.rows();
    CentredRows centred{MatrixXd(count, 2 * n), VectorXd(count)};
    Index first = 0;
    for (const SurfaceRows& rows : generations) {
        const Index size = rows.values.size();
        IDEOTYPE_EXPECT(size >= 2 && rows.points.cols() == size);
        IDEOTYPE_EXPECT(rows.points.rows() == n && rows.weight > 0);
        MatrixXd terms(size, 2 * n);
        terms << rows.points.transpose(),
            rows.points.transpose().cwiseAbs2() / 2;
        const double root = std::sqrt(rows.weight);
        centred.terms.middleRows(first, size) =
            root * (terms.rowwise() - terms.colwise().mean());
        centred.values.segment(first, size) =
            root * (rows.values.array() - rows.values.mean());
        centred.degrees_of_freedom += static_cast<double>(size - 1);
        first += size;
    }
    return centred;
}

//! Returns the coefficients of terms. With A the terms, y the values, s^2 the
//! noise variance and s^2 / l the variance of coefficients, the marginal
//! likelihood of the ridge l is, apart from a constant,
//!
//!     -(d log s^2 + sum_j log((a_j + l) / l)) / 2,
//!     s^2 = (y'y - sum_j q_j^2 / (a_j + l)) / d,
//!
//! where A'A = V diag(a) V', q = V'A'y, and d is the number of rows less the
//! number of generations.
VectorXd regress(const CentredRows& rows) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(
        rows.terms.transpose() * rows.terms);
    const VectorXd a = solver.eigenvalues().cwiseMax(0);
    const VectorXd q = solver.eigenvectors().transpose() *
                       (rows.terms.transpose() * rows.values);
    const double squares = rows.values.squaredNorm();
    const double typical = a.mean();
    if (!(squares > 0) || !(typical > 0)) return VectorXd::Zero(a.size());
    // The ridge is one of a geometric series, relative to the mean of a.
    constexpr double weakest = 1e-6, strongest = 1e4, factor = 2;
    double highest = -std::numeric_limits<double>::infinity(), ridge = typical;
    for (double l = weakest * typical; l < strongest * typical; l *= factor) {
        // Rounding may make the residual of exact data negative.
        const double residual =
            std::max(squares - (q.array().square() / (a.array() + l)).sum(),
                     1e-14 * squares);
        const double likelihood =
            -rows.degrees_of_freedom * std::log(residual) -
            (1 + a.array() / l).log().sum();
        if (likelihood > highest) {
            highest = likelihood;
            ridge = l;
        }
    }
    return solver.eigenvectors() * (q.array() / (a.array() + ridge)).matrix();
}

}  // namespace

double ResponseSurface::at(const VectorXd& u) const {
    return slopes.dot(u) + curvatures.dot(u.cwiseAbs2()) / 2;
}

VectorXd ResponseSurface::maximise(double radius) const {
    IDEOTYPE_EXPECT(radius > 0);
    if (!(slopes.norm() > 0)) return VectorXd::Zero(slopes.size());
    // At a maximum (l - h_i) u_i = g_i, with l > 0 only at the distance radius.
    const auto step = [&](double l) -> VectorXd {
        return slopes.cwiseQuotient((l - curvatures.array()).matrix());
    };
    const double largest = curvatures.maxCoeff();
    if (largest < 0 && step(0).norm() <= radius) return step(0);
    // The distance falls with l. Bisect between bounds of l.
    double low = std::max(0.0, largest), high = low + slopes.norm() / radius;
    constexpr double tolerance = 1e-9;
    while (high - low > tolerance * high) {
        const double middle = (low + high) / 2;
        (step(middle).norm() > radius ? low : high) = middle;
    }
    return step(high);
}

ResponseSurface fit_surface(const std::vector<SurfaceRows>& generations) {
    IDEOTYPE_EXPECT(!generations.empty());
    const VectorXd coefficients = regress(centre(generations));
    const Index n = coefficients.size() / 2;
    return {coefficients.head(n), coefficients.tail(n)};
}

}  // namespace ideotype
