// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/physiology/energy_balance.hpp"

namespace ideotype {

//! The exchange of a point of a leaf with the air, per area of leaf. The
//! derivatives are those in absorbed PPFD at the temperature and the CO2 within
//! the leaf that it has.
struct LeafExchange {
    Expansion net;            //!< assimilation [umol m-2 s-1]
    Expansion transpiration;  //!< [mmol m-2 s-1]; negative if dew falls
    double conductance = 0;   //!< of the stomata for vapour [mol m-2 s-1]
    double temperature = 0;   //!< temperature of the leaf [deg C]
    double sensible = 0;      //!< heat [W m-2]
    double warmer = 0;        //!< than the air [K]
};

//! energy_balance() to some 0.01 deg C at a fraction of its cost, for the many
//! points of a canopy. Temperature, stomata and assimilation are found together
//! from those of the air, in sweeps that end when nothing moves any more. Below
//! the temperature at which enzymes fail there is one balance, since a warmer
//! leaf emits more, heats the air more and evaporates more. Where leaves are
//! warmer, where the humidity is too low for stomata of Ball and Berry to have
//! one conductance, and where sweeps do not end, it is energy_balance() itself.
//! @param like a point in about the same light and air, to begin with, and how
//! much warmer than its air it is [K]; sweeps are fewer then
LeafExchange leaf_exchange(const ThermalLeaf& leaf,
                           const LeafSurroundings& around,
                           const LeafExchange* like = nullptr);

//! Returns the exchange of a leaf that has the temperature of the air and no
//! boundary layer.
//! @param net assimilation, whatever it follows from [umol m-2 s-1]
LeafExchange exchange_at_air_temperature(const Stomata& stomata,
                                         const LeafSurroundings& around,
                                         const Expansion& net);

}  // namespace ideotype
