// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "ideotype/canopy/quantities.hpp"

namespace ideotype {

//! Combines outcomes of growing plants at each stage to one of the season.
class OverStages {
  public:
    //! @param chosen case with stages
    OverStages(const Campaign& campaign, const Case& chosen);

    //! Returns the quantities of stages except those by hour, and some
    //! quantities by stage.
    const QuantitySet& measured() const { return measured_; }

    //! Combines outcomes of stages with the weights given by mean_over() of
    //! each quantity. Amounts are sums over stages, for a mean day of the
    //! season. Random numbers of stages are independent.
    //! @param outcomes a done outcome of each stage
    Outcome combine(std::span<const Outcome> each) const;

  private:
    std::vector<double> weights(MeanOver kind,
                                std::span<const Outcome> each) const;

    struct Summed {
        MeanOver kind;
        std::size_t size;
        std::vector<std::size_t>
            begins;  //!< first index in the quantities of each stage
        //! The index in the sum of each number of each stage.
        std::vector<std::vector<std::size_t>> places;
    };

    //! Adds a quantity, unless it is by hour or has different axes at each
    //! stage.
    void add(const Quantity& quantity, const std::vector<QuantitySet>& sets);

    struct ByStage {
        std::vector<std::size_t> begins;
        bool is_amount;
    };

    std::vector<ObjectiveEntry> objectives_;
    std::vector<MeanOver> objective_weights_;
    std::vector<double> days_;   //!< days of each stage since emergence
    std::vector<double> times_;  //!< time of each stage over the season
    //! Indices in quantities; transpiration only if leaves exchange water.
    std::vector<std::size_t> incident_, absorbed_, lai_, transpired_;
    std::vector<Summed> summed_;
    std::vector<ByStage> by_stage_;
    QuantitySet measured_;
};

//! Combines outcomes of a plant in all scenarios of a case, each over its
//! stages.
class AcrossScenarios {
  public:
    AcrossScenarios(const Campaign& campaign, const Case& chosen);

    //! Returns means over scenarios of quantities with equal axes in all
    //! scenarios (hours or days may differ), and each objective by scenario, as
    //! `absorbed_par_by_scenario`; for a single scenario, all quantities.
    const QuantitySet& measured() const { return measured_; }

    //! Combines the outcomes of all scenarios. Objectives are means, also by
    //! randomisation, so that their standard errors account for common random
    //! numbers of scenarios; or each objective is that of the worst scenario.
    //! The violation is the largest. Standard errors of other quantities are
    //! means, an upper bound.
    //! @param outcomes a done outcome of each of evaluated_cases()
    Outcome combine(const std::vector<Outcome>& each) const;

  private:
    Outcome combine_scenarios(const std::vector<Outcome>& each) const;

    //! A quantity averaged over scenarios.
    struct Shared {
        std::size_t size;
        std::vector<std::size_t>
            begins;  //!< first index in quantities, by scenario
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
