// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ideotype/cli/verbs.hpp"
#include "ideotype/history/history.hpp"
#include "ideotype/light/device.hpp"
#include "ideotype/light/scene.hpp"
#include "ideotype/run/disk.hpp"
#include "ideotype/run/evaluator.hpp"
#include "ideotype/run/progress.hpp"
#include "ideotype/run/run.hpp"
#include "ideotype/run/sky_table.hpp"

namespace ideotype {

namespace {

//! Seconds that evaluations of a case take here on one core.
struct EvaluationCost {
    double usual = 0;  //!< on average over the generations
    double final = 0;
};

//! Measured on the baseline; the quickest of a few, since the first warms up
//! and others may use the core too.
EvaluationCost measure_cost(const Campaign& campaign, const Case& chosen) {
    CanopyEvaluator evaluator(campaign, Device::supported_isas().back());
    const auto measure = [&](int times, Task task) {
        task.case_index = static_cast<std::uint32_t>(chosen.index);
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < times; ++i) {
            const double began = now();
            evaluator.evaluate(task, baseline_numbers(campaign.crop));
            least = std::min(least, now() - began);
        }
        return least;
    };
    // A tolerance may change from generation to generation.
    constexpr int samples = 5;
    EvaluationCost cost;
    for (int i = 0; i < samples; ++i) {
        Task task;
        task.generation = static_cast<std::uint32_t>(
            i * (campaign.stop.generations - 1) / (samples - 1));
        cost.usual += measure(2, task) / samples;
    }
    Task final;
    final.is_final = true;
    cost.final = measure(1, final);
    return cost;
}

//! What a campaign costs if no stop rule ends it early.
class Cost {
  public:
    Cost(const Campaign& campaign, const EvaluationCost& seconds)
        : seconds_(seconds),
          population_(campaign.search.population),
          generations_(campaign.stop.generations),
          finalists_(1 + campaign.final_rule.candidates) {}

    //! Of one case [s]: the slowest worker of a generation counts.
    double of_case(int workers) const {
        const int rounds = (population_ + workers - 1) / workers;
        const int final_rounds = (finalists_ + workers - 1) / workers;
        return seconds_.usual * static_cast<double>(generations_) * rounds +
               seconds_.final * final_rounds;
    }

    //! Of cases that share a job [s]: they fill each other's gaps.
    double of_cases(std::size_t cases, int workers) const {
        const double all = static_cast<double>(cases) * of_case(1) / workers;
        return std::max(all, of_case(workers));
    }

    std::string text() const {
        return fmt::format(
            "{} x {} evaluations of {:.1f} ms and the finalists: {} on one "
            "core",
            generations_, population_, seconds_.usual * 1e3,
            format_duration(of_case(1)));
    }

  private:
    EvaluationCost seconds_;
    int population_;
    int generations_;
    int finalists_;
};

//! Of several scenarios, a line.
std::string scenario_text(const Campaign& campaign, const Case& chosen) {
    if (chosen.scenarios.empty()) return "";
    const AcrossScenarios across(campaign, chosen);
    const Axis& axis = across.measured().axis("scenario");
    return fmt::format(
        "scenarios each evaluation is of {} ({}); an objective is {}\n",
        axis.size(),
        fmt::join(std::get<std::vector<std::string>>(axis.coordinates), ", "),
        campaign.across == Across::mean ? "their mean"
                                        : "that of the worst one");
}

ExitCode list_left(const PlanOptions& options, const Campaign& campaign) {
    for (const Case& each : cases(campaign)) {
        const std::string path = path_of(options.out, campaign, each);
        std::uint64_t evaluated = 0;
        if (history_exists(path)) {
            const History history = History::read(path);
            if (history.finished()) continue;
            evaluated = history.evaluated();
        }
        fmt::print("{}\t{}\n", each.index, evaluated);
    }
    return ExitCode::ok;
}

}  // namespace

ExitCode check(const CheckOptions& options) {
    const Campaign campaign =
        read_campaign(options.campaign_path, options.settings);
    print_warnings(campaign);
    const std::vector<Case> all = cases(campaign);
    require_names_fit(campaign, all, options.out);
    const Case& first = all.front();
    const Genome baseline = baseline_numbers(campaign.crop);
    const Scenario scenario = scenario_of(campaign, first);
    const Mesh plant =
        build_plant(campaign.crop.baseline, campaign.tessellation);
    const LightSeries& light = scenario.light.series;
    const Field field =
        draw_field(plant, scenario.field, randomness_of({}, campaign, first));
    const Cost cost(campaign, measure_cost(campaign, first));
    int free_genes = 0;
    for (const Gene& gene : gene_space(campaign, first))
        free_genes += gene.is_free ? 1 : 0;

    fmt::print("{}: no errors\n", options.campaign_path);
    fmt::print("campaign  {}, {} case{}\n", campaign.name, all.size(),
               all.size() == 1 ? "" : "s");
    fmt::print("{}", scenario_text(campaign, first));
    fmt::print("plant     {}, {} leaves, {:.4f} m2 of leaf, {} faces\n",
               campaign.crop.baseline.name,
               campaign.crop.baseline.leaves.size(), leaf_area(plant),
               plant.faces.size());
    fmt::print(
        "field     {} x {} plants, period {:.4g} x {:.4g} m, LAI {:.2f}"
        ", {} faces\n",
        campaign.field.rows, campaign.field.plants, field.period_x,
        field.period_y, leaf_area(field.mesh) / field.ground_area,
        field.mesh.faces.size());
    fmt::print(
        "light     {} {}, {:.3f} MJ m-2 day-1 of PAR, {:.0f} % diffuse\n",
        light.steps.size(),
        campaign.climates.empty()
            ? "instants with the sun up"
            : fmt::format("time steps with the suns of {} of {} dates",
                          std::min(campaign.sun_dates, light.days), light.days),
        light.incident() / 1e6, 100 * light.diffuse() / light.incident());
    fmt::print("{}", sky_table(campaign));
    const double excess = violation(campaign.constraints, campaign.crop.traits,
                                    campaign.crop.baseline,
                                    leaf_area(field.mesh) / field.ground_area);
    if (excess > 0)
        fmt::print(
            "          the plant fails the [constraints] by {:.3g} of their "
            "limits: all that is bred must first leave that behind\n",
            excess);
    fmt::print("genes     {} of {} free\n", free_genes, baseline.size());
    fmt::print("cost      {} per case\n", cost.text());
    const DiskRoom room = disk_room(campaign, all);
    const auto mebibytes = [](std::uint64_t bytes) {
        return static_cast<double>(bytes) / (1 << 20);
    };
    fmt::print(
        "disk      {:.2f} MiB per case, {:.2f} MiB for all of them, "
        "reserved when a case begins\n",
        mebibytes(room.largest), mebibytes(room.all));
    return ExitCode::ok;
}

ExitCode plan(const PlanOptions& options) {
    const Campaign campaign =
        read_campaign(options.campaign_path, options.settings);
    if (options.only_left) return list_left(options, campaign);
    const std::vector<Case> all = cases(campaign);
    if (options.only_count) {
        fmt::print("{}\n", all.size());
        return ExitCode::ok;
    }
    const Cost cost(campaign, measure_cost(campaign, all.front()));
    fmt::print("{:>5}  {:<40}  {:>20}\n", "index", "case", "seed");
    for (const Case& c : all)
        fmt::print("{:>5}  {:<40}  {:>20}\n", c.index, c.name, c.seed);
    fmt::print("\n{}each case: {} (measured here on the first)\n",
               scenario_text(campaign, all.front()), cost.text());
    fmt::print("{:>7}  {:>12}  {:>12}\n", "workers", "one case", "all cases");
    for (const int workers : {1, 2, 16, 128})
        fmt::print("{:>7}  {:>12}  {:>12}\n", workers,
                   format_duration(cost.of_case(workers)),
                   format_duration(cost.of_cases(all.size(), workers)));
    return ExitCode::ok;
}

}  // namespace ideotype
