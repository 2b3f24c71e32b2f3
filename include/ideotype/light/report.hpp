// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "ideotype/core/estimate.hpp"
#include "ideotype/light/illumination.hpp"
#include "ideotype/light/sunlit.hpp"
#include "ideotype/light/transport.hpp"

namespace ideotype {

//! The parts of the light of a source or of all, with standard errors, in the
//! unit of `incident`.
struct BudgetEstimate {
    double incident = 0;  //!< on the ground area
    //! The sum of all parts: of a periodic stand the light that is incident, of
    //! an isolated plot the light that comes in through its bounding box from
    //! all sides.
    Estimate entered;
    Estimate leaves;
    Estimate organs;   //!< stalks, sheaths and other organs
    Estimate plants;   //!< leaves and organs
    Estimate objects;  //!< fixed objects
    Estimate soil;
    Estimate reflected;

    //! The light that leaves absorb, by where it came from last: from the
    //! sun, from the sky, or from another surface.
    Estimate leaves_beam;
    Estimate leaves_sky;
    Estimate leaves_scattered;
};

//! The light of one instant of the day; of several days the mean, in which a
//! day without light at that hour counts too.
struct StepReport {
    double hour = 0;        //!< site's clock [h]
    BudgetEstimate budget;  //!< [W m-2]
    //! The part of the one-sided leaf area that the sun shines on, if it was
    //! asked for.
    std::optional<Estimate> sunlit;
};

//! The light that a part absorbs, such as one side of a fixed object, or that
//! falls on it.
struct PartLight {
    Estimate day;  //!< [J m-2 day-1]
    std::vector<double> by_randomisation;
    std::vector<Estimate> hours;  //!< LightSeries::hours() [W m-2]
};

//! The light of one day, or of the mean of several, in one stand and waveband.
struct DayReport {
    BudgetEstimate day;            //!< [J m-2 day-1]
    std::vector<Estimate> groups;  //!< absorbed per group [J m-2 day-1]
    //! Light of leaves, lowest layer first [J m-2 day-1].
    std::vector<Estimate> layers;
    Estimate adaxial, abaxial;  //!< light of the faces of leaves [J m-2 day-1]
    std::vector<StepReport> steps;  //!< LightSeries::hours()
    double utc_offset = 0;          //!< offset of the clock of the hours [h]
    //! The light of Tally::parts per area of ground.
    std::vector<PartLight> parts;
    //! The light that leaves absorb on each of several days [J m-2 day-1].
    std::vector<Estimate> dates;
    //! The largest relative difference between incident light and the sum of
    //! its parts in any randomisation.
    double balance_error = 0;
};

//! Sums up independent tallies of a series. If instants share a source, each
//! has a part of it in proportion to its light. The standard errors are those
//! of the mean of the tallies, and at least as large as their paths can tell,
//! see Resolution.
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
//! @param of_some that light by tally
Estimate absorbed_by_some_leaves(const std::vector<Tally>& tallies,
                                 const std::vector<double>& of_some);

//! Returns the light that all leaves absorb, from all sources [J m-2 of
//! ground], with a standard error as in report().
Estimate absorbed_by_leaves(const std::vector<Tally>& tallies);

//! The part of the one-sided leaf area that the sun shines on.
struct SunlitReport {
    Estimate mean;  //!< over the time with any light
    std::vector<double> mean_by_randomisation;
    std::vector<Estimate> hours;  //!< LightSeries::hours(); 0 without a sun
};

SunlitReport report(const SunlitFractions& sunlit,
                    const SeriesIllumination& illumination);

}  // namespace ideotype
