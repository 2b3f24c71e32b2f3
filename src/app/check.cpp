#include <fmt/format.h>

#include "ideotype/app/canopy.hpp"
#include "ideotype/app/progress.hpp"
#include "ideotype/app/verbs.hpp"
#include "ideotype/light/device.hpp"
#include "ideotype/light/scene.hpp"

namespace ideotype {

namespace {

//! Seconds that one evaluation of a case takes here on one core, measured on
//! the baseline; the quicker of two, since the first warms up.
double measure_cost(const Campaign& campaign, const Case& chosen) {
    CanopyEvaluator evaluator(campaign, Device::supported_isas().back());
    Task task;
    task.case_index = static_cast<std::uint32_t>(chosen.index);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 2; ++i) {
        const double began = now();
        evaluator.evaluate(task, to_genome(campaign.baseline));
        least = std::min(least, now() - began);
    }
    return least;
}

long long evaluations(const Campaign& campaign) {
    return static_cast<long long>(campaign.optimizer.population) *
           campaign.stop.generations;
}

std::string cost_text(double seconds_each, long long count) {
    return fmt::format(
        "{} evaluations of {:.1f} ms: {} on one core", count,
        seconds_each * 1e3,
        format_duration(seconds_each * static_cast<double>(count)));
}

}  // namespace

ExitCode check(const std::string& campaign_path) {
    const Campaign campaign = read_campaign(campaign_path);
    const std::vector<Case> all = cases(campaign);
    const Case& first = all.front();
    const Genome baseline = to_genome(campaign.baseline);
    const Mesh plant = build_plant(campaign, baseline);
    const Day day = clear_day(first.site, first.day, campaign.par_fraction);
    const Field field = build_field(campaign, first, baseline,
                                    draws_of({}, campaign, first), 0);
    const double cost = measure_cost(campaign, first);
    int free_genes = 0;
    for (const Gene& gene : gene_space(campaign, first))
        free_genes += gene.is_free ? 1 : 0;

    fmt::print("{}: no errors\n", campaign_path);
    fmt::print("campaign  {}, {} case{}\n", campaign.name, all.size(),
               all.size() == 1 ? "" : "s");
    fmt::print("plant     {}, {} leaves, {:.4f} m2 of leaf, {} faces\n",
               campaign.plant.name, campaign.baseline.size(), leaf_area(plant),
               plant.faces.size());
    fmt::print(
        "field     {} x {} plants, period {:.4g} x {:.4g} m, LAI {:.2f}"
        ", {} faces\n",
        campaign.field.rows, campaign.field.plants, field.period_x,
        field.period_y, leaf_area(field.mesh) / field.ground_area(),
        field.mesh.faces.size());
    fmt::print(
        "light     {} instants with the sun up, {:.3f} MJ m-2 day-1 of "
        "PAR, {:.0f} % diffuse\n",
        day.steps.size(), day.incident() / 1e6,
        day.incident() > 0 ? 100 * day.diffuse() / day.incident() : 0);
    fmt::print("genes     {} of {} free\n", free_genes, baseline.size());
    fmt::print("cost      {} per case\n",
               cost_text(cost, evaluations(campaign)));
    return ExitCode::ok;
}

ExitCode plan(const PlanOptions& options) {
    const Campaign campaign = read_campaign(options.campaign_path);
    const std::vector<Case> all = cases(campaign);
    if (options.only_count) {
        fmt::print("{}\n", all.size());
        return ExitCode::ok;
    }
    const double cost = measure_cost(campaign, all.front());
    fmt::print("{:>5}  {:<40}  {:>20}  {}\n", "index", "case", "seed", "cost");
    for (const Case& c : all)
        fmt::print("{:>5}  {:<40}  {:>20}  {}\n", c.index, c.name, c.seed,
                   cost_text(cost, evaluations(campaign)));
    const auto total = static_cast<long long>(all.size());
    fmt::print("all: {} (measured on the first case)\n",
               cost_text(cost, total * evaluations(campaign)));
    return ExitCode::ok;
}

}  // namespace ideotype
