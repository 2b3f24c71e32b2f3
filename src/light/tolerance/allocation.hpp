// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

namespace ideotype {

//! The origins of the variance of light on leaves: beams and skies that meet
//! leaves, and light scattered by surfaces.
enum LightOrigin : std::size_t { beams, skies, scattered };

inline constexpr std::size_t origins = 3;

template <class Number>
using ByOrigin = std::array<Number, origins>;

//! The amounts of work for each origin in one randomisation: the number of
//! first hits or, for scattered light, the energy of all sources divided by
//! that of a path.
using Amounts = ByOrigin<double>;

Amounts scaled(Amounts amounts, double factor);

//! The law by which a variance decreases with the amount of work.
struct Law {
    double amount = 1;
    double variance = 0;  //!< variance of one randomisation with `amount`
    double power = 1;

    //! Returns the variance for another amount.
    double at(double other) const;
};

//! Returns the cheapest amounts for which the variances sum to a given value.
//! At the optimum, one more unit of cost reduces the variance equally for each
//! origin (Neyman 1934, doi:10.2307/2342192, for a power of 1). Origins without
//! variance get no work.
Amounts allocate(const ByOrigin<Law>& laws, const ByOrigin<double>& costs,
                 double variance);

}  // namespace ideotype
