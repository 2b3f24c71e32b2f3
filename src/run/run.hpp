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

//! Returns the path of a case's history.
std::string path_of(const std::string& out, const Campaign& campaign,
                    const CaseName& chosen);

//! Prints the warnings about a campaign.
void print_warnings(const Campaign& campaign, const Log& log);

//! Data that rank 0 broadcasts before the work begins.
struct Start {
    std::string isa;       //!< instruction set
    std::string resolved;  //!< campaign
};

//! Runs `make` on rank 0 and broadcasts its result. If `make` throws, rank 0
//! throws the exception, and other ranks receive an empty instruction set,
//! after which they end. Collective.
Start agree(const Session& session, const std::function<Start()>& make);

//! Returns the rules that limit the time to wait for answers of workers.
AnswerRules answer_rules(const Campaign& campaign);

//! `run CAMPAIGN`: evolves one case, or all cases in one job.
struct RunOptions {
    //! Reads the campaign, for a search or a sensitivity study.
    Campaign (*read)(const std::string& path,
                     const std::vector<std::string>& settings) = read_campaign;
    std::string campaign_path;
    std::vector<std::string> settings;  //!< settings, "table.key=value"
    std::string start;  //!< plant or history with which CMA-ES starts, or ""
    std::optional<int> case_index;
    bool is_resumed = false;
    std::string out = "results";
    std::optional<double> wall_time;  //!< limit of this start's wall time [s]
    std::optional<std::string> isa;   //!< instruction set of new histories
    std::optional<int> threads;       //!< threads, see threads_per_rank()
    std::optional<int> masters;       //!< number of masters, see masters.hpp
    std::string command;              //!< command as typed, for the history
    std::string launcher;  //!< quoted words before the command; "": unknown
    LogLevel level = LogLevel::info;
};

//! Runs a campaign. Collective over all ranks of the session.
//! @param machine machine of this rank
ExitCode run(const RunOptions& options, const Session& session, StopFlag& stop,
             const Machine& machine = this_machine());

}  // namespace ideotype
