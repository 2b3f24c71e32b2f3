// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "campaign/campaign.hpp"
#include "json.hpp"

namespace ideotype {

//! Seconds that evaluations of a case take here on one core.
struct EvaluationCost {
    double usual = 0;  //!< on average over the generations
    double final = 0;
};

//! The cost of a campaign that no stop rule ends early.
class CampaignCost {
  public:
    //! Measures evaluations of the baseline in a case.
    CampaignCost(const Campaign& campaign, const Case& chosen);

    Json json(std::size_t cases) const;

    //! Tells the cost of one case on one core in a line without its end.
    std::string text() const;

    //! Tells the time of one case and of all by the number of workers.
    std::string table(std::size_t cases) const;

  private:
    //! The time of one case [s]: the slowest worker of a generation counts.
    double of_case(int workers) const;
    //! The time of cases that share a job [s]: they fill each other's gaps.
    double of_cases(std::size_t cases, int workers) const;

    EvaluationCost seconds_;
    int population_;
    int generations_;
    int finalists_;
};

}  // namespace ideotype
