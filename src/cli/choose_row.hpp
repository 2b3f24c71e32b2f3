// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "campaign/campaign.hpp"
#include "commands.hpp"
#include "history/history.hpp"
#include "parallel/evaluator.hpp"

namespace ideotype {

//! A selected row of a history, with the data needed to recompute it.
struct ChosenRow {
    Campaign campaign;
    Case chosen;
    Task task;
    Row row;
    //! Values of campaign keys that were optimised along with the plant, in the
    //! form of --set.
    std::vector<std::string> keys;
    OutcomeSchema schema;  //!< schema of the row
    std::string isa;       //!< instruction set
};

//! Returns the best finalist, the best plant of the last generation if there
//! are no finalists yet, or the row of a generation and slot.
//! @param path path of a history
//! @throws Error (usage) if the choice is incomplete or out of range.
ChosenRow choose_row(const std::string& path, const RowChoice& choice);

//! Returns whether a path names a history, not a campaign.
bool is_history(const std::string& path);

}  // namespace ideotype
