#include "ideotype/run/summary.hpp"

#include <cmath>

#include <fmt/format.h>

#include "ideotype/core/units.hpp"
#include "ideotype/run/progress.hpp"

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

double lai_of(const History& history, const Row& row) {
    return diagnostic(history, row, "lai").mean;
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
                        lai_of(history, row));
    const double violation = diagnostic(history, row, "violation").mean;
    if (violation > 0)
        text += fmt::format("; FAILS ITS CONSTRAINTS by {:.3g}", violation);
    return text;
}

//! " = 23.1 +- 0.2 %", or nothing relative to no light.
std::string percent(Estimate before, Estimate after) {
    if (!(before.mean > 0)) return "";
    const double ratio = after.mean / before.mean;
    return fmt::format(
        " = {} %",
        format({100 * (ratio - 1), 100 / before.mean *
                                       std::hypot(ratio * before.standard_error,
                                                  after.standard_error)}));
}

//! Both plants share their random numbers, so these errors are, if anything,
//! too large.
std::string gain(Estimate before, Estimate after) {
    return format({after.mean - before.mean,
                   std::hypot(before.standard_error, after.standard_error)}) +
           " MJ m-2 day-1" + percent(before, after);
}

//! Much of a gain may be leaf area: it stands beside it, and the gain that is
//! left of it per leaf area.
std::string gains(const History& history, const Row& baseline,
                  const Row& best) {
    const Estimate before = baseline.outcome.objectives.front();
    const Estimate after = best.outcome.objectives.front();
    const double lai_before = lai_of(history, baseline);
    const double lai_after = lai_of(history, best);
    std::string text =
        fmt::format("  gain      {}, with LAI {:.2f} instead of {:.2f}\n",
                    gain(before, after), lai_after, lai_before);
    const bool is_per_ground =
        history.header().schema.objectives.front().name == "absorbed_par";
    if (is_per_ground && lai_before > 0 && lai_after > 0)
        text += fmt::format(
            "            {} per leaf area\n",
            gain(scaled(before, 1 / lai_before), scaled(after, 1 / lai_after)));
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
    return fmt::format(
        "absorbed by leaves, {} of {} paths with a new field each:\n"
        "  baseline  {}\n"
        "  best      {}\n"
        "{}{}",
        campaign.final_rule.sampling.randomisations,
        campaign.final_rule.sampling.paths, described(history, finalists[0]),
        described(history, finalists[best]),
        gains(history, finalists[0], finalists[best]),
        left_to_gain(history, campaign, finalists[best]));
}

}  // namespace ideotype
