// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ideotype {

//! A column of soil, as in FAO-56 (Allen and others 1998, Crop
//! evapotranspiration, FAO Irrigation and Drainage Paper 56).
struct Soil {
    double field_capacity = 0.32;  //!< water content [m3 m-3]
    double wilting_point = 0.15;   //!< water content [m3 m-3]
    //! Water that can evaporate from the upper layer, and the part of it that
    //! evaporates without limitation [mm].
    double total_evaporable = 22, readily_evaporable = 9;
    //! Fraction of the available water that roots take up without stress.
    double depletion_fraction = 0.55;
    //! Curve number of runoff (SCS); 0: water does not run off.
    double curve_number = 0;

    //! Returns the water that is available to roots of a depth [m], TAW [mm]
    //! (equation 82).
    double available(double root_depth) const {
        constexpr double mm_per_m = 1000;
        return mm_per_m * (field_capacity - wilting_point) * root_depth;
    }
};

//! The water that is missing at field capacity [mm]: in the root zone, and in
//! the layer from which water evaporates.
struct SoilWater {
    double depletion = 0, evaporable_depletion = 0;
};

//! The demand and supply of water on a day [mm], and the depth of roots [m].
struct SoilDay {
    double potential_transpiration = 0, potential_evaporation = 0;
    double rain = 0, irrigation = 0;
    double root_depth = 0;
};

//! The water that leaves a column of soil on a day [mm].
struct SoilFluxes {
    double transpiration = 0, evaporation = 0, drainage = 0, runoff = 0;
};

//! Returns the share of potential transpiration that roots can supply, Ks
//! (equation 84): 1 without stress and 0 at the wilting point.
//! @param depletion missing water of the root zone [mm]
double water_stress(const Soil& soil, double root_depth, double depletion);

//! Returns the part of a day's rain that runs off [mm]: with S = 254 (100 / CN
//! - 1), (P - 0.2 S)^2 / (P + 0.8 S) of rain above 0.2 S (USDA Soil
//! Conservation Service 1972, National Engineering Handbook, section 4).
double runoff(double curve_number, double rain);

//! The weather of a day, means over its hours.
struct AirOfDay {
    double temperature = 0;   //!< [deg C]
    double deficit = 0;       //!< vapour pressure deficit [kPa]
    double wind = 0;          //!< at 2 m [m s-1]
    double pressure = 101.3;  //!< [kPa]
    double radiation = 0;     //!< of sun and sky [MJ m-2 day-1]
    //! Longwave radiation of a surface at air temperature less that of the sky
    //! [MJ m-2 day-1].
    double longwave_loss = 0;
};

//! Returns the evapotranspiration of a grass reference [mm day-1] (FAO-56,
//! equation 6, with an albedo of 0.23), at least 0.
double reference_evapotranspiration(const AirOfDay& air);

//! Potential evaporation of bare wet soil over reference_evapotranspiration()
//! (Raes and others 2009, doi:10.2134/agronj2008.0140s). Below a canopy it is
//! multiplied by the light on the soil over that above.
inline constexpr double bare_soil_coefficient = 1.10;

//! Computes the water balance of one day, with rain and irrigation at its
//! beginning. The whole surface is wetted and exposed, roots take no water from
//! the evaporable layer alone, and no water rises from
//! below.
//! Evaporation is taken before transpiration and is limited to the water of the
//! root zone (equations 74, 77, 84, 85 and 88; both limits are choices of this
//! program). Rain runs off as the curve number states. Growing roots reach soil
//! at field capacity.
//! @param water state at the beginning of the day; set to that at its end
SoilFluxes pass_day(const Soil& soil, const SoilDay& day, SoilWater& water);

}  // namespace ideotype
