// SPDX-License-Identifier: Apache-2.0
#include "breeder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "ideotype/core/contract.hpp"

namespace ideotype {

namespace {

//! Returns the spread factor of simulated binary crossover: the distance of a
//! child from the mean of its parents, in units of half the parents' distance
//! (Deb and Agrawal 1995, eq. 9). It is at most `room`, with bounds as in
//! NSGA-II.
double compute_spread(double u, double index, double room) {
    const double power = index + 1;
    const double alpha = std::isfinite(room) ? 2 - std::pow(room, -power) : 2.0;
    return u <= 1 / alpha ? std::pow(u * alpha, 1 / power)
                          : std::pow(1 / (2 - u * alpha), 1 / power);
}

//! Recombines one gene of two parents by simulated binary crossover (Deb and
//! Agrawal 1995), along the shorter arc for a circular gene. The values of a
//! choice have no order, so the children inherit them unchanged.
//! @param u random number in [0, 1)
std::pair<double, double> cross(const Gene& gene, double a, double b, double u,
                                double index) {
    if (gene.is_choice()) return {a, b};
    const double distance = difference(gene, a, b);
    if (std::abs(distance) < 1e-14 * (gene.upper - gene.lower)) return {a, b};
    const double mean = a + distance / 2;
    const double half = std::abs(distance) / 2;
    const double endless = std::numeric_limits<double>::infinity();
    const auto room = [&](double bound) {
        return gene.is_circular ? endless
                                : std::max(1.0, std::abs(bound - mean) / half);
    };
    const double low = mean - half * compute_spread(u, index, room(gene.lower));
    const double high =
        mean + half * compute_spread(u, index, room(gene.upper));
    const double first = within(gene, distance > 0 ? low : high);
    const double second = within(gene, distance > 0 ? high : low);
    return {first, second};
}

//! Varies one gene by a step with a polynomial density (Deb and Goyal 1996;
//! steps bounded as in NSGA-II). A discrete gene always changes: a choice to
//! any other value, an integer at least to a neighbour.
//! @param u random number in [0, 1)
double mutate(const Gene& gene, double value, double u, double index) {
    const double range = gene.upper - gene.lower;
    if (range == 0) return value;
    if (gene.is_choice()) return other_value(gene, value, u);
    const double power = index + 1;
    const auto cut_off = [&](double room) {
        // Circular genes have no bound, so no step is cut off.
        return gene.is_circular ? 0.0 : std::pow(1 - room / range, power);
    };
    double step = 0;
    if (u < 0.5) {
        const double rest = cut_off(value - gene.lower);
        step = std::pow(2 * u + (1 - 2 * u) * rest, 1 / power) - 1;
    } else {
        const double rest = cut_off(gene.upper - value);
        step = 1 - std::pow(2 * (1 - u) + (2 * u - 1) * rest, 1 / power);
    }
    const double mutated = within(gene, value + step * range);
    return gene.is_discrete() && mutated == value ? other_value(gene, value, u)
                                                  : mutated;
}

}  // namespace

Breeder::Breeder(const GaSettings& settings, SearchSpace space,
                 std::uint64_t seed)
    : settings_(settings), space_(std::move(space)), seed_(seed) {
    IDEOTYPE_EXPECT(space_.baseline.size() == space_.genes.size());
    IDEOTYPE_EXPECT(settings.crossover_probability >= 0 &&
                    settings.crossover_probability <= 1);
}

std::pair<Candidate, Candidate> Breeder::make_children(
    const Contest& contest, std::uint32_t generation,
    std::uint32_t slot) const {
    // Tournaments select both parents.
    RandomStream selection(seed_, Purpose::selection, generation, slot);
    const Parent mother = contest(selection);
    const Parent father = contest(selection);
    IDEOTYPE_EXPECT(mother.individual.candidate.genome.size() ==
                    space_.genes.size());
    IDEOTYPE_EXPECT(father.individual.candidate.genome.size() ==
                    space_.genes.size());
    Candidate first{mother.individual.candidate.genome,
                    Origin::child,
                    {mother.row, father.row}};
    Candidate second{father.individual.candidate.genome,
                     Origin::child,
                     {father.row, mother.row}};
    // Draw all random numbers of each gene, even if unused, to keep the streams
    // aligned.
    RandomStream crossover(seed_, Purpose::crossover, generation, slot);
    if (crossover.uniform() < settings_.crossover_probability)
        for (std::size_t i = 0; i < space_.genes.size(); ++i) {
            const bool is_crossed = crossover.uniform() < 0.5;
            const double u = crossover.uniform();
            const bool is_swapped = crossover.uniform() < 0.5;
            if (!space_.genes[i].is_free || !is_crossed) continue;
            std::tie(first.genome[i], second.genome[i]) =
                cross(space_.genes[i], first.genome[i], second.genome[i], u,
                      settings_.crossover_index);
            if (is_swapped) std::swap(first.genome[i], second.genome[i]);
        }
    mutate_genome(first.genome, generation, slot);
    mutate_genome(second.genome, generation, slot + 1);
    return {std::move(first), std::move(second)};
}

void Breeder::mutate_genome(Genome& genome, std::uint32_t generation,
                            std::uint32_t slot) const {
    const double probability = settings_.mutations_per_child /
                               static_cast<double>(count_free(space_.genes));
    RandomStream stream(seed_, Purpose::mutation, generation, slot);
    for (std::size_t i = 0; i < space_.genes.size(); ++i) {
        const Gene& gene = space_.genes[i];
        const bool is_mutated = stream.uniform() < probability;
        const double u = stream.uniform();
        if (gene.is_free && is_mutated)
            genome[i] = mutate(gene, genome[i], u, settings_.mutation_index);
        IDEOTYPE_ENSURE(!gene.is_free ||
                        (genome[i] >= gene.lower && genome[i] <= gene.upper));
    }
}

}  // namespace ideotype
