// SPDX-License-Identifier: Apache-2.0
#include "check_cases.hpp"

#include <fmt/format.h>

#include "history/history.hpp"
#include "run/provenance.hpp"
#include "run/run.hpp"

namespace ideotype {

void list_left(const Campaign& campaign, const std::string& out) {
    for (const Case& each : cases(campaign)) {
        const std::string path = path_of(out, campaign, each);
        std::uint64_t evaluated = 0;
        if (history_exists(path)) {
            const History history = History::read(path);
            require_same_campaign(history.header(), campaign, each, path);
            if (history.finished()) continue;
            evaluated = history.evaluated();
        }
        fmt::print("{}\t{}\n", each.index, evaluated);
    }
}

void list_cases(const Campaign& campaign) {
    fmt::print("{:>5}  {:<40}  {:>20}\n", "index", "case", "seed");
    for (const Case& each : cases(campaign))
        fmt::print("{:>5}  {:<40}  {:>20}\n", each.index, each.name, each.seed);
}

}  // namespace ideotype
