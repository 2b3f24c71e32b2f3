// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "ideotype/physiology/leaf_exchange.hpp"

namespace ideotype {
namespace {

//! Measures the number of leaf points solved per second, from darkness to full
//! light.
template <auto balance>
void leaf_points(benchmark::State& state) {
    ThermalLeaf leaf;
    if (state.range(0) != 0) leaf.rates = FarquharLeaf{};
    LeafSurroundings around{0, 160, 840, 28.4, .55, 410, 99, 1.5, .08};
    for (auto _ : state) {
        around.ppfd = around.ppfd > 2000 ? 0 : around.ppfd + 37;
        benchmark::DoNotOptimize(balance(leaf, around));
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(leaf_points<energy_balance>)
    ->Name("leaf_energy_balance")
    ->ArgName("c3")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(
    leaf_points<[](const ThermalLeaf& leaf, const LeafSurroundings& around) {
        return leaf_exchange(leaf, around);
    }>)
    ->Name("leaf_exchange")
    ->ArgName("c3")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace ideotype
