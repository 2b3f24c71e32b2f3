// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <variant>

#include "ideotype/physiology/collatz.hpp"
#include "ideotype/physiology/farquhar.hpp"
#include "ideotype/physiology/hyperbola.hpp"

namespace ideotype {

//! A leaf of the hyperbola at 30 deg C, which is the temperature of clear days.
struct HyperbolaLeaf {
    Hyperbola response;
    //! Respiration in the dark [umol m-2 s-1], day and night alike: 0.04 amax,
    //! which is 2 at 50, as in the maize of Kim et al. 2007. Were it the same
    //! in all leaves, the lowest would lose carbon.
    std::optional<double> respiration{};
};

//! Parameters of a leaf by one of the models.
using LeafRates = std::variant<HyperbolaLeaf, CollatzLeaf, FarquharLeaf>;

//! The air around a leaf, which has its temperature.
struct Air {
    double temperature = 30;  //!< [deg C]
    double humidity = 0.6;    //!< relative, 0 to 1
};

//! Returns the leaf with capacities (amax; vmax; vcmax, jmax and tpu) and a
//! respiration of so many times.
LeafRates scaled(const LeafRates& leaf, double factor);

//! Returns the leaf without respiration.
LeafRates without_respiration(LeafRates leaf);

//! Returns the hyperbola at a temperature [deg C]: amax g(T) / g(30), with g of
//! c4_temperature_response(). phi does not change.
Hyperbola hyperbola_at(const HyperbolaLeaf& leaf, double temperature);

//! Respiration in the dark [umol m-2 s-1]; of the hyperbola's leaf it is that
//! at 30 deg C times 2^((T - 30) / 10).
double dark_respiration(const LeafRates& leaf, double temperature);

//! Response to light of a leaf in some air.
using LeafResponse = std::variant<Hyperbola, Colimitation>;

//! Returns the response; models with CO2 take that of the leaf from the vapour
//! pressure deficit.
LeafResponse response(const LeafRates& leaf, const Air& air);

//! Gross assimilation [umol m-2 s-1] at each of some PPFDs that both faces
//! absorb per area of leaf [umol m-2 s-1].
void gross(const LeafResponse& response, std::span<const double> absorbed,
           double* assimilation);

//! Returns the assimilation with its first two derivatives.
void expand(const LeafResponse& response, std::span<const double> absorbed,
            double* assimilation, double* slope, double* curvature);

//! Carbon in carbohydrate, CH2O [mol kg-1].
inline constexpr double carbon_per_carbohydrate = 1000. / 30;

//! Dry matter that grows of the carbon in assimilates [kg mol-1]. 1 mol is
//! 0.030 kg of CH2O, of which growth makes 0.67 kg of dry matter per kg, and
//! respires the rest: WOFOST, temperate maize, has 0.68 in leaves (CVL), 0.671
//! in storage organs (CVO), 0.69 in roots (CVR) and 0.658 in stems (CVS). The
//! one number for all organs is E, with a range of 0.66 to 0.69.
inline constexpr double dry_matter_per_carbon = 0.67 / carbon_per_carbohydrate;

//! Returns the respiration of dry mass that maintains itself [umol kg-1 s-1]:
//! m 2^((T - 25) / 10), as in WOFOST.
//! @param maintenance m, carbohydrate per dry mass at 25 deg C [kg kg-1 d-1]
double maintenance_respiration(double maintenance, double temperature);

//! Carbon that building a leaf costs, once [mol m-2 of leaf]: 45 g m-2 (of 29
//! to 62 in WOFOST) of 1.39 g of CH2O each, at 30 g mol-1.
double leaf_building_cost(double grams_per_area = 45,
                          double carbohydrate_per_gram = 1.39);

}  // namespace ideotype
