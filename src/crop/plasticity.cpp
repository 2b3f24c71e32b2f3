// SPDX-License-Identifier: Apache-2.0
#include "ideotype/crop/plasticity.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "effects.hpp"
#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

//! Returns ln(d), with d the relative density to which plants respond.
double log_density(const Plasticity& plasticity,
                   const DensityResponse& response, double density) {
    IDEOTYPE_EXPECT(density > 0);
    const auto& [lower, upper] = response.densities;
    if (lower < upper) density = std::clamp(density, lower, upper);
    return std::log(density / plasticity.reference);
}

}  // namespace

double turn_at(const Plasticity& plasticity, double density) {
    const auto& [first, last] = plasticity.turning;
    if (!(plasticity.turn > 0) || density <= first) return 0;
    if (density >= last) return plasticity.turn;
    return plasticity.turn * std::log(density / first) / std::log(last / first);
}

Plant respond(Plant plant, const std::vector<double>& densities) {
    IDEOTYPE_EXPECT(densities.size() == plant.leaves.size());
    const Plasticity plasticity = plant.plasticity;
    plant.plasticity.responses.clear();
    if (plasticity.responses.empty() || densities.empty() ||
        !(plasticity.reference > 0))
        return plant;
    for (const DensityResponse& response : plasticity.responses) {
        std::vector<double> logs;  // ln(d) by leaf
        for (const double density : densities)
            logs.push_back(log_density(plasticity, response, density));
        const double mean = std::accumulate(logs.begin(), logs.end(), 0.) /
                            static_cast<double>(logs.size());
        const auto change_of = [&](std::size_t i, std::size_t count) {
            return profile(response.slopes, relative_position(i, count)) *
                   (count == logs.size() ? logs[i] : mean);
        };
        for (const std::string& name : response.scales)
            change(plant, name, TraitEffect::scales,
                   [&](auto... i) { return std::exp(change_of(i...)); });
        for (const std::string& name : response.shifts)
            change(plant, name, TraitEffect::shifts, change_of);
    }
    stack_internodes(plant);
    return plant;
}

Plant respond(Plant plant, double density) {
    const std::size_t leaves = plant.leaves.size();
    return respond(std::move(plant), std::vector<double>(leaves, density));
}

}  // namespace ideotype
