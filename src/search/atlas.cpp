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

//! A part of the atlas: the best known plant of one kind and a plant that seems
//! better, until both have been evaluated in one generation.
struct Niche {
    Leader leader;
    std::optional<Leader> challenger;
};

//! Finds the best plant of each kind: MAP-Elites (Mouret and Clune 2015,
//! arXiv:1504.04909) for objectives with noise. Kinds are the cells of a grid
//! over features such as leaf area and height; plants outside the grid are left
//! out. Generation 0 is that of GeneticAlgorithm. Later generations are
//! children of leaders that are drawn evenly. One evaluation cannot tell a
//! better plant from a lucky one: a plant above the mean of a leader challenges
//! the leader, and replaces it if it also wins in the next generation, in which
//! both share random numbers. Leaders with the fewest evaluations are evaluated
//! again, so that none stays by luck (adaptive sampling: Justesen et al. 2019,
//! doi:10.1145/3319619.3321904).
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
        if (slot < again_.size()) return again_[slot];
        if (leaders_.empty()) return founder(space_, seed_, generation(), slot);
        RandomStream stream(seed_, Purpose::selection, generation(), slot);
        const auto any = [&]() -> const Leader& {
            return *leaders_[stream.below(
                static_cast<std::uint32_t>(leaders_.size()))];
        };
        const Leader& mother = any();
        const Leader& father = any();
        return {child(mother.individual.candidate.genome,
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
        for (const Leader* each : sorted)
            if (best.size() < count) best.push_back(again(*each));
        return best;
    }

  private:
    //! Moves a plant along the line to another, and a little in any direction
    //! (Vassiliades and Mouret 2018, doi:10.1145/3205455.3205602). The line
    //! preserves features that both leaders share.
    Genome child(const Genome& from, const Genome& to, std::uint32_t slot) {
        // Step relative to the range of a gene.
        constexpr double everywhere = 0.01;
        // Step relative to the way to the other plant.
        constexpr double along_line = 0.2;
        RandomStream stream(seed_, Purpose::mutation, generation(), slot);
        const double way = along_line * stream.normal()[0];
        Genome genome = from;
        for (std::size_t i = 0; i < genome.size(); ++i) {
            const Gene& gene = space_.genes[i];
            const double step =
                everywhere * (gene.upper - gene.lower) * stream.normal()[0];
            if (gene.is_free)
                genome[i] =
                    within(gene, from[i] + step +
                                     way * difference(gene, from[i], to[i]));
        }
        return genome;
    }

    void take(Population evaluated) override {
        judge(evaluated);
        for (std::size_t i = again_.size(); i < evaluated.size(); ++i)
            place(evaluated[i], row_of(i));
        leaders_.clear();
        for (const auto& [cell, niche] : niches_)
            leaders_.push_back(&niche.leader);
        plan();
    }

    //! Compares challengers with their leaders, and updates the figures of
    //! other leaders. A failure is a loss.
    void judge(const Population& evaluated) {
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            Niche& niche = niches_.at(cells_[i]);
            const bool is_duel =
                i + 1 < cells_.size() && cells_[i + 1] == cells_[i];
            add(niche.leader, evaluated[i], row_of(i));
            if (!is_duel) continue;
            const Individual& own = evaluated[i];
            const Individual& rival = evaluated[++i];
            if (is_better(rival, own, space_.senses.front()))
                niche.leader = first_seen(rival, row_of(i));
            niche.challenger.reset();
        }
    }

    //! Makes a feasible plant the leader of an empty niche, or a challenger of
    //! its leader.
    void place(const Individual& plant, std::int64_t row) {
        const auto cell = cell_of(plant);
        if (!cell) return;
        const auto [at, is_new] =
            niches_.try_emplace(*cell, Niche{first_seen(plant, row), {}});
        if (is_new) return;
        std::optional<Leader>& challenger = at->second.challenger;
        const double bar =
            challenger ? challenger->mean() : at->second.leader.mean();
        if (exceeds(plant.objectives.front().mean, bar))
            challenger = first_seen(plant, row);
    }

    //! Chooses the plants to evaluate again: up to half of a generation are
    //! leaders with challengers, up to an eighth other leaders, those with the
    //! fewest evaluations first.
    void plan() {
        again_.clear();
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
            if (again_.size() + 2 > next_size() / 2) break;
            const Niche& niche = niches_.at(cell);
            cells_.insert(cells_.end(), 2, cell);
            again_.push_back(again(niche.leader));
            again_.push_back(again(*niche.challenger));
        }
        const std::size_t most = again_.size() + next_size() / 8;
        for (const auto& [evaluations, cell] : others) {
            if (again_.size() >= most) break;
            cells_.push_back(cell);
            again_.push_back(again(niches_.at(cell).leader));
        }
    }

    //! Returns the cell of a plant that meets all constraints.
    std::optional<std::size_t> cell_of(const Individual& plant) const {
        if (plant.status != Status::done || plant.violation > 0) return {};
        IDEOTYPE_EXPECT(plant.features.size() == settings_.axes.size());
        std::size_t cell = 0;
        for (std::size_t i = 0; i < settings_.axes.size(); ++i) {
            const AtlasAxis& axis = settings_.axes[i];
            const double place = (plant.features[i] - axis.range.lower) /
                                 (axis.range.upper - axis.range.lower) *
                                 axis.cells;
            if (!(place >= 0 && place < axis.cells)) return {};
            cell = cell * static_cast<std::size_t>(axis.cells) +
                   static_cast<std::size_t>(place);
        }
        return cell;
    }

    static Leader first_seen(const Individual& plant, std::int64_t row) {
        return {plant, row, plant.objectives.front().mean, 1};
    }

    static void add(Leader& leader, const Individual& again, std::int64_t row) {
        if (again.status != Status::done) return;
        leader.sum += again.objectives.front().mean;
        ++leader.evaluations;
        leader.row = row;
    }

    static Candidate again(const Leader& leader) {
        return {leader.individual.candidate.genome,
                Origin::elite,
                {leader.row, no_parent}};
    }

    bool exceeds(double a, double b) const {
        return is_better(a, b, space_.senses.front());
    }

    std::int64_t row_of(std::size_t slot) const {
        return parents_row() + static_cast<std::int64_t>(slot);
    }

    SearchSettings settings_;
    SearchSpace space_;
    std::uint64_t seed_;
    std::map<std::size_t, Niche> niches_;  //!< niches by cell
    std::vector<const Leader*> leaders_;   //!< leaders of all niches, by cell
    //! The plants that the next generation evaluates again, with their cells, a
    //! leader before its challenger.
    std::vector<Candidate> again_;
    std::vector<std::size_t> cells_;
};

}  // namespace

std::size_t count_cells(const std::vector<AtlasAxis>& axes) {
    std::size_t cells = 1;
    for (const AtlasAxis& each : axes)
        cells *= static_cast<std::size_t>(each.cells);
    return cells;
}

std::unique_ptr<GenerationalOptimizer> make_atlas(
    const SearchSettings& settings, SearchSpace space, std::uint64_t seed) {
    return std::make_unique<Atlas>(settings, std::move(space), seed);
}

}  // namespace ideotype
