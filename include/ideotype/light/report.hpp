// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "ideotype/core/estimate.hpp"
#include "ideotype/light/illumination.hpp"
#include "ideotype/light/sunlit.hpp"
#include "ideotype/light/transport.hpp"

namespace ideotype {

//! The parts of the light of one source or of all sources, with standard
//! errors, in the unit of `incident`.
struct BudgetEstimate {
    double incident = 0;  //!< light on the ground area
    //! The sum of all parts: in a periodic stand the incident light, in an
    //! isolated plot the light that enters its bounding box from all sides.
    Estimate entered;
    Estimate leaves;
    Estimate organs;   //!< light of stalks, sheaths and other organs
    Estimate plants;   //!< light of leaves and organs
    Estimate objects;  //!< light of fixed objects
    Estimate soil;
    Estimate reflected;

    //! The light that leaves absorb, by its last origin: the sun, the sky, or
    //! another surface.
    Estimate leaves_beam;
    Estimate leaves_sky;
    Estimate leaves_scattered;
};

//! The light of one instant of the day, or its mean over several days,
//! including days without light at this hour.
struct StepReport {
    double hour = 0;        //!< clock time of the site [h]
    BudgetEstimate budget;  //!< power per ground area [W m-2]
    //! The sunlit part of the one-sided leaf area, if it was asked for.
    std::optional<Estimate> sunlit;
};

//! The light that a part, such as one side of a fixed object, absorbs or
//! receives.
struct PartLight {
    Estimate day;  //!< light of a mean day [J m-2 day-1]
    std::vector<double> by_randomisation;
    std::vector<Estimate> hours;  //!< light at LightSeries::hours() [W m-2]
};

//! The light of one day, or of the mean of several, in one stand and waveband.
struct DayReport {
    BudgetEstimate day;  //!< light of a mean day [J m-2 day-1]
    std::vector<Estimate>
        groups;  //!< light that each group absorbs [J m-2 day-1]
    //! Light of leaves by layer, the lowest first [J m-2 day-1].
    std::vector<Estimate> layers;
    Estimate adaxial,
        abaxial;  //!< light through the faces of leaves [J m-2 day-1]
    std::vector<StepReport> steps;  //!< light at LightSeries::hours()
    double utc_offset = 0;  //!< offset from UTC of the clock of hours [h]
    //! The light of Tally::parts per area of ground.
    std::vector<PartLight> parts;
    //! The light that leaves absorb on each of several days [J m-2 day-1].
    std::vector<Estimate> dates;
    //! The largest relative difference , in any randomisation, between incident
    //! light and the sum of its parts.
    double balance_error = 0;
};

//! Sums up independent tallies of a series. If instants share a source, each
//! instant has a part of the source's light in proportion to its own light. The
//! standard errors are those of the mean of the tallies, but not below the
//! limit that paths set, see Resolution.
DayReport report(const std::vector<Tally>& tallies,
                 const SeriesIllumination& illumination);

//! Returns the light that each group of the mesh absorbs, from all sources [J
//! m-2 of ground], with standard errors as in report().
std::vector<Estimate> absorbed_by_group(const std::vector<Tally>& tallies);

//! Returns the light that some groups absorb together, from all sources [J m-2
//! of ground], with a standard error as in report().
Estimate absorbed_by_groups(const std::vector<Tally>& tallies,
                            const std::vector<std::size_t>& groups);

//! Returns the light that some leaves absorb together, from all sources
//! [J m-2 of ground], with a standard error as in report().
//! @param of_some light of these leaves by tally
Estimate absorbed_by_some_leaves(const std::vector<Tally>& tallies,
                                 const std::vector<double>& of_some);

//! Returns the light that all leaves absorb, from all sources [J m-2 of
//! ground], with a standard error as in report().
Estimate absorbed_by_leaves(const std::vector<Tally>& tallies);

//! The sunlit part of the one-sided leaf area.
struct SunlitReport {
    Estimate mean;  //!< mean over the time with any light
    std::vector<double> mean_by_randomisation;
    std::vector<Estimate>
        hours;  //!< part at LightSeries::hours(); 0 without sun
};

SunlitReport report(const SunlitFractions& sunlit,
                    const SeriesIllumination& illumination);

}  // namespace ideotype
