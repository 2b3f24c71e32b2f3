// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "ideotype/crop/plant.hpp"

namespace ideotype {

//! Growth and ageing of the plants of a crop in thermal time [deg C d] since
//! emergence. Blades appear tip first at a steady rate, fade after their death,
//! and have a final area that follows their rank. The defaults describe a
//! hybrid of the US Corn Belt.
struct Growth {
    int leaves = 19;       //!< leaves of the main stem, from rank 1 up
    double interval = 44;  //!< thermal time from tip to tip [deg C d]
    //! Area of the largest blade [m2], and the rank of that blade relative to
    //! the number of leaves.
    double largest_area = 0.07, largest = 0.67;
    //! Exponents a and b of the area by rank, see leaf_dates().
    double narrowing = 4.5, skewness = 1.1;
    //! Time from tip to collar of the first leaf, of the slowest leaf and of
    //! the last leaf [deg C d].
    double first_extension = 70, longest_extension = 190, last_extension = 105;
    //! The lower 40 % of leaves die one by one from `lower_death` on,
    //! `lower_interval` apart, the other leaves from `upper_death` after
    //! silking on [deg C d].
    double lower_death = 200, lower_interval = 100, upper_death = 500,
           upper_interval = 84;
    double fading = 150;            //!< time from death to loss of all green
    double silking = 20;            //!< time after `leaves` intervals
    double maturity = 970;          //!< time after silking [deg C d]
    double internode_rate = 0.002;  //!< growth of an internode [m / (deg C d)]
    double base = 8, cap = 34;      //!< limits of thermal time [deg C]
    //! Photosynthetic capacity of leaves, and maintenance respiration of other
    //! organs per mass, both relative to that before silking: values at equal
    //! steps of development_stage() from silking to maturity, linear in
    //! between.
    std::vector<double> ageing{1}, maintenance{1};
    //! Dry mass of roots relative to that of leaves and living organs; 0: roots
    //! are ignored.
    double root_share = 0;
    //! Respiration of the dry matter that enters the ear after silking, at 25
    //! deg C: carbohydrate per dry mass [kg kg-1 d-1]; 0: it is ignored.
    double ear_maintenance = 0;

    bool operator==(const Growth&) const = default;
};

//! Respiration of roots at 25 deg C: carbohydrate per dry mass [kg kg-1 d-1]
//! (RMR of temperate maize, github.com/ajwdewit/WOFOST_crop_parameters).
inline constexpr double root_maintenance = 0.015;

//! The dates of one leaf [deg C d], and the area of its blade [m2].
struct LeafDates {
    double tip = 0;     //!< time when the blade begins to appear
    double collar = 0;  //!< time when the whole blade is out
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

//! Returns the development stage at a thermal time since emergence, as DVS of
//! WOFOST: 0 at emergence, 1 at silking, 2 from maturity on, linear in thermal
//! time in between.
double development_stage(const Growth& growth, double thermal_time);

//! Returns the thermal time at a development stage from 0 to 2 [deg C d]: the
//! inverse of development_stage().
double find_thermal_time(const Growth& growth, double stage);

//! Returns the capacity of green leaves, and with it their respiration,
//! relative to that before silking. In WOFOST it falls to 0.3 at maturity
//! (AMAXTB of temperate maize, github.com/ajwdewit/WOFOST_crop_parameters).
double capacity_factor(const Growth& growth, double thermal_time);

//! Returns the maintenance respiration of stalks, ears and roots per mass,
//! relative to that before silking (RFSETB of the same file: 1, 0.75, 0.25 at
//! the stages 1.5, 1.75 and 2).
double maintenance_factor(const Growth& growth, double thermal_time);

//! Returns the dates of each leaf from the lowest up. Areas are
//! A exp(-a x^2 + b x^3) with x = (n - m) / (m - 1), where m is the rank of the
//! largest blade (Lizaso and others 2003, doi:10.1016/S0378-4290(02)00151-X).
std::vector<LeafDates> leaf_dates(const Growth& growth);

//! Returns the share of a blade that is visible at a thermal time, 0 to 1: it
//! appears tip first, steadily from the date of the tip to that of the collar.
double visible_share(const LeafDates& leaf, double thermal_time);

//! Returns the share of a blade that has faded, 0 to 1.
double faded_share(const Growth& growth, const LeafDates& leaf,
                   double thermal_time);

//! Returns the green and the dead area of a blade at a thermal time.
BladeArea blade_area(const Growth& growth, const LeafDates& leaf,
                     double thermal_time);

//! Returns the heights of the collars of full-grown leaves [m]. The leaves of
//! the plant, which are the highest, have collars where they are inserted; the
//! leaves below have collars in equal steps from the soil.
//! @throws Error if the plant has more leaves than `growth`.
std::vector<double> final_collar_heights(const Growth& growth,
                                         const Plant& plant);

//! Returns the heights of collars above the soil at a thermal time [m]. An
//! internode grows at a steady rate from the date of its leaf's collar on; a
//! sheath grows from the date of its leaf's tip to that of its collar.
//! @param final_heights heights of the collars of full-grown leaves, lowest
//! rank first [m]
//! @param sheath length of sheaths that the soil does not cut short [m]
std::vector<double> collar_heights(const Growth& growth,
                                   std::span<const double> final_heights,
                                   double sheath, double thermal_time);

//! Returns a full-grown plant with all leaves. Leaves added below those of the
//! plant resemble its lowest leaf, with areas relative to it that follow
//! leaf_dates().
//! @throws Error as final_collar_heights()
Plant complete_plant(const Growth& growth, const Plant& plant);

//! Removes capacity and maintenance from organs past their Organ::senescence,
//! and scales the maintenance of all organs by maintenance_factor().
void age_organs(const Growth& growth, double thermal_time, Plant& plant);

//! Returns a plant at a thermal time, with all leaves, visible or not. With v
//! the visible share of a blade, its insertion angle is multiplied by 0.3 + 0.7
//! v and its curvature by v. The tip of a dead blade hangs by 40 deg more.
//! Organs other than leaves grow in the last 100 deg C d before silking.
//! @param plant full-grown plant, which has only the highest leaves
//! @throws Error as final_collar_heights()
Plant age_plant(const Growth& growth, const Plant& plant, double thermal_time);

//! Returns the thermal time of one day [deg C d]: the mean over the hours of
//! the temperature, clamped to [base, cap], less `base`.
double daily_thermal_time(const Growth& growth,
                          std::span<const double> temperatures);

}  // namespace ideotype
