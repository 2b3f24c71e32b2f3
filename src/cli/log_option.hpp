// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include <CLI/CLI.hpp>

#include "run/log.hpp"

namespace ideotype {

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
