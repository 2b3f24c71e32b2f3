// SPDX-License-Identifier: Apache-2.0
//! Measures the steps of an evaluation, whole evaluations to a tolerance, and a
//! generation.
#include <cmath>

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include "ideotype/light/transport.hpp"
#include "run/evaluator.hpp"
#include "stand.hpp"

namespace ideotype {

namespace {

void geometry(benchmark::State& state) {
    const BenchStand stand(BenchStand::ames());
    for (auto _ : state) benchmark::DoNotOptimize(stand.field(stand.baseline));
}
BENCHMARK(geometry)->Unit(benchmark::kMillisecond);

void scene(benchmark::State& state) {
    const BenchStand stand(BenchStand::ames());
    const Field field = stand.field(stand.baseline);
    std::size_t faces = 0;
    for (auto _ : state) faces = stand.scene(field).faces();
    state.counters["faces"] = static_cast<double>(faces);
}
BENCHMARK(scene)->Unit(benchmark::kMillisecond);

void light(benchmark::State& state) {
    const BenchStand stand(BenchStand::ames());
    const Field field = stand.field(stand.baseline);
    const RayScene traced = stand.scene(field);
    const Accuracy accuracy = stand.campaign.sampling;
    for (auto _ : state)
        benchmark::DoNotOptimize(
            simulate({traced, field.mesh.groups, stand.request.scene.bands,
                      stand.request.layers},
                     accuracy, {stand.chosen.seed, 0, 0}));
    state.counters["paths"] =
        benchmark::Counter(1.0 * accuracy.paths * accuracy.randomisations,
                           benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(light)->Unit(benchmark::kMillisecond);

CanopyReport evaluate(const BenchStand& stand, const Accuracy& accuracy,
                      std::uint32_t generation = 0) {
    CanopyRequest request = stand.request;
    request.accuracy = accuracy;
    request.randomness.generation = generation;
    return evaluate(request, stand.device);
}

//! Returns the fewest paths, in eight randomisations, that meet a tolerance on
//! average over several draws. Errors are proportional to paths^-0.55.
int paths_for(const BenchStand& stand, double tolerance) {
    constexpr int trial = 4096;
    double squares = 0;
    constexpr std::uint32_t draws = 8;
    for (std::uint32_t d = 0; d < draws; ++d) {
        const double error = relative_error(evaluate(stand, {trial, 8}, d));
        squares += error * error / draws;
    }
    constexpr double slope = 0.55;
    return std::max(
        32, static_cast<int>(
                trial * std::pow(std::sqrt(squares) / tolerance, 1 / slope)));
}

//! Measures evaluations in which the relative error of the light absorbed by
//! leaves is 10^-2 to 10^-4.
void evaluation(benchmark::State& state) {
    const BenchStand stand(BenchStand::ames());
    const double tolerance = std::pow(10, -static_cast<double>(state.range(0)));
    const Accuracy accuracy{paths_for(stand, tolerance), 8};
    double error = 0;
    for (auto _ : state) error = relative_error(evaluate(stand, accuracy));
    state.counters["error"] = error;
    state.counters["paths"] = 1.0 * accuracy.paths * accuracy.randomisations;
}
BENCHMARK(evaluation)
    ->DenseRange(2, 4)
    ->ArgName("tolerance_1e-")
    ->Unit(benchmark::kMillisecond);

//! Evaluates a population with the accuracy of the campaign, as a worker does.
void generation(benchmark::State& state) {
    const Campaign campaign = BenchStand::ames();
    CanopyEvaluator evaluator(campaign, Device::supported_isas().back());
    const Genome baseline = baseline_genome(campaign);
    for (auto _ : state)
        for (int slot = 0; slot < campaign.search.population; ++slot) {
            Task task;
            task.slot = static_cast<std::uint32_t>(slot);
            benchmark::DoNotOptimize(evaluator.evaluate(task, baseline));
        }
    state.counters["evaluations"] =
        benchmark::Counter(campaign.search.population,
                           benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(generation)->Unit(benchmark::kMillisecond)->Iterations(1);

//! Evaluates sixteen fields of one canopy with several threads.
void fields_beside_each_other(benchmark::State& state) {
    BenchStand stand(BenchStand::ames());
    stand.request.accuracy = {4096, 64, 0, 16};
    for (auto _ : state)
        benchmark::DoNotOptimize(evaluate(stand.request, stand.device, {},
                                          static_cast<int>(state.range(0))));
}
BENCHMARK(fields_beside_each_other)
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

//! Measures the peak memory of a process that only evaluates [MiB]. Must run
//! alone, as in table.sh.
void memory(benchmark::State& state) {
    const Campaign campaign = BenchStand::ames();
    CanopyEvaluator evaluator(campaign, Device::supported_isas().back());
    const Genome baseline = baseline_genome(campaign);
    for (auto _ : state)
        benchmark::DoNotOptimize(evaluator.evaluate({}, baseline));
    struct rusage usage {};
    getrusage(RUSAGE_SELF, &usage);
    state.counters["MiB"] = static_cast<double>(usage.ru_maxrss) / 1024;
}
BENCHMARK(memory)->Unit(benchmark::kMillisecond)->Iterations(20);

}  // namespace

}  // namespace ideotype
