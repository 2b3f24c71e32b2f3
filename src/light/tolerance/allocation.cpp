// SPDX-License-Identifier: Apache-2.0
#include "allocation.hpp"

#include <cmath>

#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

//! Returns the amounts at which one more unit of cost reduces the variance by
//! r. With the law V = v (t / a)^q and the cost c per unit of a,
//!
//!     -dV/da = q v t^q / a^(q + 1) = r c,  so that
//!     a = t (q v / (t r c))^(1 / (q + 1)).
Amounts amounts_at(double rate, const ByOrigin<Law>& laws,
                   const ByOrigin<double>& costs) {
    Amounts amounts{};
    for (std::size_t o = 0; o < origins; ++o) {
        const Law& law = laws[o];
        if (law.variance > 0 && costs[o] > 0)
            amounts[o] =
                law.amount * std::pow(law.power * law.variance /
                                          (law.amount * rate * costs[o]),
                                      1 / (law.power + 1));
    }
    return amounts;
}

double variance_of(const Amounts& amounts, const ByOrigin<Law>& laws) {
    double sum = 0;
    for (std::size_t o = 0; o < origins; ++o)
        if (amounts[o] > 0) sum += laws[o].at(amounts[o]);
    return sum;
}

}  // namespace

Amounts scaled(Amounts amounts, double factor) {
    for (double& amount : amounts) amount *= factor;
    return amounts;
}

double Law::at(double other) const {
    IDEOTYPE_EXPECT(amount > 0 && other > 0);
    return variance * std::pow(amount / other, power);
}

Amounts allocate(const ByOrigin<Law>& laws, const ByOrigin<double>& costs,
                 double variance) {
    IDEOTYPE_EXPECT(variance > 0);
    // The variance increases with the rate.
    double lower = 1e-60, upper = 1e60;
    for (int i = 0; i < 60; ++i) {
        const double rate = std::sqrt(lower) * std::sqrt(upper);
        const bool is_enough =
            variance_of(amounts_at(rate, laws, costs), laws) <= variance;
        (is_enough ? lower : upper) = rate;
    }
    return amounts_at(lower, laws, costs);
}

}  // namespace ideotype
