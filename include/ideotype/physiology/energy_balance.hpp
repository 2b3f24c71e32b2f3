// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "ideotype/physiology/collatz.hpp"
#include "ideotype/physiology/farquhar.hpp"

namespace ideotype {

//! A model of stomata. It gives the stomatal conductance gs for water vapour of
//! both faces together, per leaf area [mol m-2 s-1]. A is assimilation; cs, h
//! and D are the CO2, the relative humidity and the vapour pressure deficit
//! [kPa] at the leaf surface, inside the boundary layer:
//!
//!     Medlyn       g0 + 1.6 (1 + g1 / sqrt(D)) A / cs,  D at least 0.05
//!     Ball-Berry   b0 + b1 A h / cs,                    h at most 1
//!
//! (Medlyn et al. 2011, doi:10.1111/j.1365-2486.2010.02375.x; Ball, Woodrow
//! and Berry 1987). Where A is negative, gs is g0 or b0.
struct Stomata {
    enum class Model { medlyn, ball_berry };

    Model model = Model::medlyn;
    double intercept = 0.01;  //!< g0 or b0 [mol m-2 s-1]
    //! g1 [kPa^0.5] (C4 plants: 1.6, Lin et al. 2015,
    //! doi:10.1038/nclimate2550) or b1 [-] (maize: 4.53, and b0 0.017, Miner
    //! and Bauerle 2017, doi:10.1111/pce.12990).
    double slope = 1.6;
    //! Opening under stress relative to that with enough water, see closed().
    double opening = 1;
};

//! Returns stomata that close under stress. The conductance without
//! assimilation is multiplied by `opening` (0 to 1), and so is the slope, as
//! far as it exceeds the value 1.6 at which no CO2 is left inside the leaf.
//! Thus Ci / (cs - Ci) is multiplied by it, in the model of Medlyn by way of g1
//! (De Kauwe et al. 2015, doi:10.5194/gmd-8-431-2015).
Stomata closed(Stomata stomata, double opening);

//! Leaf models in which assimilation depends on CO2.
using Co2Leaf = std::variant<CollatzLeaf, FarquharLeaf>;

//! The air outside a leaf's boundary layer.
struct SurfaceAir {
    double co2 = 400;   //!< [umol mol-1]
    double vapour = 2;  //!< vapour pressure [kPa]
    //! Boundary-layer conductance for vapour, both faces [mol m-2 s-1].
    double boundary = 1;
};

//! The state of a leaf in which assimilation and stomata are in balance.
struct LeafBalance {
    double net = 0;          //!< assimilation [umol m-2 s-1]
    double ci = 0;           //!< CO2 inside the leaf [umol mol-1]
    double conductance = 0;  //!< stomatal conductance [mol m-2 s-1]
    //! Number of balances found, always odd. In dry calm air the Ball-Berry
    //! model gives up to three, some with closed stomata and one with open
    //! stomata.
    int roots = 1;
};

//! Returns the balance of a leaf at a given temperature: stomata admit as much
//! CO2 as assimilation takes up. The ratio of the conductances for water and
//! CO2 is 1.37 in the boundary layer and 1.6 in stomata. If there are several
//! balances, the one with the most open stomata is returned.
//! @param absorbed absorbed PPFD [umol m-2 s-1]
//! @param temperature leaf temperature [deg C]
LeafBalance balance(const Co2Leaf& leaf, const Stomata& stomata,
                    const SurfaceAir& air, double absorbed, double temperature);

//! The light absorbed at a point on a leaf, by both faces together per leaf
//! area, and the air around it.
struct LeafSurroundings {
    double ppfd = 0;          //!< [umol m-2 s-1]
    double nir = 0;           //!< [W m-2]
    double longwave = 0;      //!< [W m-2]
    double temperature = 0;   //!< temperature of the air [deg C]
    double humidity = 0;      //!< relative humidity, 0 to 1
    double co2 = 400;         //!< [umol mol-1]
    double pressure = 101.3;  //!< [kPa]
    double wind = 0;          //!< wind at the leaf [m s-1]
    double width = 0.08;      //!< width of the blade at this point, above 0 [m]
};

//! The longwave emissivity of leaves.
inline constexpr double leaf_emissivity = 0.96;

//! A leaf that exchanges heat and water with the air.
struct ThermalLeaf {
    Co2Leaf rates = CollatzLeaf{};
    Stomata stomata{};
    double emissivity = leaf_emissivity;
    //! Stomatal conductance of the lower face relative to the upper face; 0 or
    //! infinite if stomata are on one face only.
    double ratio = 1;
};

//! The state of a leaf with a closed energy balance, per leaf area.
struct EnergyBalance {
    double temperature = 0;  //!< temperature of the leaf [deg C]
    double net = 0;          //!< assimilation [umol m-2 s-1]
    double conductance = 0;  //!< stomatal conductance for vapour [mol m-2 s-1]
    double ci = 0;           //!< CO2 inside the leaf [umol mol-1]
    double transpiration = 0;  //!< [mmol m-2 s-1]; negative: dew
    double latent = 0;         //!< [W m-2]
    double sensible = 0;       //!< [W m-2]
    double net_radiation = 0;  //!< [W m-2]
    //! Boundary-layer conductance of one face [mol m-2 s-1].
    double boundary_heat = 0;
    int roots = 1;  //!< number of balances found, always odd
};

//! Solves the balance of absorbed light, longwave radiation, emission, heat and
//! water, together with photosynthesis and stomata:
//!
//!     R = Q / 4.57 + NIR + LW - 2 e sigma T^4
//!     H = 2 cp gh (T - Ta)
//!     E = gs gb / (gs + gb) (es(T) - ea) / P,  or 2 gw (es(T) - ea) / P of dew
//!     0 = R - H - lambda E
//!
//! where gh [mol m-2 s-1] is the heat conductance of one face. It combines
//! forced convection, free convection (Campbell and Norman 1998) and still air
//! by the cube root of the sum of their cubes. gw is 1.09 gh, and gb = gw (1 +
//! r)^2 / (1 + r^2) for the ratio r.
//!
//! If there are several balances, the coolest is returned. Several occur
//! because enzymes fail in heat: in strong light and calm air a leaf may stay
//! cool with open stomata or become hot with closed ones. At each temperature,
//! one conductance closes the energy balance, and one assimilation rate results
//! from that conductance. The stomatal opening is then a continuous function of
//! temperature. It is searched from the coolest temperature that any opening
//! allows to the temperature with closed stomata. Balances that are closer
//! together than the search steps, a fortieth of that range, may be missed.
EnergyBalance energy_balance(const ThermalLeaf& leaf,
                             const LeafSurroundings& around);

}  // namespace ideotype
