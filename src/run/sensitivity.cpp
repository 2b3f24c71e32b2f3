// SPDX-License-Identifier: Apache-2.0
#include "ideotype/run/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "ideotype/run/evolve_case.hpp"
#include "ideotype/search/sensitivity_design.hpp"

namespace ideotype {

namespace {

SensitivityDesign design_of(const Campaign& campaign, const Case& chosen) {
    return {campaign.search.sensitivity, search_space(campaign, chosen),
            chosen.seed};
}

//! Where the quantities of a form are in an outcome.
struct Place {
    bool is_objective;
    std::size_t at;
};

std::vector<Place> places(const OutcomeSchema& schema,
                          const SensitivityForm& form) {
    std::vector<Place> found;
    for (std::size_t i = 0; i < form.quantities.size(); ++i) {
        const bool is_objective = i < schema.objectives.size();
        found.push_back(
            {is_objective,
             is_objective ? i : schema.measured.offset(form.quantities[i])});
    }
    return found;
}

//! With the interval in which it is with a probability of 95 %, and as many
//! digits as that allows.
std::string with_interval(const Estimate& x) {
    if (!std::isfinite(x.mean) || !std::isfinite(x.standard_error)) return "-";
    const double half = 1.96 * x.standard_error;
    constexpr int most = 4;
    const int digits =
        half > 0 ? 1 - static_cast<int>(std::floor(std::log10(half))) : most;
    return fmt::format("{:.{}f} ({:.{}f} .. {:.{}f})", x.mean,
                       std::clamp(digits, 0, most), x.mean - half,
                       std::clamp(digits, 0, most), x.mean + half,
                       std::clamp(digits, 0, most));
}

}  // namespace

SensitivityForm sensitivity_form(const Campaign& campaign, const Case& chosen,
                                 const OutcomeSchema& schema) {
    SensitivityForm form;
    form.method = campaign.search.sensitivity.method;
    for (const Factor& each : factors_of(search_genes(campaign, chosen),
                                         campaign.search.sensitivity.groups))
        form.factors.push_back(each.name);
    const auto add = [&](const std::string& name, const std::string& unit) {
        if (std::ranges::count(form.quantities, name) > 0) return;
        form.quantities.push_back(name);
        form.units.push_back(unit);
    };
    for (const Objective& each : schema.objectives) add(each.name, each.unit);
    for (const Quantity& each : schema.measured.quantities)
        if (each.axes.empty()) add(each.name, each.unit);
    return form;
}

std::string lacking_samples(const std::vector<QuantitySensitivity>& found,
                            std::size_t samples) {
    const std::size_t known = found.front().samples;
    return known == samples
               ? ""
               : fmt::format(
                     "{} of {} samples have rows that failed; the indices are "
                     "from the others",
                     samples - known, samples);
}

void record_sensitivity(const Campaign& campaign, const Case& chosen,
                        History& history) {
    const SensitivityForm& form = *history.header().sensitivity;
    const std::vector<Place> places =
        ideotype::places(history.header().schema, form);
    std::vector<std::vector<Estimate>> values(places.size());
    for (std::uint32_t g = 0; g < history.next_generation(); ++g)
        for (const Row& row : history.rows(g))
            for (std::size_t i = 0; i < places.size(); ++i)
                values[i].push_back(places[i].is_objective
                                        ? row.outcome.objectives[places[i].at]
                                        : row.outcome.quantities[places[i].at]);
    const SensitivityDesign design = design_of(campaign, chosen);
    std::vector<QuantitySensitivity> found;
    for (const std::vector<Estimate>& each : values)
        found.push_back(analyse(design, each));
    const std::string lacking = lacking_samples(found, design.samples());
    if (!lacking.empty()) history.message(lacking);
    history.record_sensitivity(found);
}

std::string sensitivity_text(const SensitivityForm& form,
                             const std::vector<QuantitySensitivity>& found,
                             std::size_t quantity) {
    const QuantitySensitivity& one = found.at(quantity);
    const auto indices = sensitivity_indices(form.method);
    std::string text = fmt::format(
        "{} [{}]: mean {:.6g}, standard deviation {:.3g} (without that of "
        "noise, {:.2g}); {} samples, 95 % intervals\n  {:<32}",
        form.quantities[quantity], form.units[quantity], one.mean,
        one.standard_deviation, one.noise, one.samples, "factor");
    for (const SensitivityIndex& each : indices)
        text += fmt::format("{:>28}", each.name);
    // By the total index, or mu_star.
    constexpr std::size_t main = 1;
    std::vector<std::size_t> order(form.factors.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto rank = [&](std::size_t factor) {
        const double value = one.indices[main][factor].mean;
        return std::isnan(value) ? 0 : -value;
    };
    std::ranges::stable_sort(order, {}, rank);
    for (const std::size_t factor : order) {
        text += fmt::format("\n  {:<32}", form.factors[factor]);
        for (const std::vector<Estimate>& index : one.indices)
            text += fmt::format("{:>28}", with_interval(index[factor]));
    }
    return text + "\n";
}

}  // namespace ideotype
