// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "campaign/campaign.hpp"
#include "history/history.hpp"
#include "parallel/evaluator.hpp"
#include "verbs.hpp"

namespace ideotype {

//! A row that was asked for, with all that made it.
struct ChosenRow {
    Campaign campaign;
    Case chosen;
    Task task;
    Row row;
    //! Settings of the keys that were bred beside the plant, as words of --set.
    std::vector<std::string> keys;
    OutcomeSchema schema;  //!< schema of the row
    std::string isa;       //!< instruction set
};

//! Returns the best finalist, the best of the last generation if there are no
//! finalists yet, or the row of a generation and slot.
//! @param path of a history
//! @throws Error (usage) if the choice is incomplete or out of range.
ChosenRow choose_row(const std::string& path, const RowChoice& choice);

//! True for the name of a history, false for that of a campaign.
bool is_history(const std::string& path);

}  // namespace ideotype
