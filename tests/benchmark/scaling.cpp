// SPDX-License-Identifier: Apache-2.0
//! Measures cost against plants, leaves, faces, hours and sites; table.sh fits
//! the exponents.
#include <string>

#include <benchmark/benchmark.h>

#include "run/evaluator.hpp"
#include "stand.hpp"

namespace ideotype {

namespace {

void measure(benchmark::State& state, Campaign campaign, double size) {
    BenchStand stand(std::move(campaign));
    stand.request.accuracy = {1024, 8};
    for (auto _ : state)
        benchmark::DoNotOptimize(evaluate(stand.request, stand.device));
    state.counters["size"] = size;
}

void plants(benchmark::State& state) {
    Campaign campaign = BenchStand::ames();
    campaign.spec.field.rows = campaign.spec.field.plants =
        static_cast<int>(state.range(0));
    measure(state, campaign,
            1.0 * campaign.spec.field.rows * campaign.spec.field.rows);
}
BENCHMARK(plants)->Arg(1)->Arg(3)->Arg(10)->Arg(32)->Arg(100)->Unit(
    benchmark::kMillisecond);

//! A plant with several copies of the baseline's leaves, each copy at another
//! azimuth.
void leaves(benchmark::State& state) {
    Campaign campaign = BenchStand::ames();
    std::vector<Leaf>& leaves = campaign.crop.baseline.leaves;
    const std::vector<Leaf> own = std::exchange(leaves, {});
    for (int i = 0; i < state.range(0); ++i) {
        leaves.push_back(own[static_cast<std::size_t>(i) % own.size()]);
        leaves.back().azimuth += 17.0 * i;
    }
    campaign.bounds.clear();
    for (const TraitNumber& number : trait_numbers(campaign.crop))
        campaign.bounds.push_back(campaign.crop.traits[number.trait].range);
    measure(state, campaign, static_cast<double>(state.range(0)));
}
BENCHMARK(leaves)->RangeMultiplier(2)->Range(5, 80)->Unit(
    benchmark::kMillisecond);

//! The argument is the number of cells along a leaf; each cell consists of two
//! faces.
void faces(benchmark::State& state) {
    Campaign campaign = BenchStand::ames();
    campaign.spec.plant.tessellation.cells_along =
        static_cast<int>(state.range(0));
    measure(state, campaign, 2.0 * static_cast<double>(state.range(0)));
}
BENCHMARK(faces)->RangeMultiplier(2)->Range(4, 64)->Unit(
    benchmark::kMillisecond);

//! The argument is the number of instants of the day; they share a fixed number
//! of paths.
void hours(benchmark::State& state) {
    Campaign campaign = BenchStand::ames();
    campaign.spec.days[0].value.step_minutes =
        780.0 / static_cast<double>(state.range(0));
    measure(state, campaign, static_cast<double>(state.range(0)) + 1);
}
BENCHMARK(hours)->RangeMultiplier(2)->Range(6, 208)->Unit(
    benchmark::kMillisecond);

//! The work of a worker in a campaign of several sites: preparing the light of
//! each site, and one evaluation at each.
void sites(benchmark::State& state) {
    Campaign campaign = BenchStand::ames();
    campaign.spec.replicates = 1;
    const Site ames = campaign.spec.sites[0];
    campaign.spec.sites.clear();
    for (int i = 0; i < state.range(0); ++i) {
        campaign.spec.sites.push_back(ames);
        campaign.spec.sites.back().name += std::to_string(i);
    }
    const Genome baseline = baseline_genome(campaign);
    for (auto _ : state) {
        CanopyEvaluator evaluator(campaign, Device::supported_isas().back());
        Task task;
        for (; task.case_index < campaign.spec.sites.size(); ++task.case_index)
            benchmark::DoNotOptimize(evaluator.evaluate(task, baseline));
    }
    state.counters["size"] = static_cast<double>(state.range(0));
}
BENCHMARK(sites)->RangeMultiplier(4)->Range(1, 256)->Unit(
    benchmark::kMillisecond);

}  // namespace

}  // namespace ideotype
