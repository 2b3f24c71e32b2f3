// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/campaign/campaign.hpp"
#include "ideotype/cli/verbs.hpp"
#include "ideotype/history/history.hpp"
#include "ideotype/parallel/evaluator.hpp"

namespace ideotype {

//! A row that was asked for, with all that made it.
struct ChosenRow {
    Campaign campaign;
    Case chosen;
    Task task;
    Row row;
    OutcomeSchema schema;  //!< of the row
    std::string isa;       //!< instruction set
};

//! The best finalist, the best of the last generation if there are no
//! finalists yet, or the row of a generation and slot.
//! @param path of a history
//! @throws Error (usage) if the choice is incomplete or out of range.
ChosenRow choose_row(const std::string& path, const RowChoice& choice);

//! True for the name of a history, false for that of a campaign.
bool is_history(const std::string& path);

}  // namespace ideotype
