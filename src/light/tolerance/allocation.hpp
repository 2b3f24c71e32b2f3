// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

namespace ideotype {

//! The origins of the scatter of the leaves' light: beams and skies that meet
//! leaves, and light that surfaces scatter.
enum LightOrigin : std::size_t { beams, skies, scattered };

inline constexpr std::size_t origins = 3;

template <class Number>
using ByOrigin = std::array<Number, origins>;

//! The amounts of work for each origin in one randomisation: first hits, and
//! for scattered light the energy of all sources over that of a path.
using Amounts = ByOrigin<double>;

//! Returns all amounts times a factor.
Amounts scaled(Amounts amounts, double factor);

//! The law by which a variance falls with the amount of work.
struct Law {
    double amount = 1;
    double variance = 0;  //!< variance of one randomisation with `amount`
    double power = 1;

    //! Returns the variance with another amount.
    double at(double other) const;
};

//! Returns the amounts with which all variances sum to a value at the least
//! cost, where one more unit of cost reduces the variance equally everywhere
//! (Neyman 1934, doi:10.2307/2342192, for a power of 1). An origin without
//! variance gets nothing.
Amounts allocate(const ByOrigin<Law>& laws, const ByOrigin<double>& costs,
                 double variance);

}  // namespace ideotype
