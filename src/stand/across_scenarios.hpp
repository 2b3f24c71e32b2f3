// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "ideotype/canopy/quantities.hpp"

namespace ideotype {

//! The outcome of plants that grow, combined from outcomes at each stage.
class OverStages {
  public:
    //! @param chosen case with stages
    OverStages(const Campaign& campaign, const Case& chosen);

    //! Returns the quantities of each stage except those by hour, and some
    //! quantities by stage.
    const QuantitySet& measured() const { return measured_; }

    //! Combines outcomes of stages by mean_over() of each quantity. Amounts are
    //! sums over stages, for a mean day of the season. Stages have their own
    //! random numbers.
    //! @param each a done outcome of each stage
    Outcome combine(std::span<const Outcome> each) const;

  private:
    std::vector<double> weights(MeanOver kind,
                                std::span<const Outcome> each) const;

    struct Summed {
        MeanOver kind;
        std::size_t size;
        std::vector<std::size_t> begins;  //!< place in each stage's quantities
        //! The place of each number of each stage.
        std::vector<std::vector<std::size_t>> places;
    };

    //! Adds a quantity, unless the quantity is by hour or has other places in
    //! each stage.
    void add(const Quantity& quantity, const std::vector<QuantitySet>& sets);

    struct ByStage {
        std::vector<std::size_t> begins;
        bool is_amount;
    };

    std::vector<ObjectiveEntry> objectives_;
    std::vector<MeanOver> objective_weights_;
    std::vector<double> days_;   //!< days of each stage since emergence
    std::vector<double> times_;  //!< time of each stage over the season
    //! Places in quantities; transpiration only if leaves exchange water.
    std::vector<std::size_t> incident_, absorbed_, lai_, transpired_;
    std::vector<Summed> summed_;
    std::vector<ByStage> by_stage_;
    QuantitySet measured_;
};

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
        std::vector<std::size_t> begins;  //!< place in quantities, by scenario
    };

    void combine_objective(const std::vector<Outcome>& each,
                           std::size_t objective, Outcome& all) const;

    Across across_;
    std::vector<std::size_t> stages_;      //!< stages of each scenario
    std::vector<OverStages> over_stages_;  //!< by scenario, if plants grow
    std::vector<ObjectiveEntry> objectives_;
    QuantitySet measured_;
    std::vector<Shared> shared_;
};

}  // namespace ideotype
