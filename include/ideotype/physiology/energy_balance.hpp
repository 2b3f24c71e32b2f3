// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "ideotype/physiology/collatz.hpp"
#include "ideotype/physiology/farquhar.hpp"

namespace ideotype {

//! A model of stomata. It gives their conductance gs for water vapour, of both
//! faces together per area of leaf [mol m-2 s-1]. A is the assimilation; cs, h
//! and D are CO2, humidity and the vapour pressure deficit [kPa] at the surface
//! of the leaf, behind the boundary layer:
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
};

//! Models of leaves with assimilation that depends on CO2.
using Co2Leaf = std::variant<CollatzLeaf, FarquharLeaf>;

//! The air in front of a leaf's boundary layer.
struct SurfaceAir {
    double co2 = 400;     //!< [umol mol-1]
    double vapour = 2;    //!< pressure [kPa]
    double boundary = 1;  //!< conductance of vapour, both faces [mol m-2 s-1]
};

//! A leaf in balance with its stomata.
struct LeafBalance {
    double net = 0;          //!< assimilation [umol m-2 s-1]
    double ci = 0;           //!< CO2 within the leaf [umol mol-1]
    double conductance = 0;  //!< conductance of the stomata [mol m-2 s-1]
    //! Balances that were seen, always odd in number. In dry calm air there are
    //! up to three by Ball and Berry, some closed and one open.
    int roots = 1;
};

//! Returns the balance of a leaf of known temperature, where stomata let in the
//! CO2 that assimilation takes. Ratios of the conductances of CO2 and water are
//! 1.37 (boundary layer) and 1.6 (stomata). If there are several balances it is
//! that with the most open stomata.
//! @param absorbed PPFD [umol m-2 s-1]
//! @param temperature of the leaf [deg C]
LeafBalance balance(const Co2Leaf& leaf, const Stomata& stomata,
                    const SurfaceAir& air, double absorbed, double temperature);

//! The light that a point of a leaf absorbs, on both faces together per area of
//! leaf, and the air around it.
struct LeafSurroundings {
    double ppfd = 0;          //!< [umol m-2 s-1]
    double nir = 0;           //!< [W m-2]
    double longwave = 0;      //!< [W m-2]
    double temperature = 0;   //!< temperature of the air [deg C]
    double humidity = 0;      //!< relative, 0 to 1
    double co2 = 400;         //!< [umol mol-1]
    double pressure = 101.3;  //!< [kPa]
    double wind = 0;          //!< at the leaf [m s-1]
    double width = 0.08;      //!< width of the blade at this point, above 0 [m]
};

//! The emissivity of leaves for longwave radiation.
inline constexpr double leaf_emissivity = 0.96;

//! A leaf that exchanges heat and water.
struct ThermalLeaf {
    Co2Leaf rates = CollatzLeaf{};
    Stomata stomata{};
    double emissivity = leaf_emissivity;
    //! Conductance of the stomata of the lower face over that of the upper; 0
    //! or infinite if they are on one face only.
    double ratio = 1;
};

//! Where a leaf's energy is in balance, per area of leaf.
struct EnergyBalance {
    double temperature = 0;    //!< temperature of the leaf [deg C]
    double net = 0;            //!< assimilation [umol m-2 s-1]
    double conductance = 0;    //!< of the stomata for vapour [mol m-2 s-1]
    double ci = 0;             //!< CO2 within the leaf [umol mol-1]
    double transpiration = 0;  //!< [mmol m-2 s-1]; negative if dew falls
    double latent = 0;         //!< [W m-2]
    double sensible = 0;       //!< [W m-2]
    double net_radiation = 0;  //!< [W m-2]
    double boundary_heat = 0;  //!< conductance of one face [mol m-2 s-1]
    int roots = 1;             //!< balances that were seen, odd in number
};

//! The balance of absorbed light and longwave radiation, emission, heat and
//! water, with photosynthesis and stomata:
//!
//!     R = Q / 4.57 + NIR + LW - 2 e sigma T^4
//!     H = 2 cp gh (T - Ta)
//!     E = gs gb / (gs + gb) (es(T) - ea) / P,  or 2 gw (es(T) - ea) / P of dew
//!     0 = R - H - lambda E
//!
//! where gh [mol m-2 s-1] of one face joins forced and free convection
//! (Campbell and Norman 1998) and still air by the cube root of their cubes, gw
//! is 1.09 gh and gb = gw (1 + r)^2 / (1 + r^2) for the ratio r. If there are
//! several balances it is the coolest: enzymes fail in heat, so that in strong
//! light and calm air a leaf may stay cool with open stomata or hot with closed
//! ones. Each temperature has one conductance that closes the energy balance,
//! and one assimilation at that conductance; the opening of stomata
//! is then a continuous function of temperature, searched from the
//! coolest temperature that any stomata allow to that with none. Balances that
//! are closer to each other than its steps (a fortieth of that range) may stay
//! unseen.
EnergyBalance energy_balance(const ThermalLeaf& leaf,
                             const LeafSurroundings& around);

}  // namespace ideotype
