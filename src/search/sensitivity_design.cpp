// SPDX-License-Identifier: Apache-2.0
#include "sensitivity_design.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/random.hpp"

namespace ideotype {

namespace {

//! Groups the free genes into factors, by gene or by trait.
std::vector<Factor> group_factors(const GeneSpace& genes, Grouping groups) {
    std::vector<Factor> factors;
    for (std::size_t i = 0; i < genes.size(); ++i) {
        if (!genes[i].is_free) continue;
        const std::string& name =
            groups == Grouping::gene ? genes[i].name : genes[i].trait;
        auto factor = std::find_if(
            factors.begin(), factors.end(),
            [&](const Factor& candidate) { return candidate.name == name; });
        if (factor == factors.end())
            factor = factors.insert(factors.end(), {name, {}});
        factor->genes.push_back(i);
    }
    return factors;
}

}  // namespace

SensitivityDesign::SensitivityDesign(const SensitivitySettings& settings,
                                     SearchSpace space, std::uint64_t seed)
    : settings_(settings),
      space_(std::move(space)),
      seed_(seed),
      factors_(group_factors(space_.genes, settings.groups)),
      sequence_(seed, 2 * space_.genes.size()) {
    IDEOTYPE_EXPECT(settings.levels >= 2 && settings.levels % 2 == 0);
    for (std::size_t i = 0; i < space_.genes.size(); ++i)
        if (space_.genes[i].is_free) free_.push_back(i);
}

//! Returns a point of a trajectory of Morris, relative to the ranges of genes.
std::vector<double> SensitivityDesign::make_path_point(std::uint32_t sample,
                                                       std::size_t row) const {
    std::vector<double> point(space_.genes.size()), steps = point;
    RandomStream stream(seed_, Purpose::sample, 0, sample);
    const auto half = static_cast<std::uint32_t>(settings_.levels / 2);
    for (const std::size_t gene : free_) {
        const double level = stream.below(half);
        const bool is_up = stream.below(2) == 0;
        point[gene] = is_up ? level : level + half;
        steps[gene] = is_up ? half : -static_cast<double>(half);
    }
    // Fisher-Yates shuffle of the order of factors.
    std::vector<std::size_t> order(factors_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1],
                  order[stream.below(static_cast<std::uint32_t>(i))]);
    for (std::size_t i = 0; i < row; ++i)
        for (const std::size_t gene : factors_[order[i]].genes)
            point[gene] += steps[gene];
    for (const std::size_t gene : free_)
        // The two ends of a circular gene are the same value.
        point[gene] /=
            settings_.levels - (space_.genes[gene].is_circular ? 0 : 1);
    return point;
}

//! Returns point A, point A with one factor taken from point B, or point B
//! (Saltelli et al. 2010).
std::vector<double> SensitivityDesign::make_cube_point(std::uint32_t sample,
                                                       std::size_t row) const {
    std::vector<double> point(space_.genes.size());
    const bool is_last = row == factors_.size() + 1;
    const auto is_of_b = [&](std::size_t gene) {
        if (is_last || row == 0) return is_last;
        const std::vector<std::size_t>& genes = factors_[row - 1].genes;
        return std::find(genes.begin(), genes.end(), gene) != genes.end();
    };
    for (std::size_t i = 0; i < free_.size(); ++i)
        point[free_[i]] =
            sequence_.at(sample, is_of_b(free_[i]) ? free_.size() + i : i);
    return point;
}

Genome SensitivityDesign::make_row(std::uint32_t sample,
                                   std::size_t number) const {
    IDEOTYPE_EXPECT(space_.baseline.size() == space_.genes.size());
    IDEOTYPE_EXPECT(sample < samples() && number < rows_per_sample());
    const std::vector<double> point =
        settings_.method == SensitivityMethod::morris
            ? make_path_point(sample, number)
            : make_cube_point(sample, number);
    Genome genome = space_.baseline;
    for (const std::size_t i : free_) {
        IDEOTYPE_ENSURE(point[i] >= 0 && point[i] <= 1);
        genome[i] = value_at(space_.genes[i], point[i]);
    }
    return genome;
}

int generation_size(const SensitivitySettings& settings,
                    const GeneSpace& genes) {
    const SensitivityDesign design(settings, {genes, {}}, 0);
    return samples_per_generation * static_cast<int>(design.rows_per_sample());
}

int count_generations(const SensitivitySettings& settings) {
    return (settings.samples + samples_per_generation - 1) /
           samples_per_generation;
}

std::size_t SensitivityDesign::size(std::uint32_t generation) const {
    const std::size_t before = std::size_t{generation} * samples_per_generation;
    IDEOTYPE_EXPECT(before < samples());
    return rows_per_sample() *
           std::min<std::size_t>(samples_per_generation, samples() - before);
}

std::uint64_t SensitivityDesign::needs(std::uint32_t generation) const {
    constexpr std::uint64_t under_way = 1000;
    const std::uint64_t before =
        std::uint64_t{generation} * samples_per_generation * rows_per_sample();
    return before - std::min(before, under_way);
}

Candidate SensitivityDesign::propose(std::uint32_t generation,
                                     std::uint32_t slot) {
    const auto rows = static_cast<std::uint32_t>(rows_per_sample());
    return {make_row(generation * samples_per_generation + slot / rows,
                     slot % rows),
            Origin::random};
}

}  // namespace ideotype
