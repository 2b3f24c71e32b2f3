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

//! Returns where `run` keeps the history of a case.
std::string path_of(const std::string& out, const Campaign& campaign,
                    const Case& chosen);

//! Tells what may be wrong with a campaign.
void print_warnings(const Campaign& campaign, const Log& log);

//! The facts that rank 0 tells the others before the work begins.
struct Start {
    std::string isa;       //!< instruction set
    std::string resolved;  //!< campaign
};

//! Lets rank 0 prepare the work of all ranks. What it throws is thrown there;
//! the others then get no instruction set, and leave. Collective.
Start agree(const Session& session, const std::function<Start()>& make);

//! Returns how long a campaign waits for answers.
AnswerRules answer_rules(const Campaign& campaign);

//! `run CAMPAIGN`: evolves one case, or all of them in one job.
struct RunOptions {
    //! Reads the campaign: as a search, or as what is evaluated otherwise.
    Campaign (*read)(const std::string& path,
                     const std::vector<std::string>& settings) = read_campaign;
    std::string campaign_path;
    std::vector<std::string> settings;  //!< "table.key=value"
    std::string start;  //!< plant or history that CMA-ES begins around; or ""
    std::optional<int> case_index;
    bool is_resumed = false;
    std::string out = "results";
    std::optional<double> wall_time;  //!< wall time of this start [s]
    std::optional<std::string> isa;   //!< instruction set to begin with
    std::optional<int> threads;       //!< see threads_per_rank()
    std::optional<int> masters;  //!< ranks that evolve cases, see masters.hpp
    std::string command;         //!< as typed, for the record
    LogLevel level = LogLevel::info;
};

//! Collective over all ranks of the session.
//! @param own what this rank computes with
ExitCode run(const RunOptions& options, const Session& session, StopFlag& stop,
             const Machine& own = this_machine());

}  // namespace ideotype
