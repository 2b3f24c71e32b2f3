// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

namespace ideotype {

//! Where the scatter of the leaves' light comes from: how much of beams and of
//! skies meets leaves, and what becomes of what surfaces scatter.
enum LightOrigin : std::size_t { beams, skies, scattered };

inline constexpr std::size_t origins = 3;

template <class Number>
using ByOrigin = std::array<Number, origins>;

//! How finely each origin is looked at in one randomisation: first hits, and of
//! scattered light the energy of all sources over that of a path.
using Amounts = ByOrigin<double>;

//! All of them times a factor.
Amounts scaled(Amounts amounts, double factor);

//! How a variance falls with the amount.
struct Law {
    double amount = 1;
    double variance = 0;  //!< of one randomisation with this amount
    double power = 1;

    //! The variance with another amount.
    double at(double other) const;
};

//! The amounts with which all variances sum to a value at the least cost: where
//! one more unit of cost takes as much off the variance everywhere (Neyman
//! 1934, doi:10.2307/2342192, for a power of 1). Nothing where there is no
//! variance.
Amounts allocate(const ByOrigin<Law>& laws, const ByOrigin<double>& costs,
                 double variance);

}  // namespace ideotype
