// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>

#include "ideotype/light/device.hpp"
#include "parallel/evaluator.hpp"
#include "stand/stand.hpp"

namespace ideotype {

//! Evaluates candidates of all cases of a campaign.
class CanopyEvaluator : public Evaluator {
  public:
    //! Makes the evaluator, which the campaign must outlive.
    //! @throws Error if the processor lacks the instruction set.
    CanopyEvaluator(const Campaign& campaign, const std::string& isa);

    const OutcomeSchema& schema(const Task& task) const override;
    Outcome evaluate(const Task& task, const Genome& genome) override;

  private:
    //! A case of the campaign, set up once for all its candidates.
    struct Place {
        Place(const Campaign& campaign, const Case& one)
            : chosen(one), stand(campaign, one) {}

        Case chosen;
        Stand stand;
    };

    //! Returns a place by the index of its case, made when first asked for.
    //! Several threads may ask, since masters ask for schemas.
    Place& place(std::uint32_t index) const;

    const Campaign& campaign_;
    mutable std::mutex mutex_;  //!< guards places
    mutable std::map<std::uint32_t, Place> places_;
    Device device_;
};

}  // namespace ideotype
