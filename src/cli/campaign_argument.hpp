// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

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

//! Declares a campaign file and what is set in its place.
inline void add_campaign(CLI::App& verb, std::string& path,
                         std::vector<std::string>& settings) {
    verb.add_option("campaign", path, "campaign file (TOML)")->required();
    add_settings(verb, settings);
}

}  // namespace ideotype
