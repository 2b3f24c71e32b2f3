// SPDX-License-Identifier: Apache-2.0
#include "summary.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ideotype/core/units.hpp"
#include "progress.hpp"
#include "search/order.hpp"
#include "search/summary.hpp"

namespace ideotype {

std::string format_daily(Estimate mj_per_m2) {
    return fmt::format(
        "{} MJ m-2 day-1 = {} mol m-2 day-1 = {} MWh acre-1 day-1",
        format(mj_per_m2), format(scaled(mj_per_m2, mol_per_mj_par)),
        format(scaled(mj_per_m2, mwh_per_acre_per_mj_per_m2)));
}

std::size_t best_finalist(const std::vector<Row>& finalists, Sense sense) {
    Population population;
    for (const auto& [candidate, outcome, attempt] : finalists)
        population.push_back(
            {candidate, outcome.status, outcome.objectives, outcome.violation});
    std::size_t best = 0;
    for (std::size_t i = 1; i < finalists.size(); ++i)
        if (population[i].status == Status::done &&
            (best == 0 || is_better(population[i], population[best], sense)))
            best = i;
    return best;
}

std::size_t failed_finalists(const std::vector<Row>& finalists) {
    return static_cast<std::size_t>(
        std::ranges::count(finalists, Status::failed,
                           [](const Row& row) { return row.outcome.status; }));
}

std::string failures_of(const std::vector<Row>& finalists) {
    const auto first =
        std::ranges::find(finalists, Status::failed,
                          [](const Row& row) { return row.outcome.status; });
    if (first == finalists.end()) return "";
    return fmt::format("{} of {} finalists failed; the first reason: {}",
                       failed_finalists(finalists), finalists.size(),
                       first->outcome.message);
}

namespace {

Estimate quantity(const History& history, const Row& row,
                  const std::string& name) {
    const double nan = std::nan("");
    return find(history.header().schema, row.outcome, name)
        .value_or(Estimate{nan, nan});
}

double lai_of(const History& history, const Row& row) {
    return quantity(history, row, "lai").mean;
}

std::string described(const History& history, const Row& row) {
    const double violation = row.outcome.violation;
    return fmt::format(
        "{} {}{}", format(row.outcome.objectives.front()),
        history.header().schema.objectives.front().unit,
        violation > 0
            ? fmt::format("; FAILS ITS CONSTRAINTS by {:.3g}", violation)
            : "");
}

//! The mean of b - a over randomisations that both plants share, with units
//! and relative to a.
std::string gain(const Outcome& a, const Outcome& b, const std::string& unit) {
    const std::string found = format(difference(a, b)) + " " + unit;
    if (!(a.objectives.front().mean > 0)) return found;
    return fmt::format(
        "{} = {} %", found,
        format(relative_gain(randomisations_of(a), randomisations_of(b))));
}

std::string gain_line(const History& history, const Row& baseline,
                      const Row& best) {
    const Objective& objective = history.header().schema.objectives.front();
    return fmt::format("{}, with LAI {:.2f} instead of {:.2f}",
                       gain(baseline.outcome, best.outcome, objective.unit),
                       lai_of(history, best), lai_of(history, baseline));
}

//! A warning of plants that no field has so densely, or "".
std::string too_dense(const std::string& what, double lai) {
    const std::string doubt = doubt_of_lai(lai);
    return doubt.empty()
               ? ""
               : fmt::format(
                     "  warning   {} {}; limit [constraints] lai, or breed for "
                     "carbon_balance, in which leaf area has its price\n",
                     what, doubt);
}

//! Much of a gain may be leaf area, which therefore stands beside it.
std::string gains(const History& history, const Campaign& campaign,
                  const Row& baseline, const Row& best) {
    return fmt::format(
        "  gain      {}\n            {}\n{}",
        gain_line(history, baseline, best),
        campaign.replicates == 1
            ? one_seed
            : "how seeds differ is told by ideotype summary --gains, "
              "not by this interval",
        too_dense("the best plant", lai_of(history, best)));
}

//! Plain absorption in an endless stand has a ceiling: a word of warning.
std::string left_to_gain(const History& history, const Campaign& campaign,
                         const Row& best) {
    if (aims(campaign).front().quantity != "absorbed_par" ||
        !campaign.over.empty() || campaign.field.boundary != Boundary::periodic)
        return "";
    const Estimate stalks = quantity(history, best, "stalk_fraction");
    const Estimate soil = quantity(history, best, "soil_fraction");
    const Estimate left{stalks.mean + soil.mean,
                        std::hypot(stalks.standard_error, soil.standard_error)};
    const bool is_saturated =
        left.mean <=
        quantity(history, best, "absorbed_fraction").standard_error;
    return fmt::format(
        "  left      at most {} of the incident light{}\n", format(left),
        is_saturated ? ", within the standard error: leaves cannot take more, "
                       "and what evolved beyond is luck; see [objective] and "
                       "[constraints]"
                     : ", which other organs and soil take");
}

//! Every member of a front with its row in /final, which is its number
//! everywhere; which of them another dominates when all have been evaluated
//! again is told.
std::string front(const History& history, const Campaign& campaign,
                  const std::vector<Row>& finalists) {
    std::vector<Sense> senses;
    std::string text = "  plant";
    for (const Objective& each : history.header().schema.objectives) {
        senses.push_back(each.sense);
        text += fmt::format("  {:>28}", each.name + " [" + each.unit + "]");
    }
    Population members;
    for (const auto& [candidate, outcome, attempt] : finalists)
        members.push_back({candidate, outcome.status, outcome.objectives,
                           outcome.violation, outcome.randomisations});
    members.erase(members.begin());  // the baseline
    const std::vector<std::size_t> level = fronts(members, senses);
    std::size_t left = 0;
    for (std::size_t i = 0; i < members.size(); ++i) {
        text += fmt::format("\n  {:>5}", i + 1);
        for (const Estimate& each : members[i].objectives)
            text += fmt::format("  {:>28}", format(each));
        const bool is_in_front =
            level[i] == 0 && members[i].status == Status::done;
        if (is_in_front)
            ++left;
        else
            text += "  not in the front any more";
    }
    text += fmt::format("\n  {} of {} are still in the front\n", left,
                        members.size());
    std::vector<double> reference = campaign.search.reference;
    if (reference.empty()) reference = worst_of(history.generation(0), senses);
    if (!reference.empty())
        text += fmt::format("  hypervolume {}, relative to {:.6g}\n",
                            format(hypervolume(members, reference, senses)),
                            fmt::join(reference, ", "));
    double lai = 0;
    for (std::size_t i = 1; i < finalists.size(); ++i)
        lai = std::max(lai, lai_of(history, finalists[i]));
    return text + too_dense("a plant of the front", lai);
}

constexpr const char* only_the_baseline =
    "nothing but the baseline was evaluated again";

}  // namespace

std::string final_summary(const History& history, const Campaign& campaign) {
    const std::vector<Row> finalists = history.finalists();
    const auto& objectives = history.header().schema.objectives;
    const std::size_t best = best_finalist(finalists, objectives.front().sense);
    std::string failures = failures_of(finalists);
    if (!failures.empty()) failures += '\n';
    if (finalists.size() == 1) return failures + only_the_baseline + '\n';
    if (finalists.empty() || finalists[0].outcome.status != Status::done ||
        best == 0)
        return failures +
               "without the baseline and another finalist there is "
               "no gain\n";
    const Accuracy& sampling = campaign.final_rule.sampling;
    const std::string how =
        fmt::format("{} of {} paths with a new field each",
                    sampling.randomisations, sampling.paths);
    if (objectives.size() > 1)
        return failures + fmt::format("front, {}:\n{}", how,
                                      front(history, campaign, finalists));
    const std::string& name = objectives.front().name;
    return failures +
           fmt::format(
               "{}, {}:\n"
               "  baseline  {}\n"
               "  best      {}\n"
               "{}{}",
               name == "absorbed_par" ? "absorbed by leaves" : name, how,
               described(history, finalists[0]),
               described(history, finalists[best]),
               gains(history, campaign, finalists[0], finalists[best]),
               left_to_gain(history, campaign, finalists[best]));
}

std::string final_line(const History& history) {
    const std::vector<Row> finalists = history.finalists();
    const auto& objectives = history.header().schema.objectives;
    const std::size_t best = best_finalist(finalists, objectives.front().sense);
    if (finalists.size() == 1) return only_the_baseline;
    if (finalists.empty() || finalists[0].outcome.status != Status::done ||
        best == 0)
        return "no finalist could be evaluated";
    if (objectives.size() > 1)
        return fmt::format("front of {}", finalists.size() - 1);
    return "gain " + gain_line(history, finalists[0], finalists[best]);
}

}  // namespace ideotype
