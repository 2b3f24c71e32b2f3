// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/options.hpp"
#include "cli/verbs.hpp"
#include "ideotype/core/clock.hpp"

namespace ideotype {

namespace {

double to_seconds(const std::string& text) {
    const auto seconds = parse_duration(text);
    if (seconds && *seconds > 0) return *seconds;
    throw CLI::ValidationError(
        "--wall-time", fmt::format("'{}' is no time; write for example 90, "
                                   "90s, 30m, 2h, 1h30m or 01:30:00",
                                   text));
}

}  // namespace

void declare_run(CLI::App& verb, RunOptions& options) {
    add_campaign(verb, options.campaign_path, options.settings);
    verb.add_option("--start", options.start,
                    "plant around which CMA-ES begins (search.start): a plant "
                    "file, or a history, whose best plant is taken");
    add_threads(verb, options.threads);
    verb.add_option("--masters", options.masters,
                    "number of ranks that evolve cases, each with workers of "
                    "its own; if not given, one for each 1,000 ranks, but no "
                    "more than there are cases")
        ->check(CLI::PositiveNumber);
    verb.add_option("--case", options.case_index,
                    "only the case of this index (see check --cases)");
    verb.add_flag("--resume", options.is_resumed,
                  "go on with histories that exist; start the others");
    verb.add_option("--out", options.out, "folder for <campaign>/<case>.h5")
        ->capture_default_str();
    verb.add_option("--isa", options.isa,
                    "instruction set to begin with, the same on all ranks; if "
                    "not given, that of a history that is resumed, or else "
                    "the widest that all ranks have")
        ->check(CLI::IsMember({"sse2", "sse4.2", "avx", "avx2", "avx512"}));
    add_log_level(verb, options.level);
    verb.add_option_function<std::string>(
        "--wall-time",
        [&](const std::string& text) { options.wall_time = to_seconds(text); },
        "time after which to stop cleanly: seconds, or for example 30m, "
        "1h30m, 01:30:00");
}

void declare_sensitivity(CLI::App& verb, RunOptions& options) {
    options.read = read_study;
    options.out = "results/sensitivity";
    declare_run(verb, options);
}

ExitCode start_run(const RunOptions& options) {
    StopFlag stop;
    const Session session = start_session();
    return on_ranks(session, Log(options.level),
                    [&] { return run(options, session, stop); });
}

}  // namespace ideotype
