// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "campaign/campaign.hpp"

namespace ideotype {

//! The cost of a campaign that no stop rule ends early.
struct CampaignCost {
    //! Measures evaluations of the baseline in a case.
    CampaignCost(const Campaign& campaign, const Case& chosen);

    long long evaluations() const {
        return static_cast<long long>(generations) * population;
    }
    //! Returns the time of one case [s], whose generations wait for the slowest
    //! worker.
    double of_case(int workers) const;
    //! Returns the time of cases that share a job [s], which fill each other's
    //! gaps.
    double of_cases(std::size_t cases, int workers) const;

    //! The times of a usual and a final evaluation on one core here [s].
    double usual = 0, final = 0;
    int population, generations, finalists;
};

}  // namespace ideotype
