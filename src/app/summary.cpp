#include "ideotype/app/summary.hpp"

#include <cmath>

#include <fmt/format.h>

#include "ideotype/app/progress.hpp"
#include "ideotype/core/units.hpp"

namespace ideotype {

std::string format_daily(Estimate mj_per_m2) {
    return fmt::format(
        "{} MJ m-2 day-1 = {} mol m-2 day-1 = {} MWh acre-1 day-1",
        format(mj_per_m2), format(scaled(mj_per_m2, mol_per_mj_par)),
        format(scaled(mj_per_m2, mwh_per_acre_per_mj_per_m2)));
}

std::size_t best_finalist(const std::vector<Row>& finalists) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < finalists.size(); ++i)
        if (finalists[i].outcome.status == Status::done &&
            (best == 0 || finalists[i].fitness > finalists[best].fitness))
            best = i;
    return best;
}

namespace {

Estimate diagnostic(const History& history, const Row& row,
                    const std::string& name) {
    const auto& columns = history.header().schema.diagnostics;
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (columns[i].name == name) return row.outcome.diagnostics[i];
    return {std::nan(""), std::nan("")};
}

std::string described(const History& history, const Row& row) {
    return fmt::format("{}\n            {} of the incident light, LAI {:.2f}",
                       format_daily(row.outcome.objectives.front()),
                       format(diagnostic(history, row, "absorbed_fraction")),
                       diagnostic(history, row, "lai").mean);
}

}  // namespace

std::string final_summary(const History& history, const Campaign& campaign) {
    const std::vector<Row> finalists = history.finalists();
    const std::size_t best = best_finalist(finalists);
    if (finalists.empty() || finalists[0].outcome.status != Status::done ||
        best == 0)
        return "no finalist could be evaluated; see the messages of failed "
               "rows\n";
    const Estimate a = finalists[0].outcome.objectives.front();
    const Estimate b = finalists[best].outcome.objectives.front();
    // Both share their random numbers, so these errors are, if anything, too
    // large.
    const Estimate gain{b.mean - a.mean,
                        std::hypot(a.standard_error, b.standard_error)};
    const double ratio = b.mean / a.mean;
    const Estimate percent{
        100 * (ratio - 1),
        100 / a.mean * std::hypot(ratio * a.standard_error, b.standard_error)};
    return fmt::format(
        "absorbed by leaves, {} of {} paths with a new field each:\n"
        "  baseline  {}\n"
        "  best      {}\n"
        "  gain      {} MJ m-2 day-1 = {} %\n",
        campaign.final_rule.sampling.randomisations,
        campaign.final_rule.sampling.paths, described(history, finalists[0]),
        described(history, finalists[best]), format(gain), format(percent));
}

}  // namespace ideotype
