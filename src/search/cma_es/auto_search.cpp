// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "arm.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/random.hpp"
#include "search/optimizer.hpp"
#include "search/order.hpp"
#include "search/quadratic/surface_arm.hpp"

namespace ideotype {

namespace {

//! Returns whether response surfaces suit a space: they describe one objective
//! of real genes, without constraints.
bool suits_surfaces(const SearchSpace& space,
                    const UnboundedGenes& coordinates) {
    const auto is_discrete = [&](std::size_t gene) {
        return space.genes[gene].is_discrete();
    };
    return space.senses.size() == 1 && !space.is_constrained &&
           !coordinates.free().empty() && coordinates.choices().empty() &&
           std::ranges::none_of(coordinates.free(), is_discrete);
}

//! Repeats cycles of searches by dd-CMA-ES. A cycle begins with a design of
//! three parts: the champion, which is the baseline at first; mixtures, which
//! take each trait from the champion with probability one half; and plants
//! uniform within the bounds. One arm starts from the best mixture, another
//! from the best uniform plant. They race for some generations, each with half
//! of the plants; then the arm with the better results continues alone. When it
//! no longer gains, its number of plants is doubled, up to four populations,
//! since noise may hide gains. The next cycle uses 1.5 times as many plants;
//! its champion is the plant at which this cycle ends.
//!
//! If response surfaces suit the space, the first cycle has no race. It begins
//! with some generations of a SurfaceArm at the champion, and an arm of
//! dd-CMA-ES, with all plants, continues from its centre with its deviations.
class AutoSearch : public GenerationalOptimizer {
  public:
    AutoSearch(const SearchSettings& settings, SearchSpace space,
               std::uint64_t seed)
        : settings_(settings),
          space_(std::move(space)),
          coordinates_(space_.genes),
          seed_(seed),
          population_(static_cast<std::size_t>(settings.population)),
          champion_(settings.start.empty() ? space_.baseline : settings.start) {
        if (suits_surfaces(space_, coordinates_))
            surface_.emplace(coordinates_, champion_, population_ / 3);
    }

    std::size_t next_size() const override {
        if (surface_) return surface_->size();
        if (arms_.empty()) return design_size();
        std::size_t size = 0;
        for (const Arm& arm : arms_) size += arm.population();
        return size;
    }

    Candidate candidate(std::uint32_t slot) override {
        IDEOTYPE_EXPECT(slot < next_size());
        if (generation() == 0 && slot == 0)
            return {champion_, Origin::baseline};
        if (surface_)
            return surface_->candidate(seed_, generation(), slot,
                                       space_.baseline);
        if (arms_.empty()) return propose_design(slot);
        // Find the arm of the slot.
        std::uint32_t first = 0;
        auto arm = arms_.begin();
        for (; slot - first >= arm->population(); ++arm)
            first += static_cast<std::uint32_t>(arm->population());
        return arm->candidate(seed_, generation(), first, slot - first,
                              space_.baseline);
    }

    //! Returns the mean plants of the running arms and of earlier cycles,
    //! better results first, or the centre of the surfaces, followed by the
    //! best plants of the last generation.
    std::vector<Candidate> best(std::size_t count) const override {
        std::vector<Champion> means = champions_;
        for (const Arm& arm : arms_)
            if (!arm.course().empty()) means.push_back(make_champion(arm));
        std::stable_sort(means.begin(), means.end(),
                         [&](const Champion& a, const Champion& b) {
                             return is_better(a.value, b.value,
                                              space_.senses.front());
                         });
        std::vector<Candidate> candidates;
        if (surface_)
            candidates.push_back(surface_->centre(space_.baseline));
        else if (means.empty() && arms_.size() == 1)
            candidates.push_back(arms_.front().centre(space_.baseline));
        for (Champion& champion : means)
            candidates.push_back({std::move(champion.genome), Origin::sample});
        for (const Candidate& candidate :
             select_best(last_, count, space_.senses, parents_row()))
            candidates.push_back(candidate);
        candidates.resize(std::min(count, candidates.size()));
        return candidates;
    }

  private:
    //! The plant at the mean of a distribution, with the result of the last
    //! generation drawn from it.
    struct Champion {
        Genome genome;
        double value = 0;
    };
    Champion make_champion(const Arm& arm) const {
        return {arm.centre(space_.baseline).genome, arm.course().back()};
    }

    //! Largest standard deviations, relative to the range of a gene. Below
    //! `tiny` the values no longer change; below `narrow` an arm that gains
    //! nothing has converged.
    static constexpr double tiny = 1e-11, narrow = 1e-6;
    //! Largest population of an arm, in halves of the population.
    static constexpr std::size_t most_growth = 8;

    //! Returns the number of rows of the design. The champion and the
    //! mixtures are its first half.
    std::size_t design_size() const { return auto_design * population_; }
    std::size_t last_mixture() const { return design_size() / 2; }

    Candidate propose_design(std::uint32_t slot) const {
        if (slot == 0) return {champion_, Origin::elite};
        Genome genome = random_genome(space_, seed_, generation(), slot);
        if (slot < last_mixture()) mix(genome, slot);
        return {std::move(genome), Origin::random};
    }

    //! Replaces each trait by that of the champion with probability one half.
    void mix(Genome& genome, std::uint32_t slot) const {
        RandomStream stream(seed_, Purpose::selection, generation(), slot);
        std::map<std::string, bool> is_kept;
        for (std::size_t i = 0; i < genome.size(); ++i) {
            const Gene& gene = space_.genes[i];
            if (!gene.is_free) continue;
            const auto [trait, is_new] = is_kept.try_emplace(gene.trait);
            if (is_new) trait->second = stream.uniform() < 0.5;
            if (trait->second) genome[i] = champion_[i];
        }
    }

    void take(Population evaluated) override {
        if (surface_)
            learn_surface(evaluated);
        else if (arms_.empty())
            begin_race(evaluated);
        else
            learn_race(evaluated);
        last_ = std::move(evaluated);
    }

    void learn_surface(const Population& rows) {
        constexpr std::size_t most = 10;  // generations
        // Callers may find constraints that they did not announce.
        if (std::ranges::any_of(
                rows, [](const Individual& row) { return row.violation > 0; }))
            return surface_.reset();
        surface_->learn(rows, space_.senses.front(), seed_, generation());
        if (surface_->generations() < most) return;
        arms_.emplace_back(coordinates_, surface_->mean(),
                           surface_->deviations(), population_);
        surface_.reset();
    }

    void begin_race(const Population& design) {
        const auto middle =
            design.begin() + static_cast<std::ptrdiff_t>(last_mixture());
        const auto begin_at_best = [&](auto first, auto last) {
            const Population part(first, last);
            const Genome& start =
                part[ranking(part, space_.senses).front()].candidate.genome;
            arms_.emplace_back(coordinates_, start, population_ / 2);
        };
        begin_at_best(design.begin(), middle);
        begin_at_best(middle, design.end());
    }

    void learn_race(const Population& rows) {
        // Rows are stored arm after arm.
        auto first = rows.begin();
        for (Arm& arm : arms_) {
            const auto last =
                first + static_cast<std::ptrdiff_t>(arm.population());
            arm.learn({first, last}, space_.senses, seed_, generation(),
                      static_cast<std::uint32_t>(first - rows.begin()));
            first = last;
        }
        constexpr std::size_t race = 15, judged = 4;
        const Sense sense = space_.senses.front();
        const std::size_t generations = arms_.front().course().size();
        // The race ends: only the arm with the better last generations remains.
        if (arms_.size() > 1 && generations >= race) {
            const auto result = [&](const Arm& arm) {
                return average(std::span(arm.course()).last(judged));
            };
            const bool is_second_better =
                is_better(result(arms_[1]), result(arms_[0]), sense);
            arms_.erase(arms_.begin() + (is_second_better ? 0 : 1));
        }
        if (arms_.size() > 1) return;
        Arm& arm = arms_.front();
        if (arm.extent() > tiny) {
            if (!arm.gains_nothing(sense)) return;
            // Noise may hide gains, which larger generations can reveal.
            if (arm.extent() > narrow &&
                arm.population() < most_growth * population_ / 2)
                return arm.grow();
        }
        // The cycle ends. The mean of the arm is the next champion.
        champions_.push_back(make_champion(arm));
        champion_ = champions_.back().genome;
        arms_.clear();
        population_ += population_ / 2;
    }

    SearchSettings settings_;
    SearchSpace space_;
    UnboundedGenes coordinates_;
    std::uint64_t seed_;
    std::size_t population_;  //!< plants per generation of two arms
    Genome champion_;
    std::vector<Champion> champions_;  //!< champions of earlier cycles
    //! The search by response surfaces with which the first cycle begins.
    std::optional<SurfaceArm> surface_;
    std::vector<Arm> arms_;  //!< running searches; if none, a design is next
    Population last_;
};

}  // namespace

std::unique_ptr<GenerationalOptimizer> make_auto_search(
    const SearchSettings& settings, SearchSpace space, std::uint64_t seed) {
    return std::make_unique<AutoSearch>(settings, std::move(space), seed);
}

}  // namespace ideotype
