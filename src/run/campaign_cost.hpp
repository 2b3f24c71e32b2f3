// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "campaign/campaign.hpp"

namespace ideotype {

//! The cost of a campaign if no stop rule ends a case early.
struct CampaignCost {
    //! Measures evaluations of the baseline in a case.
    CampaignCost(const Campaign& campaign, const Case& chosen);

    long long evaluations() const {
        return static_cast<long long>(generations) * population;
    }
    //! Returns the time of a single case [s]. At the end of each generation,
    //! workers wait for the slowest one.
    double of_case(int workers) const;
    //! Returns the time of several cases in one job [s]. While one case waits
    //! for the end of a generation, workers evaluate other cases.
    double of_cases(std::size_t cases, int workers) const;

    //! Times of a normal and of a final evaluation on one core of this machine
    //! [s].
    double usual = 0, final = 0;
    int population, generations, finalists;
};

}  // namespace ideotype
