#pragma once

#include "ideotype/app/verbs.hpp"
#include "ideotype/campaign/campaign.hpp"
#include "ideotype/history/history.hpp"

namespace ideotype {

//! A row that was asked for and the task that made it.
struct ChosenRow {
    Task task;
    Row row;
};

//! The best finalist, the best of the last generation if there are no
//! finalists yet, or the row of a generation and slot.
//! @throws Error (usage) if the choice is incomplete or out of range.
ChosenRow choose_row(const History& history, const RowChoice& choice,
                     const Case& chosen);

//! The case of a campaign that a history belongs to.
Case case_of(const History& history, const Campaign& campaign);

//! True for the name of a history, false for that of a campaign.
bool is_history(const std::string& path);

}  // namespace ideotype
