// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/random.hpp"
#include "optimizer.hpp"
#include "order.hpp"

namespace ideotype {

namespace {

struct Leader {
    Individual individual;
    std::int64_t row = no_parent;  //!< row of its last evaluation
    double sum = 0;                //!< sum of objective 0 over its evaluations
    int evaluations = 1;

    double mean() const { return sum / evaluations; }
};

//! An occupied cell of the atlas. It contains its best known plant, the leader,
//! and possibly a challenger: a plant that seems better but has not yet been
//! evaluated in one generation with the leader.
struct Niche {
    Leader leader;
    std::optional<Leader> challenger;
};

//! Finds the best plant of each kind by MAP-Elites (Mouret and Clune 2015,
//! arXiv:1504.04909), adapted to noisy objectives. Kinds are the cells of a
//! grid over features such as leaf area and height; plants outside the grid are
//! ignored. Generation 0 is made as in GeneticAlgorithm. Later generations are
//! children of leaders, which are selected with equal probability.
//!
//! A single evaluation cannot distinguish a better plant from a lucky one. A
//! plant with a value above a leader's mean therefore becomes its challenger.
//! It replaces the leader only if it also wins in the next generation, where
//! both use common random numbers. Leaders with the fewest evaluations are
//! re-evaluated, so that none remains by luck (adaptive sampling: Justesen et
//! al. 2019, doi:10.1145/3319619.3321904).
class Atlas : public GenerationalOptimizer {
  public:
    Atlas(const SearchSettings& settings, SearchSpace space, std::uint64_t seed)
        : settings_(settings), space_(std::move(space)), seed_(seed) {
        IDEOTYPE_EXPECT(settings.population > 0);
        IDEOTYPE_EXPECT(!settings.axes.empty());
    }

    std::size_t next_size() const override {
        return static_cast<std::size_t>(settings_.population);
    }

    Candidate candidate(std::uint32_t slot) override {
        IDEOTYPE_EXPECT(slot < next_size());
        if (slot < repeats_.size()) return repeats_[slot];
        if (leaders_.empty())
            return make_founder(space_, seed_, generation(), slot);
        RandomStream stream(seed_, Purpose::selection, generation(), slot);
        const auto draw_leader = [&]() -> const Leader& {
            return *leaders_[stream.below(
                static_cast<std::uint32_t>(leaders_.size()))];
        };
        const Leader& mother = draw_leader();
        const Leader& father = draw_leader();
        return {make_child(mother.individual.candidate.genome,
                           father.individual.candidate.genome, slot),
                Origin::child,
                {mother.row, father.row}};
    }

    std::vector<Candidate> best(std::size_t count) const override {
        std::vector<const Leader*> sorted = leaders_;
        std::stable_sort(sorted.begin(), sorted.end(),
                         [&](const Leader* a, const Leader* b) {
                             return exceeds(a->mean(), b->mean());
                         });
        std::vector<Candidate> best;
        for (const Leader* leader : sorted)
            if (best.size() < count) best.push_back(make_repeat(*leader));
        return best;
    }

  private:
    //! Moves a plant along the line to another plant, and slightly in random
    //! directions (Vassiliades and Mouret 2018, doi:10.1145/3205455.3205602).
    //! Moves along the line preserve features that both parents share. A
    //! discrete gene is that of either parent, and sometimes another one.
    Genome make_child(const Genome& mother, const Genome& father,
                      std::uint32_t slot) {
        // Standard deviation of isotropic steps, relative to the range of a
        // gene.
        constexpr double everywhere = 0.01;
        // Standard deviation of steps along the line, relative to its length.
        constexpr double along_line = 0.2;
        RandomStream stream(seed_, Purpose::mutation, generation(), slot);
        const double share = along_line * stream.normal()[0];
        RandomStream discrete(seed_, Purpose::crossover, generation(), slot);
        const double mutation = 1. / static_cast<double>(space_.genes.size());
        Genome genome = mother;
        for (std::size_t i = 0; i < genome.size(); ++i) {
            const Gene& gene = space_.genes[i];
            const double step =
                everywhere * (gene.upper - gene.lower) * stream.normal()[0];
            if (gene.is_discrete() && gene.can_vary()) {
                genome[i] = discrete.uniform() < 0.5 ? mother[i] : father[i];
                if (discrete.uniform() < mutation)
                    genome[i] =
                        other_value(gene, genome[i], discrete.uniform());
            } else if (gene.is_free)
                genome[i] = within(
                    gene, mother[i] + step +
                              share * difference(gene, mother[i], father[i]));
        }
        return genome;
    }

    void take(Population evaluated) override {
        judge(evaluated);
        for (std::size_t i = repeats_.size(); i < evaluated.size(); ++i)
            place(evaluated[i], find_row(i));
        leaders_.clear();
        for (const auto& [cell, niche] : niches_)
            leaders_.push_back(&niche.leader);
        plan();
    }

    //! Compares challengers with their leaders, and updates the means of the
    //! other re-evaluated leaders. A plant with a failed evaluation loses.
    void judge(const Population& evaluated) {
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            Niche& niche = niches_.at(cells_[i]);
            const bool is_duel =
                i + 1 < cells_.size() && cells_[i + 1] == cells_[i];
            add(niche.leader, evaluated[i], find_row(i));
            if (!is_duel) continue;
            const Individual& incumbent = evaluated[i];
            const Individual& rival = evaluated[++i];
            if (is_better(rival, incumbent, space_.senses.front()))
                niche.leader = make_leader(rival, find_row(i));
            niche.challenger.reset();
        }
    }

    //! Makes a feasible plant the leader of its cell if the cell is empty, or a
    //! challenger if the plant seems better than the leader.
    void place(const Individual& plant, std::int64_t row) {
        const auto cell = find_cell(plant);
        if (!cell) return;
        const auto [entry, is_new] =
            niches_.try_emplace(*cell, Niche{make_leader(plant, row), {}});
        if (is_new) return;
        std::optional<Leader>& challenger = entry->second.challenger;
        const double bar =
            challenger ? challenger->mean() : entry->second.leader.mean();
        if (exceeds(plant.objectives.front().mean, bar))
            challenger = make_leader(plant, row);
    }

    //! Chooses the plants to re-evaluate. Up to half of a generation are
    //! leaders and their challengers, pairs with the largest difference of
    //! means first. Up to an eighth are other leaders, those with the fewest
    //! evaluations first.
    void plan() {
        repeats_.clear();
        cells_.clear();
        std::vector<std::pair<double, std::size_t>> duels, others;
        for (const auto& [cell, niche] : niches_)
            if (niche.challenger)
                duels.emplace_back(
                    -std::abs(niche.challenger->mean() - niche.leader.mean()),
                    cell);
            else
                others.emplace_back(niche.leader.evaluations, cell);
        std::sort(duels.begin(), duels.end());
        std::sort(others.begin(), others.end());
        for (const auto& [advantage, cell] : duels) {
            if (repeats_.size() + 2 > next_size() / 2) break;
            const Niche& niche = niches_.at(cell);
            cells_.insert(cells_.end(), 2, cell);
            repeats_.push_back(make_repeat(niche.leader));
            repeats_.push_back(make_repeat(*niche.challenger));
        }
        const std::size_t limit = repeats_.size() + next_size() / 8;
        for (const auto& [evaluations, cell] : others) {
            if (repeats_.size() >= limit) break;
            cells_.push_back(cell);
            repeats_.push_back(make_repeat(niches_.at(cell).leader));
        }
    }

    //! Finds the cell of a plant that meets all constraints.
    std::optional<std::size_t> find_cell(const Individual& plant) const {
        if (plant.status != Status::done || plant.violation > 0) return {};
        IDEOTYPE_EXPECT(plant.features.size() == settings_.axes.size());
        std::size_t cell = 0;
        for (std::size_t i = 0; i < settings_.axes.size(); ++i) {
            const AtlasAxis& axis = settings_.axes[i];
            const double position = (plant.features[i] - axis.range.lower) /
                                    (axis.range.upper - axis.range.lower) *
                                    axis.cells;
            if (!(position >= 0 && position < axis.cells)) return {};
            cell = cell * static_cast<std::size_t>(axis.cells) +
                   static_cast<std::size_t>(position);
        }
        return cell;
    }

    static Leader make_leader(const Individual& plant, std::int64_t row) {
        return {plant, row, plant.objectives.front().mean, 1};
    }

    static void add(Leader& leader, const Individual& repeat,
                    std::int64_t row) {
        if (repeat.status != Status::done) return;
        leader.sum += repeat.objectives.front().mean;
        ++leader.evaluations;
        leader.row = row;
    }

    static Candidate make_repeat(const Leader& leader) {
        return {leader.individual.candidate.genome,
                Origin::elite,
                {leader.row, no_parent}};
    }

    bool exceeds(double a, double b) const {
        return is_better(a, b, space_.senses.front());
    }

    std::int64_t find_row(std::size_t slot) const {
        return parents_row() + static_cast<std::int64_t>(slot);
    }

    SearchSettings settings_;
    SearchSpace space_;
    std::uint64_t seed_;
    std::map<std::size_t, Niche> niches_;  //!< niches by cell
    std::vector<const Leader*> leaders_;   //!< leaders of all niches, by cell
    //! The plants to be re-evaluated in the next generation, with their cells;
    //! a leader precedes its challenger.
    std::vector<Candidate> repeats_;
    std::vector<std::size_t> cells_;
};

}  // namespace

std::size_t count_cells(const std::vector<AtlasAxis>& axes) {
    std::size_t cells = 1;
    for (const AtlasAxis& axis : axes)
        cells *= static_cast<std::size_t>(axis.cells);
    return cells;
}

std::unique_ptr<GenerationalOptimizer> make_atlas(
    const SearchSettings& settings, SearchSpace space, std::uint64_t seed) {
    return std::make_unique<Atlas>(settings, std::move(space), seed);
}

}  // namespace ideotype
