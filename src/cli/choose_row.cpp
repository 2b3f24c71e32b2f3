// SPDX-License-Identifier: Apache-2.0
#include "choose_row.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "campaign/campaign.hpp"
#include "ideotype/core/text.hpp"
#include "run/summary.hpp"
#include "spec/problems.hpp"
#include "spec/reader.hpp"
#include "spec/varied_keys.hpp"

namespace ideotype {

namespace {

Case case_of(const History& history, const Campaign& campaign) {
    const std::string& name = history.header().text.at("case");
    if (const auto found = cases(campaign).find(name)) return *found;
    throw Error(
        fmt::format("the campaign in this history has no case {}", name));
}

Row best_row(const History& history, Task& task) {
    const std::vector<Row> finalists = history.finalists();
    if (const std::size_t best = best_finalist(history, finalists); best > 0) {
        task.is_final = true;
        task.slot = static_cast<std::uint32_t>(best);
        return finalists[best];
    }
    const auto summaries = history.summaries();
    if (summaries.empty())
        throw Error(
            "no generation of this history is complete yet; try again later");
    task.generation = static_cast<std::uint32_t>(summaries.size() - 1);
    task.slot = summaries.back().best_slot;
    return history.row(task.generation, task.slot);
}

Row row_of(const History& history, const RowChoice& choice, Task& task) {
    if (choice.is_best) return best_row(history, task);
    if (!choice.generation || !choice.slot)
        throw wrong_usage(
            "no plant of the history is selected; give --best, or --generation "
            "G --slot S");
    const HistoryHeader& header = history.header();
    const auto count = static_cast<std::uint32_t>(header.generations);
    if (*choice.generation >= count)
        throw wrong_usage(
            "there is no generation {}: this history has generations 0 to {}",
            *choice.generation, count - 1);
    const std::uint32_t slots = history.size(*choice.generation);
    if (slots > 0 && *choice.slot >= slots)
        throw wrong_usage(
            "there is no slot {}: generation {} has slots 0 to {}",
            *choice.slot, *choice.generation, slots - 1);
    task.generation = *choice.generation;
    task.slot = *choice.slot;
    Row row;
    if (slots > 0) row = history.row(task.generation, task.slot);
    if (row.candidate.origin == Origin::none)
        throw wrong_usage("generation {} slot {} has no plant yet",
                          task.generation, task.slot);
    return row;
}

}  // namespace

ChosenRow choose_row(const std::string& path, const RowChoice& choice) {
    const History history = History::read(path);
    const HistoryHeader& header = history.header();
    ChosenRow result;
    result.campaign = parse_history_campaign(header.campaign_resolved, path);
    if (const auto& keys = result.campaign.spec.passed_over; !keys.empty())
        fmt::print(stderr, "ideotype: warning: {}: {}\n", path,
                   printable(passed_over_text(keys)));
    result.chosen = case_of(history, result.campaign);
    result.task.case_index = static_cast<std::uint32_t>(result.chosen.index);
    result.row = row_of(history, choice, result.task);
    const std::vector<KeyFactor> keys = result.campaign.varied.keys;
    Genome& genome = result.row.candidate.genome;
    for (std::size_t i = 0; i < keys.size(); ++i)
        result.keys.push_back(fmt::format(
            "{}={}", keys[i].key,
            text_of(keys[i], genome[genome.size() - keys.size() + i])));
    result.campaign = at_keys(result.campaign, genome);
    result.chosen = case_of(history, result.campaign);
    result.schema =
        result.task.is_final ? header.final_schema() : header.schema;
    result.isa = header.text.at("isa");
    return result;
}

bool is_history(const std::string& path) {
    return std::filesystem::path(path).extension() == ".h5";
}

}  // namespace ideotype
