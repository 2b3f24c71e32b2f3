// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "ideotype/crop/plant.hpp"

namespace ideotype {

//! Growth and ageing of the plants of a crop in thermal time [deg C d] since
//! emergence. Blades appear tip first at a steady rate and lose their green
//! area gradually after their death. Their final area is a function of rank.
//! The defaults describe a hybrid of the US Corn Belt.
struct Growth {
    int leaves = 19;  //!< number of leaves of the main stem
    //! Thermal time between the tips of successive leaves [deg C d].
    double interval = 44;
    //! Area of the largest blade [m2], and the rank of that blade divided by
    //! the number of leaves.
    double largest_area = 0.07, largest = 0.67;
    //! Exponents a and b of the area by rank, see leaf_dates().
    double narrowing = 4.5, skewness = 1.1;
    //! Time from tip to collar of the first leaf, of the slowest leaf and of
    //! the last leaf [deg C d].
    double first_extension = 70, longest_extension = 190, last_extension = 105;
    //! The lower 40 % of leaves die one by one, the first at `lower_death`, the
    //! next ones at intervals of `lower_interval`. The other leaves follow from
    //! `upper_death` after silking, at intervals of `upper_interval` [deg C d].
    double lower_death = 200, lower_interval = 100, upper_death = 500,
           upper_interval = 84;
    double fading = 150;    //!< time from death to complete loss of green area
    double silking = 20;    //!< time after `leaves` intervals
    double maturity = 970;  //!< time after silking [deg C d]
    double internode_rate = 0.002;  //!< growth of an internode [m / (deg C d)]
    double base = 8, cap = 34;      //!< limits of thermal time [deg C]
    //! Photosynthetic capacity of leaves, and maintenance respiration of other
    //! organs per mass, both relative to their values before silking. Values
    //! are at equal steps of development_stage() from silking to maturity, with
    //! linear interpolation.
    std::vector<double> ageing{1}, maintenance{1};
    //! Dry mass of roots relative to that of leaves and living organs; 0: roots
    //! are ignored.
    double root_share = 0;
    //! Respiration of the dry matter that enters the ear after silking, at 25
    //! deg C: carbohydrate per dry mass [kg kg-1 d-1]. 0: this respiration is
    //! ignored.
    double ear_maintenance = 0;

    bool operator==(const Growth&) const = default;
};

//! Respiration of roots at 25 deg C: carbohydrate per dry mass [kg kg-1 d-1]
//! (RMR of temperate maize, github.com/ajwdewit/WOFOST_crop_parameters).
inline constexpr double root_maintenance = 0.015;

//! The dates in the life of one leaf [deg C d], and the area of its blade [m2].
struct LeafDates {
    double tip = 0;     //!< time when the blade begins to appear
    double collar = 0;  //!< time when the whole blade has emerged
    double death = 0;   //!< time when the blade begins to fade
    double area = 0;    //!< one-sided area of the full-grown blade
};

//! The visible area of a blade at a thermal time [m2].
struct BladeArea {
    double green = 0, dead = 0;
};

//! Returns the thermal time from emergence to silking [deg C d].
double silking_time(const Growth& growth);

//! Returns the thermal time from emergence to maturity [deg C d].
double maturity_time(const Growth& growth);

//! Returns the development stage at a thermal time since emergence, like DVS in
//! WOFOST: 0 at emergence, 1 at silking, 2 from maturity on, and linear in
//! thermal time in between.
double development_stage(const Growth& growth, double thermal_time);

//! Returns the thermal time at a development stage from 0 to 2 [deg C d]: the
//! inverse of development_stage().
double find_thermal_time(const Growth& growth, double stage);

//! Returns the capacity of green leaves, which also scales their respiration,
//! relative to its value before silking. In WOFOST it falls to 0.3 at maturity
//! (AMAXTB of temperate maize, github.com/ajwdewit/WOFOST_crop_parameters).
double capacity_factor(const Growth& growth, double thermal_time);

//! Returns the maintenance respiration per mass of stalks, ears and roots
//! relative to its value before silking (RFSETB of the same file: 1, 0.75, 0.25
//! at the stages 1.5, 1.75 and 2).
double maintenance_factor(const Growth& growth, double thermal_time);

//! Returns the dates of each leaf, lowest first. The area of leaf n is A exp(-a
//! x^2 + b x^3) with x = (n - m) / (m - 1), where m is the rank of the largest
//! blade (Lizaso and others 2003, doi:10.1016/S0378-4290(02)00151-X).
std::vector<LeafDates> leaf_dates(const Growth& growth);

//! Returns the share of a blade that is visible at a thermal time, 0 to 1. The
//! blade appears tip first, at a steady rate between the dates of its tip and
//! its collar.
double visible_share(const LeafDates& leaf, double thermal_time);

//! Returns the share of a blade that has lost its green colour, 0 to 1.
double faded_share(const Growth& growth, const LeafDates& leaf,
                   double thermal_time);

//! Returns the green and the dead area of a blade at a thermal time.
BladeArea blade_area(const Growth& growth, const LeafDates& leaf,
                     double thermal_time);

//! Returns the heights of the collars of full-grown leaves [m]. The leaves of
//! `plant` are the highest leaves; their collars are at their insertion
//! heights. The collars of the leaves below are at equal steps from the soil
//! up.
//! @throws Error if the plant has more leaves than `growth`.
std::vector<double> final_collar_heights(const Growth& growth,
                                         const Plant& plant);

//! Returns the heights of collars above the soil at a thermal time [m]. An
//! internode grows at a steady rate from the collar date of its leaf; a sheath
//! grows from the tip date to the collar date of its leaf.
//! @param final_heights heights of the collars of full-grown leaves, lowest
//! leaf first [m]
//! @param sheath length of sheaths that do not reach the soil [m]
std::vector<double> collar_heights(const Growth& growth,
                                   std::span<const double> final_heights,
                                   double sheath, double thermal_time);

//! Returns a full-grown plant with all leaves. Leaves added below those of the
//! plant resemble its lowest leaf; their relative areas follow leaf_dates().
//! @throws Error like final_collar_heights()
Plant complete_plant(const Growth& growth, const Plant& plant);

//! Removes capacity and maintenance from organs past their Organ::senescence,
//! and scales the maintenance of all organs by maintenance_factor().
void age_organs(const Growth& growth, double thermal_time, Plant& plant);

//! Returns a plant at a thermal time, with all leaves, visible or not. If a
//! share v of a blade is visible, its insertion angle is multiplied by 0.3 +
//! 0.7 v and its curvature by v. The tip of a dead blade bends down by 40 deg
//! more. Organs other than leaves grow during the last 100 deg C d before
//! silking.
//! @param plant full-grown plant with only the highest leaves
//! @throws Error like final_collar_heights()
Plant age_plant(const Growth& growth, const Plant& plant, double thermal_time);

//! Returns the thermal time of one day [deg C d]: the mean over its hours of
//! the temperature clamped to [base, cap], minus `base`.
double daily_thermal_time(const Growth& growth,
                          std::span<const double> temperatures);

}  // namespace ideotype
