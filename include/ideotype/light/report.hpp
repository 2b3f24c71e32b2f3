#pragma once

#include <vector>

#include "ideotype/core/estimate.hpp"
#include "ideotype/light/illumination.hpp"
#include "ideotype/light/transport.hpp"
#include "ideotype/sky/day.hpp"

namespace ideotype {

//! Where light went, with standard errors, in the unit of `incident`.
struct BudgetEstimate {
    double incident = 0;
    Estimate leaves;
    Estimate stalks;
    Estimate soil;
    Estimate reflected;
};

//! One instant of the day.
struct StepReport {
    double hour = 0;        //!< local clock [h]
    BudgetEstimate budget;  //!< [W m-2]
};

//! The light of one day in one stand.
struct DayReport {
    BudgetEstimate day;             //!< [J m-2 day-1]
    std::vector<Estimate> groups;   //!< absorbed per group [J m-2 day-1]
    std::vector<StepReport> steps;  //!< all instants of the day
    //! Largest relative difference between incident light and the sum of its
    //! parts in any randomisation.
    double balance_error = 0;
};

//! Sums up independent tallies of a day; where one sky serves the whole day,
//! the diffuse part of each instant is its share of that. The standard errors
//! are those of the mean of the tallies.
DayReport report(const std::vector<Tally>& tallies,
                 const DayIllumination& illumination, const Day& day);

}  // namespace ideotype
