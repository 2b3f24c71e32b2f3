// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "campaign/campaign.hpp"
#include "commands.hpp"
#include "history/history.hpp"
#include "parallel/evaluator.hpp"

namespace ideotype {

//! A selected row of a history, with the data that are needed to recompute it.
struct ChosenRow {
    Campaign campaign;
    Case chosen;
    Task task;
    Row row;
    //! Values of campaign keys that were optimised together with the plant, as
    //! settings for --set.
    std::vector<std::string> keys;
    OutcomeSchema schema;  //!< schema of the row
    std::string isa;       //!< instruction set
};

//! Returns a row of a history: the row of a generation and slot or, if the best
//! is requested, the best finalist. If there are no finalists yet, the best is
//! the best plant of the last generation.
//! @param path path of a history
//! @throws Error (usage) if the choice is incomplete or out of range.
ChosenRow choose_row(const std::string& path, const RowChoice& choice);

//! Returns whether a path leads to a history, not a campaign.
bool is_history(const std::string& path);

}  // namespace ideotype
