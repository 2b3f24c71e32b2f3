// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "campaign/campaign.hpp"

namespace ideotype {

//! The cost of a campaign in which no stop rule ends a case early.
struct CampaignCost {
    //! Measures evaluations of the baseline in a case.
    CampaignCost(const Campaign& campaign, const Case& chosen);

    long long evaluations() const {
        return static_cast<long long>(generations) * population;
    }
    //! Returns the time of one case alone [s], in which each generation waits
    //! for its slowest worker.
    double of_case(int workers) const;
    //! Returns the time of several cases in one job [s]; while one waits for a
    //! generation, workers evaluate others.
    double of_cases(std::size_t cases, int workers) const;

    //! Time of a usual and a final evaluation on one core of this machine [s].
    double usual = 0, final = 0;
    int population, generations, finalists;
};

}  // namespace ideotype
