// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "campaign/campaign.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/stop_flag.hpp"
#include "log.hpp"
#include "parallel/dispatcher.hpp"
#include "parallel/session.hpp"
#include "run/job/machines.hpp"

namespace ideotype {

//! Returns the path at which `run` keeps the history of a case.
std::string path_of(const std::string& out, const Campaign& campaign,
                    const CaseName& chosen);

//! Prints the warnings about a campaign.
void print_warnings(const Campaign& campaign, const Log& log);

//! The facts that rank 0 tells all ranks before the work begins.
struct Start {
    std::string isa;       //!< instruction set
    std::string resolved;  //!< campaign
};

//! Lets rank 0 prepare the work of all ranks. Its exceptions are thrown on rank
//! 0; other ranks then get no instruction set, and leave. Collective.
Start agree(const Session& session, const std::function<Start()>& make);

//! Returns the rules by which a campaign waits for answers.
AnswerRules answer_rules(const Campaign& campaign);

//! `run CAMPAIGN`: evolves one case, or all of them in one job.
struct RunOptions {
    //! Reads the campaign, as a search or for other evaluations.
    Campaign (*read)(const std::string& path,
                     const std::vector<std::string>& settings) = read_campaign;
    std::string campaign_path;
    std::vector<std::string> settings;  //!< settings, "table.key=value"
    std::string start;  //!< plant or history at which CMA-ES begins; or ""
    std::optional<int> case_index;
    bool is_resumed = false;
    std::string out = "results";
    std::optional<double> wall_time;  //!< wall time of this start [s]
    std::optional<std::string> isa;   //!< instruction set to begin with
    std::optional<int> threads;       //!< threads, see threads_per_rank()
    std::optional<int> masters;  //!< ranks that evolve cases, see masters.hpp
    std::string command;         //!< command as typed, for the record
    std::string launcher;  //!< quoted words before the command; "": unknown
    LogLevel level = LogLevel::info;
};

//! Runs a campaign; collective over all ranks of the session.
//! @param own the machine of this rank
ExitCode run(const RunOptions& options, const Session& session, StopFlag& stop,
             const Machine& own = this_machine());

}  // namespace ideotype
