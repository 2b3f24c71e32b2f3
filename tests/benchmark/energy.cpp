// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <vector>

#include <benchmark/benchmark.h>

#include "ideotype/physiology/leaf_exchange.hpp"

namespace ideotype {
namespace {

//! Points in the same air, from darkness to full light.
std::vector<LeafSurroundings> surroundings() {
    std::vector<LeafSurroundings> all;
    for (int i = 0; i < 64; ++i)
        all.push_back({32. * i, 160, 840, 28.4, .55, 410, 99, 1.5, .08});
    return all;
}

ThermalLeaf leaf_of(const benchmark::State& state) {
    ThermalLeaf leaf;
    if (state.range(0) != 0) leaf.rates = FarquharLeaf{};
    return leaf;
}

//! Measures the number of leaf points solved per second one by one.
void leaf_energy_balance(benchmark::State& state) {
    const ThermalLeaf leaf = leaf_of(state);
    const std::vector<LeafSurroundings> all = surroundings();
    for (auto _ : state)
        for (const LeafSurroundings& around : all)
            benchmark::DoNotOptimize(energy_balance(leaf, around));
    state.SetItemsProcessed(state.iterations() *
                            static_cast<std::int64_t>(all.size()));
}
BENCHMARK(leaf_energy_balance)
    ->ArgName("c3")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMicrosecond);

//! Measures the number of leaf points solved per second in vectors.
void leaf_exchanges(benchmark::State& state) {
    const ThermalLeaf leaf = leaf_of(state);
    std::vector<ThermalPoint> points;
    for (const LeafSurroundings& around : surroundings())
        points.push_back({&leaf, around});
    std::vector<LeafExchange> results(points.size());
    for (auto _ : state) {
        leaf_exchange(points, results.data());
        benchmark::DoNotOptimize(results.data());
    }
    state.SetItemsProcessed(state.iterations() *
                            static_cast<std::int64_t>(points.size()));
}
BENCHMARK(leaf_exchanges)
    ->Name("leaf_exchange")
    ->ArgName("c3")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace ideotype
