// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "ideotype/core/enum_names.hpp"

namespace ideotype {

//! How the number of kernels follows from growth around silking.
//!
//! andrade: with g the growth of a plant in the 30 days around silking [g
//! plant-1 d-1], N f, f = (g - 1.17) / (1 + 0.67 (g - 1.17)), and 0 below 1.17
//! (Andrade and others 2002, doi:10.2135/cropsci2002.1173; several hybrids in
//! Argentina, n = 34, 0 to 13 g d-1). f is 1 at 4.2 g d-1; N is the number
//! there.
//!
//! ceres: with g the mean growth from silking to 170 deg C d later, the smaller
//! of N and N 680 g / 7200 + 50 (CERES-Maize in DSSAT, Jones and Kiniry 1986,
//! ISBN 0890962693).
enum class KernelRule { andrade, ceres };
template <>
inline constexpr std::array enum_names<KernelRule>{
    EnumName{"andrade", KernelRule::andrade},
    EnumName{"ceres", KernelRule::ceres}};

//! The kernels of a crop and the filling of grain.
struct Grain {
    KernelRule rule = KernelRule::andrade;
    //! N of KernelRule, kernels per plant. The default is the middle of the
    //! hybrids of Andrade and others, 385 to 600.
    double kernels = 490;
    //! Growth of a kernel at the best temperature [mg d-1]; G3 of CERES, 8.5 of
    //! a hybrid of medium season.
    double rate = 8.5;
    //! Reserves of the stem at silking, as a fraction of its mass (CERES).
    double reserves = 0.15;

    bool operator==(const Grain&) const = default;
};

//! Thermal time from silking to the beginning of filling [deg C d], and the
//! fraction of the time from silking to maturity at which it ends (CERES).
inline constexpr double filling_begins = 170, filling_ends = 0.95;

//! Days before and after silking whose growth sets kernels by
//! KernelRule::andrade.
inline constexpr int days_around_silking = 15;

//! Returns the number of kernels per plant.
//! @param growth growth of a plant in the period of the rule [g d-1]
double kernels_per_plant(const Grain& grain, double growth);

//! Returns the rate of filling at a temperature [deg C] relative to the best: 0
//! below 5.5 and above 35, 1 from 16 to 27, linear in between (CERES).
double filling_rate(double temperature);

//! The dry matter of ears and of reserves [g m-2].
struct Filling {
    double grain = 0, reserves = 0;
    double surplus = 0;  //!< dry matter that neither takes up
};

//! Fills grain for a day. Kernels grow at their rate as far as the growth of
//! the crop less the maintenance of ears, and reserves, allow. Half of the
//! growth that kernels do not take enters reserves; the other half goes to
//! roots (CERES). Neither limits assimilation.
//! @param sink growth that kernels can take [g m-2]
//! @param growth growth of the crop less the maintenance of ears [g m-2]
void fill(double sink, double growth, Filling& filling);

//! Water in grain that is traded, by fresh mass.
inline constexpr double market_moisture = 0.155;

}  // namespace ideotype
