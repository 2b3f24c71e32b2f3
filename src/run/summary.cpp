// SPDX-License-Identifier: Apache-2.0
#include "summary.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "progress.hpp"
#include "search/order.hpp"
#include "search/shrinkage.hpp"
#include "spec/reader.hpp"

namespace ideotype {

std::size_t best_finalist(const History& history,
                          const std::vector<Row>& finalists) {
    const Sense sense = history.header().schema.objectives.front().sense;
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

namespace {

//! Returns a note on the stop rule that ended a case. A study with a complete
//! design gets no note.
std::string ended_by(const CaseResult& result) {
    const bool is_whole = result.is_study && result.reason == all_generations;
    return result.reason && !is_whole
               ? fmt::format(" (reached {})", in_words(*result.reason))
               : "";
}

Estimate quantity(const History& history, const Row& row,
                  const std::string& name) {
    const double nan = std::nan("");
    return find(history.header().schema, row.outcome, name)
        .value_or(Estimate{nan, nan});
}

double lai_of(const History& history, const Row& row) {
    return quantity(history, row, "lai").mean;
}

//! Formats the mean of b - a over common randomisations (a paired difference),
//! with its unit and relative to a.
std::string gain(const Outcome& a, const Outcome& b, const std::string& unit) {
    const std::string gain_text = with_unit(format(difference(a, b)), unit);
    if (!(a.objectives.front().mean > 0)) return gain_text;
    return fmt::format("{} = {} %", gain_text,
                       format(relative_gain(select_randomisations(a),
                                            select_randomisations(b))));
}

//! Formats the gain over the baseline and the leaf area indices of both plants,
//! since leaf area may explain much of a gain.
std::string gain_with_lai(const History& history, const Row& baseline,
                          const Row& best) {
    const Objective& objective = history.header().schema.objectives.front();
    return fmt::format("gain {}, LAI {:.2f} (baseline {:.2f})",
                       gain(baseline.outcome, best.outcome, objective.unit),
                       lai_of(history, best), lai_of(history, baseline));
}

//! Returns the values of varied keys in a plant's genome, such as ", with
//! field.row_pattern = [1, 3]"; "" if none is varied.
std::string varied_keys_of(const History& history, const Spec& spec,
                           const Genome& genome) {
    const GeneSpace& genes = history.header().genes;
    std::vector<std::string> texts;
    for (const KeyFactor& factor : spec.search.keys) {
        const auto gene = std::ranges::find(genes, factor.key, &Gene::name);
        if (gene == genes.end()) continue;
        const double value =
            genome.at(static_cast<std::size_t>(gene - genes.begin()));
        texts.push_back(fmt::format(
            "{} = {}", factor.key,
            gene->values.empty()
                ? with_unit(fmt::format("{:.4g}", value), gene->unit)
                : text_of(*gene, value)));
    }
    return texts.empty() ? ""
                         : fmt::format(", with {}", fmt::join(texts, ", "));
}

//! Returns a warning if the leaf area is unrealistic, else "".
std::string doubt_of(const std::string& subject, double lai) {
    const std::string doubt = doubt_of_lai(lai);
    return doubt.empty() ? ""
                         : fmt::format(
                               "{} {}; limit [constraints] lai, or maximise "
                               "carbon_balance, which includes the leaf "
                               "construction cost",
                               subject, doubt);
}

//! Returns the origin of a row of /evaluations.
Origin origin_of(const History& history, std::int64_t row) {
    std::uint32_t generation = 0;
    for (; row >= history.size(generation); ++generation)
        row -= history.size(generation);
    return history.row(generation, static_cast<std::uint32_t>(row))
        .candidate.origin;
}

//! Returns a text with the number of leaders of an atlas (MAP-Elites archive),
//! and how many of them were re-evaluated during the search; "" for other
//! searches.
//! @param leaders rows of the baseline, followed by those of finalists
std::string atlas_of(const History& history, const Spec& spec,
                     const std::vector<Row>& leaders) {
    if (spec.search.axes.empty()) return "";
    const auto confirmed =
        std::count_if(leaders.begin() + 1, leaders.end(), [&](const Row& row) {
            return origin_of(history, row.candidate.parents[0]) ==
                   Origin::elite;
        });
    return fmt::format(
        ", the best of {} kinds of plants, {} of them confirmed by "
        "re-evaluation during the search",
        leaders.size() - 1, confirmed);
}

void add_finalists(const History& history, const Spec& spec,
                   CaseResult& result) {
    const auto& objectives = history.header().schema.objectives;
    const std::vector<Row> finalists = history.finalists();
    result.finalists = finalists.size();
    for (const Row& row : finalists)
        if (row.outcome.status == Status::failed &&
            result.failed_finalists++ == 0)
            result.failure = row.outcome.message;
    const std::size_t best = best_finalist(history, finalists);
    if (best == 0 || !result.reason) return;
    result.is_evaluated_again = true;
    result.best = finalists[best].outcome.objectives.front();
    result.violation = finalists[best].outcome.violation;
    double lai = lai_of(history, finalists[best]);
    const bool has_front = objectives.size() > 1;
    if (has_front) {
        for (std::size_t i = 1; i < finalists.size(); ++i)
            lai = std::max(lai, lai_of(history, finalists[i]));
        result.gain =
            fmt::format("Pareto front of {} plants", finalists.size() - 1);
    } else if (finalists[0].outcome.status == Status::done) {
        result.gain =
            gain_with_lai(history, finalists[0], finalists[best]) +
            varied_keys_of(history, spec, finalists[best].candidate.genome) +
            atlas_of(history, spec, finalists);
    }
    if (!spec.is_study) {
        const Genome& plant = finalists[best].candidate.genome;
        result.at_bounds = genes_at_bounds(history.header().genes, plant);
        result.bounds.add(history.header().genes, plant);
    }
    result.doubt =
        doubt_of(has_front ? "a plant of the Pareto front" : "this plant", lai);
}

}  // namespace

CaseResult result_of(const History& history) {
    const HistoryHeader& header = history.header();
    CaseResult result;
    const Spec spec = read_resolved(header.campaign_resolved);
    result.is_study = spec.is_study;
    result.passed_over = spec.passed_over;
    result.replicates = spec.replicates;
    result.reason = history.finished();
    result.generations = header.generations;
    result.most_plants = header.rows();
    result.objective = header.schema.objectives.front().name;
    result.unit = header.schema.objectives.front().unit;
    const auto summaries = history.summaries();
    result.complete = static_cast<double>(summaries.size());
    result.plants = static_cast<double>(history.plants());
    for (const GenerationSummary& generation : summaries) {
        result.failures += generation.failures;
        result.evaluations += generation.evaluations;
    }
    add_finalists(history, spec, result);
    if (summaries.empty()) return result;
    const GenerationSummary& last = summaries.back();
    result.wall_time = last.wall_time;
    if (!std::isnan(last.hypervolume))
        result.hypervolume = {last.hypervolume,
                              last.hypervolume_standard_error};
    if (result.is_evaluated_again || result.is_study) return result;
    const auto generation = static_cast<std::uint32_t>(summaries.size() - 1);
    const Row best = history.row(generation, last.best_slot);
    if (best.outcome.status == Status::done)
        result.best = shrink(history.generation(generation), last.best_slot);
    result.violation = best.outcome.violation;
    result.doubt = doubt_of("this plant", lai_of(history, best));
    return result;
}

std::string to_text(const CaseResult& result, const std::string& path,
                    const std::string& state) {
    std::string line =
        fmt::format("{}: {}{}, {} of {} plants in {} generation{}", path, state,
                    ended_by(result), result.plants, result.most_plants,
                    result.complete, result.complete == 1 ? "" : "s");
    if (result.best)
        line += fmt::format(
            ", best {}{} {}", result.is_evaluated_again ? "" : "about ",
            with_unit(format(*result.best), result.unit),
            certainty(result.is_evaluated_again, result.violation));
    if (!result.gain.empty()) line += ", " + result.gain;
    if (result.complete > 0)
        line +=
            fmt::format(", {} evaluations in {}, {} failed", result.evaluations,
                        format_duration(result.wall_time), result.failures);
    if (result.failed_finalists > 0)
        line += fmt::format(", {} of {} finalists failed ({})",
                            result.failed_finalists, result.finalists,
                            result.failure);
    if (result.hypervolume)
        line += fmt::format(", hypervolume {}", format(*result.hypervolume));
    return line + (result.doubt.empty() ? "" : "; " + result.doubt);
}

std::string in_short(const CaseResult& result, const std::string& name) {
    return fmt::format(
        "{}: finished{}{}{}", name, ended_by(result),
        result.gain.empty() ? "" : ", " + result.gain,
        result.failed_finalists > 0
            ? fmt::format(", {} of {} finalists failed",
                          result.failed_finalists, result.finalists)
            : "");
}

std::string left_to_gain(const History& history, const Campaign& campaign) {
    const std::vector<Row> finalists = history.finalists();
    const std::size_t best = best_finalist(history, finalists);
    if (best == 0 || objectives_of(campaign).size() > 1 ||
        objectives_of(campaign).front().name != "absorbed_par" ||
        !component_weights(campaign).empty() ||
        !campaign.spec.objective.over.empty() ||
        campaign.spec.field.boundary != Boundary::periodic)
        return "";
    const auto part = [&](const char* name) {
        return quantity(history, finalists[best], name);
    };
    const Estimate stalks = part("stalk_fraction"),
                   soil = part("soil_fraction");
    const Estimate left{stalks.mean + soil.mean,
                        std::hypot(stalks.standard_error, soil.standard_error)};
    const bool is_saturated =
        left.mean <= normal_95 * part("absorbed_fraction").standard_error;
    return fmt::format(
        "\nat most {} of the incident light remains to be gained{}",
        format(left),
        is_saturated
            ? ", which is within the error: leaves cannot absorb more, and "
              "further gains are noise; see [objective] and [constraints]"
            : ": other organs and the soil absorb it");
}

}  // namespace ideotype
