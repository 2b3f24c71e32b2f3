// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <variant>

#include "ideotype/physiology/collatz.hpp"
#include "ideotype/physiology/farquhar.hpp"
#include "ideotype/physiology/hyperbola.hpp"

namespace ideotype {

//! A leaf with a hyperbolic light response at 30 deg C, a typical temperature
//! of clear days.
struct HyperbolaLeaf {
    Hyperbola response;
    //! Dark respiration, equal by day and night [umol m-2 s-1]. By default 0.04
    //! amax, which is 2 if amax is 50, as in the maize of Kim et al. 2007. With
    //! a common rate for all leaves, the lowest leaves would lose carbon.
    std::optional<double> respiration{};
};

//! Parameters of a leaf in one of the models.
using LeafRates = std::variant<HyperbolaLeaf, CollatzLeaf, FarquharLeaf>;

//! The air around a leaf at air temperature.
struct Air {
    double temperature = 30;  //!< [deg C]
    double humidity = 0.6;    //!< relative humidity, 0 to 1
};

//! Returns the leaf with its capacities (amax; vmax; vcmax, jmax and tpu) and
//! its respiration multiplied by a factor.
LeafRates scaled(const LeafRates& leaf, double factor);

//! Returns the leaf without respiration.
LeafRates without_respiration(LeafRates leaf);

//! Returns the hyperbola at a temperature T [deg C] with the asymptote amax
//! g(T) / g(30), where g is c4_temperature_response(). phi does not change.
Hyperbola hyperbola_at(const HyperbolaLeaf& leaf, double temperature);

//! Dark respiration [umol m-2 s-1]. For a HyperbolaLeaf, the rate at 30 deg C
//! is multiplied by 2^((T - 30) / 10).
double dark_respiration(const LeafRates& leaf, double temperature);

//! Light response of a leaf in given air.
using LeafResponse = std::variant<Hyperbola, Colimitation>;

//! Returns the light responses of leaves in the same air. Factors that depend
//! on the air alone are computed once. Models that use CO2 derive the CO2
//! inside the leaf from the vapour pressure deficit.
class LeavesInAir {
  public:
    explicit LeavesInAir(const Air& air) : air_(air) {}

    LeafResponse response(const LeafRates& leaf);

  private:
    Hyperbola response_of(const HyperbolaLeaf& leaf);
    Colimitation response_of(const CollatzLeaf& leaf);
    Colimitation response_of(const FarquharLeaf& leaf);
    double deficit();

    Air air_;
    std::optional<double> deficit_{};  //!< vapour pressure deficit [kPa]
    std::optional<double> of_hyperbola_{};
    std::optional<CollatzFactors> of_collatz_{};
    std::optional<FarquharFactors> of_farquhar_{};
};

//! Returns the light response of a single leaf.
LeafResponse response(const LeafRates& leaf, const Air& air);

//! Computes gross assimilation [umol m-2 s-1] at each of several PPFDs,
//! absorbed by both faces per leaf area [umol m-2 s-1].
void gross(const LeafResponse& response, std::span<const double> absorbed,
           double* assimilation);

//! Computes gross assimilation with its first two derivatives.
void expand(const LeafResponse& response, std::span<const double> absorbed,
            double* assimilation, double* slope, double* curvature);

//! Carbon in carbohydrate, CH2O [mol kg-1].
inline constexpr double carbon_per_carbohydrate = 1000. / 30;

//! Dry matter produced per carbon in assimilates [kg mol-1]. 1 mol is 0.030 kg
//! of CH2O. Growth converts this to 0.67 kg of dry matter per kg and respires
//! the rest. In WOFOST, temperate maize, the factor is 0.68 for leaves (CVL),
//! 0.671 for storage organs (CVO), 0.69 for roots (CVR) and 0.658 for stems
//! (CVS). The single factor for all organs is E, with a range of 0.66 to 0.69.
inline constexpr double dry_matter_per_carbon = 0.67 / carbon_per_carbohydrate;

//! Returns the maintenance respiration per dry mass [umol kg-1 s-1]: m 2^((T -
//! 25) / 10), as in WOFOST.
//! @param maintenance m, carbohydrate per dry mass at 25 deg C [kg kg-1 d-1]
double maintenance_respiration(double maintenance, double temperature);

//! Carbon cost of building a leaf, paid once [mol m-2 of leaf]: 45 g m-2 (29 to
//! 62 in WOFOST) times 1.39 g of CH2O per g, at 30 g mol-1.
double leaf_building_cost(double grams_per_area = 45,
                          double carbohydrate_per_gram = 1.39);

}  // namespace ideotype
