// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "campaign/campaign.hpp"
#include "over_stages.hpp"

namespace ideotype {

//! Returns all quantities of a case that is its own only scenario.
QuantitySet measured_in(const Campaign& campaign, const Case& scenario);

//! The outcome of a plant in all scenarios of a case, each over its stages.
class AcrossScenarios {
  public:
    AcrossScenarios(const Campaign& campaign, const Case& chosen);

    //! Returns means over scenarios of quantities with equal axes in all
    //! scenarios (hours or days may differ), and each objective by scenario, as
    //! `absorbed_par_by_scenario`; for a single scenario, all quantities.
    const QuantitySet& measured() const { return measured_; }

    //! Combines the outcomes of all scenarios. Objectives are means, by
    //! randomisation too, so that their standard errors include the random
    //! numbers that scenarios share; or each objective is taken from the
    //! scenario where it is worst. The violation is the largest. Standard
    //! errors of other quantities are means too, which is an upper bound.
    //! @param each a done outcome of each of evaluated_cases()
    Outcome combine(const std::vector<Outcome>& each) const;

  private:
    Outcome combine_scenarios(const std::vector<Outcome>& each) const;

    //! A quantity averaged over scenarios.
    struct Shared {
        std::size_t size;
        //! Place in each scenario's quantities.
        std::vector<std::size_t> begins;
    };

    void combine_objective(const std::vector<Outcome>& each,
                           std::size_t objective, Outcome& all) const;

    Across across_;
    std::vector<std::size_t> stages_;  //!< stages of each scenario
    //! Stages by scenario, if plants grow.
    std::vector<OverStages> over_stages_;
    std::vector<ObjectiveEntry> objectives_;
    QuantitySet measured_;
    std::vector<Shared> shared_;
};

}  // namespace ideotype
