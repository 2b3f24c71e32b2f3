// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace ideotype {

//! A density on [0, 1] that is smooth within each of several equal panels. In
//! each panel a polynomial through Gauss-Legendre nodes approximates the
//! density; its known integral is inverted to rounding.
template <std::size_t panels>
class PiecewiseDensity {
  public:
    template <class Density>
    explicit PiecewiseDensity(const Density& density) {
        double sum = 0;
        for (std::size_t p = 0; p < panels; ++p) {
            for (std::size_t j = 0; j < order; ++j) {
                values_[p][j] = density(place(p, nodes[j]));
                sum += weights[j] * values_[p][j] / (2 * panels);
            }
            integrals_[p] = sum;
        }
    }

    //! Returns the integral over [0, 1].
    double total() const { return integrals_.back(); }

    //! Returns the place where the integral from 0 reaches a share of the
    //! total.
    double quantile(double share) const {
        const double target = share * total();
        const auto found =
            std::lower_bound(integrals_.begin(), integrals_.end() - 1, target);
        const auto p = static_cast<std::size_t>(found - integrals_.begin());
        const double before = p == 0 ? 0 : integrals_[p - 1];
        return place(p, solve(values_[p], (target - before) * 2 * panels));
    }

  private:
    static constexpr std::size_t order = 6;
    using Values = std::array<double, order>;
    static constexpr Values nodes{-0.932469514203152028, -0.661209386466264514,
                                  -0.238619186083196909, 0.238619186083196909,
                                  0.661209386466264514,  0.932469514203152028};
    static constexpr Values weights{0.171324492379170345, 0.360761573048138608,
                                    0.467913934572691047, 0.467913934572691047,
                                    0.360761573048138608, 0.171324492379170345};

    //! Returns the point of a panel at x in [-1, 1].
    static double place(std::size_t panel, double x) {
        return (static_cast<double>(panel) + (1 + x) / 2) / panels;
    }

    //! Returns the Legendre polynomials of degrees 0 to order.
    static std::array<double, order + 1> legendre(double x) {
        std::array<double, order + 1> p{1, x};
        for (std::size_t k = 1; k < order; ++k) {
            const auto n = static_cast<double>(k);
            p[k + 1] = ((2 * n + 1) * x * p[k] - n * p[k - 1]) / (n + 1);
        }
        return p;
    }

    //! Returns the point of [-1, 1] where the integral from -1 reaches an
    //! amount, by Newton's method, or by bisection where Newton's step leaves
    //! the bracket.
    static double solve(const Values& values, double amount) {
        // Scaled coefficients: coefficient k of the density over (2 k + 1).
        Values c{};
        for (std::size_t j = 0; j < order; ++j) {
            const auto p = legendre(nodes[j]);
            for (std::size_t k = 0; k < order; ++k)
                c[k] += weights[j] * values[j] * p[k] / 2;
        }
        double low = -1, high = 1;
        // Only shares of 0 and 1 reach a panel whose integral is zero.
        if (!(c[0] > 0)) return low;
        double x = std::clamp(amount / c[0] - 1, low, high);
        for (int i = 0; i < 60; ++i) {
            const auto p = legendre(x);
            double density = c[0];
            double integral = c[0] * (x + 1);
            for (std::size_t k = 1; k < order; ++k) {
                density += static_cast<double>(2 * k + 1) * c[k] * p[k];
                integral += c[k] * (p[k + 1] - p[k - 1]);
            }
            (integral < amount ? low : high) = x;
            double next = x - (integral - amount) / density;
            if (!(next >= low && next <= high)) next = (low + high) / 2;
            const double step = std::abs(next - x);
            x = next;
            if (step < 1e-15) break;
        }
        return x;
    }

    std::array<Values, panels> values_{};
    std::array<double, panels> integrals_{};
};

}  // namespace ideotype
