// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "ideotype/canopy/assimilation.hpp"

namespace ideotype {

//! Fluxes between leaves and the air, and the state of leaves, each a sum over
//! leaf area per ground area.
enum class LeafFlux : std::size_t {
    gross,          //!< assimilation [umol m-2 s-1]
    transpiration,  //!< [mmol m-2 s-1]
    sensible,       //!< heat [W m-2]
    warming,        //!< of leaves over the air above the canopy [K m2 m-2]
    conductance,    //!< of stomata for vapour [mol m-2 s-1]
    hot,            //!< leaf area that is warmer than LeafWater::hot [m2 m-2]
};

inline constexpr std::size_t leaf_fluxes = 6;

//! Returns the amount of a step over its flux: assimilation [mol], water [mm],
//! heat [MJ], time that is hot [h], and for others time [s].
double amount_of(LeafFlux flux, const TimeStep& step);

//! Tallies of each flux, by randomisation.
using FluxTallies = std::vector<std::vector<FluxTally>>;

//! The exchange of heat and water of the leaves of a canopy on a mean day.
struct WaterReport {
    FluxReport transpiration;  //!< [mm day-1], of hours [mmol m-2 s-1]
    FluxReport sensible;       //!< heat [MJ m-2 day-1], of hours [W m-2]
    //! Temperature of leaves over that of the air above the canopy, in the time
    //! with light [K].
    FluxReport warming;
    //! Conductance of stomata of the canopy [mol m-2 s-1], in that time.
    FluxReport conductance;
    FluxReport hot;                 //!< time that leaves are too warm [h day-1]
    std::vector<double> leaf_area;  //!< index, by layer [m2 m-2]
};

//! Reports the fluxes of a canopy.
//! @param leaf_area index by layer, of leaves that assimilate [m2 m-2]
WaterReport report(FluxTallies tallies, std::vector<double> leaf_area,
                   const LightSeries& series);

}  // namespace ideotype
