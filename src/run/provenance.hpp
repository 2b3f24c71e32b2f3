// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "campaign/campaign.hpp"
#include "history/history.hpp"

namespace ideotype {

//! Returns the header of the history of a case, with its provenance.
HistoryHeader header_of(const Campaign& campaign, const Case& chosen,
                        const std::string& isa);

//! Refuses a history of another case, or of a campaign that differs in anything
//! that affects the case. The campaign may contain additional cases.
//! @throws Error (refused) that names each difference.
void require_same_campaign(const HistoryHeader& header,
                           const Campaign& campaign, const Case& chosen,
                           const std::string& path);

//! Refuses to resume a history if another campaign, case, program, compiler,
//! ray tracer or C library was used to write it.
//! @throws Error (refused) that names each difference.
void require_resumable(const HistoryHeader& header, const Campaign& campaign,
                       const Case& chosen, const std::string& path);

//! Returns the record of this start of the program.
SessionRecord session_record(const std::string& command, int ranks);

//! Returns the text of --version.
std::string version_text();

}  // namespace ideotype
