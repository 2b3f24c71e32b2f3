// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "ideotype/core/estimate.hpp"
#include "ideotype/light/illumination.hpp"
#include "ideotype/light/sunlit.hpp"
#include "ideotype/light/transport.hpp"

namespace ideotype {

//! The light budget of one source or of all sources, with standard errors, in
//! the unit of `incident`.
struct BudgetEstimate {
    double incident = 0;  //!< light on the ground area
    //! The sum of all parts. In a periodic stand this is the incident light, in
    //! an isolated plot the light that enters its bounding box from all sides.
    Estimate entered;
    Estimate leaves;
    Estimate organs;   //!< absorbed by stalks, sheaths and other organs
    Estimate plants;   //!< absorbed by leaves and organs
    Estimate objects;  //!< absorbed by fixed objects
    Estimate soil;
    Estimate reflected;

    //! The light absorbed by leaves, by the place it comes from directly: the
    //! sun, the sky, or another surface.
    Estimate leaves_beam;
    Estimate leaves_sky;
    Estimate leaves_scattered;
};

//! The light at one hour of the day. If there are several days, the mean over
//! all of them, including those without light at this hour.
struct StepReport {
    double hour = 0;        //!< local clock time at the site [h]
    BudgetEstimate budget;  //!< power per ground area [W m-2]
    //! The sunlit fraction of the one-sided leaf area, if requested.
    std::optional<Estimate> sunlit;
};

//! The light absorbed or received by a part, such as one side of a fixed
//! object.
struct PartLight {
    Estimate day;  //!< light on a mean day [J m-2 day-1]
    std::vector<double> by_randomisation;
    std::vector<Estimate> hours;  //!< light at LightSeries::hours() [W m-2]
};

//! The light of a day, or of the mean day of a period, in one stand and
//! waveband.
struct DayReport {
    BudgetEstimate day;  //!< light on a mean day [J m-2 day-1]
    std::vector<Estimate>
        groups;  //!< light absorbed by each group [J m-2 day-1]
    //! Light absorbed by leaves in each layer, the lowest first [J m-2 day-1].
    std::vector<Estimate> layers;
    Estimate adaxial,
        abaxial;  //!< light absorbed through each leaf side [J m-2 day-1]
    std::vector<StepReport> steps;  //!< light at LightSeries::hours()
    double utc_offset = 0;  //!< offset of the clock of `hour` from UTC [h]
    //! The light of Tally::parts per ground area.
    std::vector<PartLight> parts;
    //! The light absorbed by leaves on each date, if there are several [J m-2
    //! day-1].
    std::vector<Estimate> dates;
    //! The largest relative difference in any randomisation between incident
    //! light and the sum of its parts.
    double balance_error = 0;
};

//! Sums independent tallies of a series. Instants that share a source divide
//! its light in proportion to their incident light. The standard errors are
//! those of the mean over tallies, but at least the limit set by the number of
//! paths, see Resolution.
DayReport report(const std::vector<Tally>& tallies,
                 const SeriesIllumination& illumination);

//! Returns the light from all sources that each group of the mesh absorbs [J
//! m-2 of ground], with standard errors as in report().
std::vector<Estimate> absorbed_by_group(const std::vector<Tally>& tallies);

//! Returns the light from all sources that a set of groups absorbs [J m-2 of
//! ground], with a standard error as in report().
Estimate absorbed_by_groups(const std::vector<Tally>& tallies,
                            const std::vector<std::size_t>& groups);

//! Returns the light from all sources that a set of leaves absorbs [J m-2 of
//! ground], with a standard error as in report().
//! @param of_some light absorbed by these leaves, by tally
Estimate absorbed_by_some_leaves(const std::vector<Tally>& tallies,
                                 const std::vector<double>& of_some);

//! Returns the light from all sources that all leaves absorb [J m-2 of ground],
//! with a standard error as in report().
Estimate absorbed_by_leaves(const std::vector<Tally>& tallies);

//! Returns the light that the soil absorbs in each step [W m-2] [tally][step].
std::vector<std::vector<double>> absorbed_by_soil(
    const std::vector<Tally>& tallies, const SeriesIllumination& illumination);

//! The sunlit fraction of the one-sided leaf area.
struct SunlitReport {
    Estimate mean;  //!< mean over the time with any light
    std::vector<double> mean_by_randomisation;
    std::vector<Estimate>
        hours;  //!< fraction at LightSeries::hours(); 0 without sun
};

SunlitReport report(const SunlitFractions& sunlit,
                    const SeriesIllumination& illumination);

}  // namespace ideotype
