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
    const Quantity& objective = history.header().schema.objectives.front();
    const Estimate value = row.outcome.objectives.front();
    std::string text =
        objective.name == "absorbed_par"
            ? format_daily(value)
            : fmt::format("{} {}", format(value), objective.unit);
    text += fmt::format("\n            {} of the incident light, LAI {:.2f}",
                        format(diagnostic(history, row, "absorbed_fraction")),
                        diagnostic(history, row, "lai").mean);
    const double violation = diagnostic(history, row, "violation").mean;
    if (violation > 0)
        text += fmt::format("; FAILS ITS CONSTRAINTS by {:.3g}", violation);
    return text;
}

//! Plain absorption in an endless stand has a ceiling: a word of warning.
std::string left_to_gain(const History& history, const Campaign& campaign,
                         const Row& best) {
    if (campaign.objective != Objective::absorbed_par ||
        campaign.field.boundary != Boundary::periodic)
        return "";
    const Estimate stalks = diagnostic(history, best, "stalk_fraction");
    const Estimate soil = diagnostic(history, best, "soil_fraction");
    const Estimate left{stalks.mean + soil.mean,
                        std::hypot(stalks.standard_error, soil.standard_error)};
    const bool is_saturated =
        left.mean <=
        diagnostic(history, best, "absorbed_fraction").standard_error;
    return fmt::format(
        "  left      at most {} of the incident light{}\n", format(left),
        is_saturated ? ", within the standard error: leaves cannot take more, "
                       "and what evolved beyond is luck; see [objective] and "
                       "[constraints]"
                     : ", which stalks and soil take");
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
        "  gain      {} MJ m-2 day-1 = {} %\n{}",
        campaign.final_rule.sampling.randomisations,
        campaign.final_rule.sampling.paths, described(history, finalists[0]),
        described(history, finalists[best]), format(gain), format(percent),
        left_to_gain(history, campaign, finalists[best]));
}

}  // namespace ideotype
