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
    //! Makes an evaluator; the campaign must outlive it.
    //! @throws Error if the processor does not support the instruction set.
    CanopyEvaluator(const Campaign& campaign, const std::string& isa);

    const OutcomeSchema& schema(const Task& task) const override;
    Outcome evaluate(const Task& task, const Genome& genome) override;

  private:
    //! A case of the campaign with its stand, which is set up once for all
    //! candidates.
    struct Place {
        Place(const Campaign& campaign, const Case& one);

        const OutcomeSchema& schema(bool is_final) const {
            return is_final ? final_schema : usual_schema;
        }

        Case chosen;
        Stand stand;
        OutcomeSchema usual_schema, final_schema;
    };

    //! Returns the entry of a case, which is made on first use. The call is
    //! thread-safe, since masters read schemas while workers evaluate.
    Place& place(std::uint32_t index) const;

    const Campaign& campaign_;
    mutable std::mutex mutex_;  //!< protects places_
    mutable std::map<std::uint32_t, Place> places_;
    Device device_;
};

}  // namespace ideotype
