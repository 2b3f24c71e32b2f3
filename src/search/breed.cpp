#include "ideotype/search/breed.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ideotype/core/random.hpp"
#include "ideotype/search/rank.hpp"

namespace ideotype {

double wrapped(const Gene& gene, double value) {
    const double range = gene.upper - gene.lower;
    const double turns = std::floor((value - gene.lower) / range);
    const double result = value - turns * range;
    // Rounding can put a tiny negative value onto the upper end.
    return result < gene.upper ? std::max(result, gene.lower) : gene.lower;
}

double difference(const Gene& gene, double a, double b) {
    if (!gene.is_circular) return b - a;
    const double range = gene.upper - gene.lower;
    return std::remainder(b - a, range);
}

namespace {

double repaired(const Gene& gene, double value) {
    return gene.is_circular ? wrapped(gene, value)
                            : std::clamp(value, gene.lower, gene.upper);
}

//! The spread factor of simulated binary crossover, bounded so that a child
//! stays within `room` of the couple's mean, both in units of half of the
//! parents' distance (Deb and Agrawal 1995, eq. 9 with bounds as in NSGA-II).
double spread_factor(double u, double index, double room) {
    const double power = index + 1;
    const double alpha = std::isfinite(room) ? 2 - std::pow(room, -power) : 2.0;
    return u <= 1 / alpha ? std::pow(u * alpha, 1 / power)
                          : std::pow(1 / (2 - u * alpha), 1 / power);
}

//! Recombines one gene of a couple.
std::pair<double, double> cross(const Gene& gene, double a, double b, double u,
                                double index) {
    const double distance = difference(gene, a, b);
    if (std::abs(distance) < 1e-14 * (gene.upper - gene.lower)) return {a, b};
    const double mean = a + distance / 2;
    const double half = std::abs(distance) / 2;
    const double endless = std::numeric_limits<double>::infinity();
    const auto room = [&](double bound) {
        return gene.is_circular ? endless
                                : std::max(1.0, std::abs(bound - mean) / half);
    };
    const double low = mean - half * spread_factor(u, index, room(gene.lower));
    const double high = mean + half * spread_factor(u, index, room(gene.upper));
    const double first = repaired(gene, distance > 0 ? low : high);
    const double second = repaired(gene, distance > 0 ? high : low);
    return {first, second};
}

//! Varies one gene by a step whose density falls off as a polynomial (Deb and
//! Goyal 1996; steps bounded as in NSGA-II).
double mutate(const Gene& gene, double value, double u, double index) {
    const double range = gene.upper - gene.lower;
    const double power = index + 1;
    const auto missing = [&](double room) {
        // A circle has no end, so no step is cut off.
        return gene.is_circular ? 0.0 : std::pow(1 - room / range, power);
    };
    double step = 0;
    if (u < 0.5) {
        const double rest = missing(value - gene.lower);
        step = std::pow(2 * u + (1 - 2 * u) * rest, 1 / power) - 1;
    } else {
        const double rest = missing(gene.upper - value);
        step = 1 - std::pow(2 * (1 - u) + (2 * u - 1) * rest, 1 / power);
    }
    return repaired(gene, value + step * range);
}

Genome random_genome(const GeneSpace& genes, const Genome& baseline,
                     RandomStream& stream) {
    Genome genome = baseline;
    for (std::size_t i = 0; i < genes.size(); ++i)
        if (genes[i].is_free)
            genome[i] = stream.uniform(genes[i].lower, genes[i].upper);
    return genome;
}

std::int32_t tournament(const Population& parents, int contestants,
                        RandomStream& stream) {
    const auto size = static_cast<std::uint32_t>(parents.size());
    std::uint32_t winner = stream.below(size);
    for (int i = 1; i < contestants; ++i) {
        const std::uint32_t rival = stream.below(size);
        if (is_better(parents[rival], parents[winner])) winner = rival;
    }
    return static_cast<std::int32_t>(winner);
}

//! Breeds the children of two neighbouring slots from one couple.
class Variation {
  public:
    Variation(const GaSettings& optimizer, const GeneSpace& genes,
              std::uint64_t seed, std::uint32_t generation,
              const Population& parents)
        : optimizer_(optimizer),
          genes_(genes),
          seed_(seed),
          generation_(generation),
          parents_(parents) {
        for (const Gene& gene : genes) free_genes_ += gene.is_free ? 1 : 0;
    }

    std::pair<Candidate, Candidate> couple(std::uint32_t slot) const {
        RandomStream selection(seed_, Purpose::selection, generation_, slot);
        const auto first_parent =
            tournament(parents_, optimizer_.tournament, selection);
        const auto second_parent =
            tournament(parents_, optimizer_.tournament, selection);
        Candidate first{genome_of(first_parent),
                        Origin::child,
                        {first_parent, second_parent}};
        Candidate second{genome_of(second_parent),
                         Origin::child,
                         {second_parent, first_parent}};
        RandomStream crossover(seed_, Purpose::crossover, generation_, slot);
        if (crossover.uniform() < optimizer_.crossover_probability)
            for (std::size_t i = 0; i < genes_.size(); ++i) {
                const bool is_crossed = crossover.uniform() < 0.5;
                const double u = crossover.uniform();
                if (genes_[i].is_free && is_crossed)
                    std::tie(first.genome[i], second.genome[i]) =
                        cross(genes_[i], first.genome[i], second.genome[i], u,
                              optimizer_.crossover_index);
            }
        mutate_genome(first.genome, slot);
        mutate_genome(second.genome, slot + 1);
        return {std::move(first), std::move(second)};
    }

  private:
    const Genome& genome_of(std::int32_t slot) const {
        return parents_[static_cast<std::size_t>(slot)].candidate.genome;
    }

    void mutate_genome(Genome& genome, std::uint32_t slot) const {
        RandomStream stream(seed_, Purpose::mutation, generation_, slot);
        const double probability = optimizer_.mutations_per_child / free_genes_;
        for (std::size_t i = 0; i < genes_.size(); ++i) {
            const bool is_mutated = stream.uniform() < probability;
            const double u = stream.uniform();
            if (genes_[i].is_free && is_mutated)
                genome[i] =
                    mutate(genes_[i], genome[i], u, optimizer_.mutation_index);
        }
    }

    const GaSettings& optimizer_;
    const GeneSpace& genes_;
    std::uint64_t seed_;
    std::uint32_t generation_;
    const Population& parents_;
    int free_genes_ = 0;
};

}  // namespace

std::vector<Candidate> breed(const GaSettings& optimizer,
                             const GeneSpace& genes, const Genome& baseline,
                             std::uint64_t seed, std::uint32_t generation,
                             const Population& parents) {
    const auto size = static_cast<std::size_t>(optimizer.population);
    std::vector<Candidate> candidates;
    candidates.reserve(size + 1);
    if (parents.empty()) {
        candidates.push_back({baseline, Origin::baseline, {}});
        for (std::uint32_t slot = 1; candidates.size() < size; ++slot) {
            RandomStream stream(seed, Purpose::initial_population, generation,
                                slot);
            candidates.push_back(
                {random_genome(genes, baseline, stream), Origin::random, {}});
        }
        return candidates;
    }
    for (const std::uint32_t slot :
         best_distinct(parents, static_cast<std::size_t>(optimizer.elites))) {
        const auto parent = static_cast<std::int32_t>(slot);
        candidates.push_back({parents[slot].candidate.genome,
                              Origin::elite,
                              {parent, no_parent}});
    }
    const Variation variation(optimizer, genes, seed, generation, parents);
    while (candidates.size() < size) {
        auto [first, second] =
            variation.couple(static_cast<std::uint32_t>(candidates.size()));
        candidates.push_back(std::move(first));
        candidates.push_back(std::move(second));
    }
    candidates.resize(size);
    return candidates;
}

}  // namespace ideotype
