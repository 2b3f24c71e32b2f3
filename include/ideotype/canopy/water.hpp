// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "ideotype/canopy/assimilation.hpp"

namespace ideotype {

//! Fluxes between leaves and the air, and states of leaves. Each is summed over
//! leaf area per ground area.
enum class LeafFlux : std::size_t {
    //! Net assimilation plus the respiration that leaves would have at air
    //! temperature [umol m-2 s-1].
    uptake,
    transpiration,  //!< transpiration [mmol m-2 s-1]
    sensible,       //!< sensible heat [W m-2]
    warming,        //!< leaf minus air temperature [K m2 m-2]
    conductance,    //!< stomatal conductance for vapour [mol m-2 s-1]
    hot,            //!< leaf area above LeafWater::hot [m2 m-2]
    //! Respiration of leaves in light minus that of leaves at air temperature
    //! [umol m-2 s-1].
    respiration,
};

inline constexpr std::size_t leaf_fluxes = 7;

//! Returns the factor that converts a flux in a step to an amount: of
//! assimilated carbon [mol], water [mm], heat [MJ] or hot leaf area [h]; for
//! other fluxes, the time [s].
double amount_of(LeafFlux flux, const TimeStep& step);

//! Tallies indexed [flux][randomisation].
using FluxTallies = std::vector<std::vector<FluxTally>>;

//! The exchange of heat and water between the leaves of a canopy and the air on
//! a mean day.
struct WaterReport {
    //! Transpiration [mm day-1], hourly [mmol m-2 s-1].
    FluxReport transpiration;
    FluxReport sensible;  //!< sensible heat [MJ m-2 day-1], hourly [W m-2]
    //! Leaf temperature minus the temperature of the air above the canopy,
    //! during the time with light [K].
    FluxReport warming;
    //! Stomatal conductance of the canopy during the time with light [mol m-2
    //! s-1].
    FluxReport conductance;
    FluxReport hot;                 //!< time with hot leaves [h day-1]
    std::vector<double> leaf_area;  //!< leaf area index by layer [m2 m-2]
};

//! Reports the fluxes of a canopy.
//! @param leaf_area leaf area index of assimilating leaves by layer [m2 m-2]
WaterReport report(FluxTallies tallies, std::vector<double> leaf_area,
                   const LightSeries& series);

}  // namespace ideotype
