// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "ideotype/canopy/quantities.hpp"

namespace ideotype {

//! Combines outcomes at the stages of growing plants into one outcome for the
//! season.
class OverStages {
  public:
    //! @param chosen case that contains the stages
    OverStages(const Campaign& campaign, const Case& chosen);

    //! Returns the quantities of the stages except those by hour, and selected
    //! quantities by stage.
    const QuantitySet& measured() const { return measured_; }

    //! Combines outcomes of stages, weighting each quantity as mean_over()
    //! specifies. Amounts are sums over stages, for a mean day of the season.
    //! Stages use independent random numbers.
    //! @param outcomes one completed outcome per stage
    Outcome combine(std::span<const Outcome> each) const;

  private:
    std::vector<double> weights(MeanOver kind,
                                std::span<const Outcome> each) const;

    struct Summed {
        MeanOver kind;
        std::size_t size;
        std::vector<std::size_t>
            begins;  //!< index of the first value, by stage
        //! For each value of each stage, its index in the sum.
        std::vector<std::vector<std::size_t>> places;
    };

    //! Adds a quantity, unless it is by hour or its axes differ between stages.
    void add(const Quantity& quantity, const std::vector<QuantitySet>& sets);

    struct ByStage {
        std::vector<std::size_t> begins;
        bool is_amount;
    };

    std::vector<ObjectiveEntry> objectives_;
    std::vector<MeanOver> objective_weights_;
    std::vector<double> days_;   //!< days of each stage since emergence
    std::vector<double> times_;  //!< fraction of the season, by stage
    //! Indices of quantities; transpiration only if leaves exchange water.
    std::vector<std::size_t> incident_, absorbed_, lai_, transpired_;
    std::vector<Summed> summed_;
    std::vector<ByStage> by_stage_;
    QuantitySet measured_;
};

//! Combines the outcomes of a plant in all scenarios of a case, each combined
//! over its stages.
class AcrossScenarios {
  public:
    AcrossScenarios(const Campaign& campaign, const Case& chosen);

    //! Returns means over scenarios of the quantities with the same axes in all
    //! scenarios (hours or days may differ). Each objective is also returned by
    //! scenario, for example as `absorbed_par_by_scenario`. For a single
    //! scenario, returns all its quantities.
    const QuantitySet& measured() const { return measured_; }

    //! Combines the outcomes of all scenarios. Objectives are weighted means,
    //! also by randomisation, so that their standard errors account for common
    //! random numbers of scenarios. A quantile, or the mean of the worst
    //! scenarios (conditional value at risk, Rockafellar and Uryasev 2000,
    //! doi:10.21314/JOR.2000.038), is the mean with weights that follow from
    //! the order of scenarios; a probability is the weight of scenarios at or
    //! above the threshold, a mean over randomisations. The violation is the
    //! largest of all scenarios. Standard errors of other quantities are
    //! averaged, which gives an upper bound.
    //! @param outcomes one completed outcome for each of evaluated_cases()
    Outcome combine(const std::vector<Outcome>& each) const;

  private:
    Outcome combine_scenarios(const std::vector<Outcome>& each) const;

    //! A quantity averaged over scenarios.
    struct Shared {
        std::size_t size;
        std::vector<std::size_t>
            begins;  //!< index of the first value, by scenario
    };

    void combine_objective(const std::vector<Outcome>& each,
                           std::size_t objective, Outcome& all) const;

    //! Returns the weights of scenarios in an objective. Empty: all are equal.
    std::vector<double> weights(const std::vector<Outcome>& each,
                                std::size_t objective) const;

    ObjectiveSpec rule_;
    //! Weights of scenarios, with a sum of 1. Empty: all are equal.
    std::vector<double> weights_;
    std::vector<std::size_t> stages_;  //!< number of stages of each scenario
    //! Combination by scenario, if plants grow.
    std::vector<OverStages> over_stages_;
    std::vector<ObjectiveEntry> objectives_;
    QuantitySet measured_;
    std::vector<Shared> shared_;
    //! Index of each further quantity by scenario, in each scenario.
    std::vector<std::vector<std::size_t>> by_scenario_;
};

}  // namespace ideotype
