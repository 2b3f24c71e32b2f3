// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "ranks.hpp"

namespace ideotype {

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

}  // namespace ideotype
