// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "extremes.hpp"
#include "light_report.hpp"

namespace ideotype {

void report_extremes() {
    const std::vector<ExtremeCase> all = extreme_cases();
    fmt::print(
        "\n## Extremes\n\nDoes the engine hold at the limits of suns, fields, "
        "surfaces, days and paths? **{} cases**; the energy\nbalance is the "
        "largest relative error in any randomisation.\n\n| case | expectation "
        "| energy balance | result |\n|---|---|---|---|\n",
        all.size());
    for (const ExtremeCase& extreme : all) {
        Findings findings;
        extreme.run(findings);
        const std::string balance =
            findings.traces() > 0
                ? fmt::format("{:.1e}", findings.balance_error())
                : "-";
        std::string result = findings.result();
        if (!findings.failures().empty())
            result = "FAILED: " + findings.failures().front();
        fmt::print("| {} | {} | {} | {} |\n", extreme.name, extreme.expectation,
                   balance, result);
        std::fflush(stdout);
    }
}

}  // namespace ideotype
