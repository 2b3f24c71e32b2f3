// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"

namespace ideotype {

//! The outcome of plants that grow, from outcomes at each stage.
class OverStages {
  public:
    //! @param chosen has stages
    OverStages(const Campaign& campaign, const Case& chosen);

    //! Returns the quantities of each stage but those by hour, and some of them
    //! by stage.
    const QuantitySet& measured() const { return measured_; }

    //! Amounts are sums over stages, on a mean day of the season. Fractions of
    //! light are means by incident light, the light-use efficiency by absorbed
    //! light, what is per leaf area and extinction by that, and all else by
    //! time. Stages have random numbers of their own.
    //! @param each a done outcome of each stage
    Outcome combine(std::span<const Outcome> each) const;

  private:
    //! The weights with which a number of a stage counts.
    enum class Weights {
        one,
        time,
        leaf_area,
        leaf_time,
        incident,
        absorbed,
        transpired
    };

    static Weights weights_of(const std::string& name, const std::string& unit);
    //! Returns the weight of each stage.
    std::vector<double> weights(Weights kind,
                                std::span<const Outcome> each) const;

    //! A quantity over stages.
    struct Summed {
        Weights kind;
        std::size_t size;
        std::vector<std::size_t> begins;  //!< in each stage's quantities
        //! The place of each number of each stage.
        std::vector<std::vector<std::size_t>> places;
    };

    //! Adds a quantity, unless it is by hour or of other places in each stage.
    void add(const Quantity& quantity, const std::vector<QuantitySet>& sets);

    //! A quantity of each stage.
    struct ByStage {
        std::vector<std::size_t> begins;
        bool is_amount;
    };

    std::vector<ObjectiveEntry> objectives_;
    std::vector<Weights> objective_weights_;
    std::vector<double> days_;   //!< days of each stage since emergence
    std::vector<double> times_;  //!< of each stage, over that of the season
    //! Places in quantities; transpiration only where leaves exchange water.
    std::vector<std::size_t> incident_, absorbed_, lai_, transpired_;
    std::vector<Summed> summed_;
    std::vector<ByStage> by_stage_;
    QuantitySet measured_;
};

}  // namespace ideotype
