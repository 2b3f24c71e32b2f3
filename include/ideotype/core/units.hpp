// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

namespace ideotype {

inline constexpr double degree =
    std::numbers::pi / 180.0;  //!< one degree [rad]

inline constexpr double joule_per_megajoule = 1e6;

//! Photons per energy of sunlight in the PAR band [mol MJ-1] (McCree 1972,
//! doi:10.1016/0002-1571(72)90045-3).
inline constexpr double mol_per_mj_par = 4.57;

}  // namespace ideotype
