// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "ideotype/physiology/energy_balance.hpp"

namespace ideotype {

//! The exchange between a point on a leaf and the air, per leaf area. The
//! derivatives are with respect to absorbed PPFD, at constant leaf temperature
//! and constant CO2 inside the leaf.
struct LeafExchange {
    Expansion net{};            //!< net assimilation [umol m-2 s-1]
    Expansion transpiration{};  //!< [mmol m-2 s-1]; negative: dew
    double conductance = 0;  //!< stomatal conductance for vapour [mol m-2 s-1]
    double temperature = 0;  //!< temperature of the leaf [deg C]
    double sensible = 0;     //!< sensible heat [W m-2]
    double warmer = 0;       //!< leaf minus air temperature [K]
};

//! A point on a leaf, for leaf_exchange().
struct ThermalPoint {
    const ThermalLeaf* leaf = nullptr;
    LeafSurroundings around{};
    //! Solution for a point in similar light and air, which is the starting
    //! point to save sweeps; null: none.
    const LeafExchange* like = nullptr;
};

//! Approximates energy_balance() at many points, to about 0.01 deg C and at a
//! fraction of its cost. Temperature, stomata and assimilation start from their
//! values at air temperature and are updated in turn, in sweeps, until they
//! converge. Below the temperature at which enzymes fail there is only one
//! balance, since a warmer leaf emits more, heats the air more and evaporates
//! more. In three cases energy_balance() is called instead: leaves are warmer
//! than that, the humidity is too low for a unique conductance in the
//! Ball-Berry model, or sweeps do not converge.
//!
//! Several points are updated at the same time, as lanes of vectors. The result
//! of a point does not depend on the others.
//! @param results one element for each point; elements to which `like` points
//! may be among them
void leaf_exchange(std::span<const ThermalPoint> points, LeafExchange* results);

//! Returns the exchange of a leaf at air temperature without a boundary layer.
//! @param net net assimilation from any model [umol m-2 s-1]
LeafExchange exchange_at_air_temperature(const Stomata& stomata,
                                         const LeafSurroundings& around,
                                         const Expansion& net);

}  // namespace ideotype
