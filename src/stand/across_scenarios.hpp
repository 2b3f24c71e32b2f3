// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "over_stages.hpp"

namespace ideotype {

//! Returns all that is measured in a case that is its only scenario.
QuantitySet measured_in(const Campaign& campaign, const Case& scenario);

//! The outcome of a plant in all scenarios of a case, each over its stages.
class AcrossScenarios {
  public:
    AcrossScenarios(const Campaign& campaign, const Case& chosen);

    //! Means over scenarios of what has the same axes in all of them: hours or
    //! days may differ. And each objective by scenario, as
    //! `absorbed_par_by_scenario`. All that is measured in a single one.
    const QuantitySet& measured() const { return measured_; }

    //! Objectives are the means, by randomisation too, so that their standard
    //! errors know what scenarios share; or each is that of the scenario where
    //! it is worst. The violation is the largest. Standard errors of other
    //! quantities are means too, which is at least what they are.
    //! @param each a done outcome of each of evaluated_cases()
    Outcome combine(const std::vector<Outcome>& each) const;

  private:
    Outcome combine_scenarios(const std::vector<Outcome>& each) const;

    //! A mean over scenarios.
    struct Shared {
        std::size_t size;
        std::vector<std::size_t> begins;  //!< in each scenario's quantities
    };

    void combine_objective(const std::vector<Outcome>& each,
                           std::size_t objective, Outcome& all) const;

    Across across_;
    std::vector<std::size_t> stages_;      //!< stages of each scenario
    std::vector<OverStages> over_stages_;  //!< of each, where plants grow
    std::vector<ObjectiveEntry> objectives_;
    QuantitySet measured_;
    std::vector<Shared> shared_;
};

}  // namespace ideotype
