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

//! Returns whether the change of a flux under stress is a factor. Other fluxes
//! change by a difference per ground area.
inline bool changes_by_factor(LeafFlux flux) {
    return flux == LeafFlux::uptake || flux == LeafFlux::transpiration ||
           flux == LeafFlux::conductance;
}

//! The fluxes of leaves under stress, with stomata at one of
//! LeafWater::openings, compared with those of open stomata [flux][step]. They
//! are those of strata of similar light, in the air of a canopy with such
//! stomata.
using ClosedStomata = std::vector<std::vector<double>>;

//! The fluxes of a field or a canopy.
struct CanopyFluxes {
    FluxTallies tallies;
    std::vector<ClosedStomata> closed{};  //!< by LeafWater::openings
};

//! How far stomata close in a step: at 0 they are open, at i as at the i-th
//! opening of LeafWater::openings, and at the largest, one more than there are
//! openings, they are closed: leaves do not transpire, and LeafFlux::uptake is
//! 0, so that their respiration is lost (a convention). Between these, fluxes
//! are linear.
using Closure = double;

//! Returns the change of a flux in a step, see changes_by_factor().
double change_of(const std::vector<ClosedStomata>& closed, LeafFlux flux,
                 std::size_t step, Closure closure);

//! Leaf area in any unit: by group, by layer, and by row and group.
struct CanopyLeafArea {
    const std::vector<double>&groups, &layers, &rows;
};

//! Changes the fluxes of a canopy to those of stomata that close. Groups,
//! layers and rows all change by the same factor, or by the same difference per
//! leaf area.
//! @param closures by step, for all randomisations
void close_stomata(const std::vector<Closure>& closures,
                   const std::vector<LeafGroup>& leaves,
                   const CanopyLeafArea& area, const LightSeries& series,
                   CanopyFluxes& fluxes);

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
