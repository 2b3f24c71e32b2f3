// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "ideotype/campaign/campaign.hpp"
#include "ideotype/history/history.hpp"

namespace ideotype {

//! What the history of a sensitivity study tells: of its factors, for the
//! objectives and then for all other quantities that are single numbers.
SensitivityForm sensitivity_form(const Campaign& campaign, const Case& chosen,
                                 const OutcomeSchema& schema);

//! Computes it from all rows, and stores it. Then it also has
//! lacking_samples() as a message.
void record_sensitivity(const Campaign& campaign, const Case& chosen,
                        History& history);

//! What failed rows make unknown; "" if nothing.
std::string lacking_samples(const std::vector<QuantitySensitivity>& found,
                            std::size_t samples);

//! Of one quantity as a table, the factors that matter most first.
std::string sensitivity_text(const SensitivityForm& form,
                             const std::vector<QuantitySensitivity>& found,
                             std::size_t quantity);

}  // namespace ideotype
