// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "ranks.hpp"
#include "run/log.hpp"

namespace ideotype {

//! Declares `--set KEY=VALUE`, any number of times.
inline CLI::Option* add_settings(CLI::App& verb,
                                 std::vector<std::string>& settings) {
    return verb
        .add_option("--set", settings,
                    "a key of the campaign and its value, in the place of what "
                    "the file says: search.optimizer=random; may be repeated")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
}

//! Declares a campaign file and the settings that replace its values.
inline void add_campaign(CLI::App& verb, std::string& path,
                         std::vector<std::string>& settings) {
    verb.add_option("campaign", path, "campaign file (TOML)")->required();
    add_settings(verb, settings);
}

//! Declares --threads.
inline void add_threads(CLI::App& verb, std::optional<int>& threads) {
    verb.add_option_function<std::string>(
            "--threads",
            [&](const std::string& text) { threads = parse_threads(text); },
            "threads that evaluate, or auto: as many as this process may use "
            "cores; if not given auto, and under mpirun or srun one on each "
            "rank")
        ->type_name("N|auto");
}

//! Declares --quiet and --log-level.
inline void add_log_level(CLI::App& verb, LogLevel& level) {
    static const std::map<std::string, LogLevel> levels{
        {"error", LogLevel::error},
        {"warning", LogLevel::warning},
        {"info", LogLevel::info},
        {"debug", LogLevel::debug}};
    auto* option =
        verb.add_option_function<std::string>(
                "--log-level",
                [&level](const std::string& name) { level = levels.at(name); },
                "what is told of the work: errors, also warnings, also how "
                "far it is (if not given), also each evaluation")
            ->check(CLI::IsMember({"error", "warning", "info", "debug"}))
            ->type_name("LEVEL");
    verb.add_flag_callback(
            "--quiet", [&level] { level = LogLevel::warning; },
            "--log-level warning: results are still printed")
        ->excludes(option);
}

}  // namespace ideotype
