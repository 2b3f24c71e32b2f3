// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "dd_cma.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/random.hpp"
#include "optimizer.hpp"
#include "order.hpp"
#include "unbounded_genes.hpp"

namespace ideotype {

namespace {

using Eigen::VectorXd;

VectorXd to_vector(const std::vector<double>& x) {
    return Eigen::Map<const VectorXd>(x.data(),
                                      static_cast<Eigen::Index>(x.size()));
}

//! Returns independent standard normal numbers.
VectorXd standard_normal(RandomStream stream, std::size_t size) {
    VectorXd x(static_cast<Eigen::Index>(size));
    for (Eigen::Index i = 0; i < x.size(); i += 2) {
        const auto [first, second] = stream.normal();
        x[i] = first;
        if (i + 1 < x.size()) x[i + 1] = second;
    }
    return x;
}

//! Returns the mean of objective 0 over the better half of some rows; worse
//! than any other if none of these succeeded and meets all constraints.
double better_half(const Population& rows, const std::vector<Sense>& senses) {
    IDEOTYPE_EXPECT(!rows.empty());
    const std::size_t half = (rows.size() + 1) / 2;
    double sum = 0;
    std::size_t count = 0;
    const std::vector<std::uint32_t> order = ranking(rows, senses);
    for (std::size_t i = 0; i < half; ++i) {
        const Individual& each = rows[order[i]];
        if (each.status == Status::failed || each.violation > 0) break;
        sum += each.objectives.front().mean;
        ++count;
    }
    if (count > 0) return sum / static_cast<double>(count);
    const double worst = std::numeric_limits<double>::infinity();
    return senses.front() == Sense::maximise ? -worst : worst;
}

double mean_of(const double* values, std::size_t count) {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += values[i];
    return sum / static_cast<double>(count);
}

//! A search by dd-CMA-ES over the UnboundedGenes of the free genes. Plants are
//! ranked as by is_better(), so that those that meet the constraints come
//! first.
class Arm {
  public:
    Arm(const UnboundedGenes& coordinates, const Genome& start, double step,
        std::size_t population)
        : population_(population),
          distribution_(to_vector(coordinates.of(start)),
                        step * to_vector(coordinates.first_steps()),
                        population) {}

    std::size_t population() const { return population_; }
    const DdCma& distribution() const { return distribution_; }
    //! Returns the mean over the better half of each generation, see
    //! better_half().
    const std::vector<double>& course() const { return course_; }

    //! Returns the point of one of its plants in a generation, where `slot` is
    //! the slot of its first plant. The point is drawn when it is first asked
    //! for.
    const VectorXd& point(std::uint64_t seed, std::uint32_t generation,
                          std::uint32_t slot, std::size_t plant) {
        IDEOTYPE_EXPECT(plant < population_);
        points_.resize(population_);
        VectorXd& x = points_[plant];
        if (x.size() == 0)
            x = distribution_.sample(standard_normal(
                RandomStream(seed, Purpose::sample, generation,
                             slot + static_cast<std::uint32_t>(plant)),
                static_cast<std::size_t>(distribution_.mean().size())));
        return x;
    }

    void grow() {
        population_ *= 2;
        distribution_.set_population(population_);
        course_.clear();
    }

    //! Learns from the rows of its plants; the arguments are as in point().
    void learn(const Population& rows, const std::vector<Sense>& senses,
               std::uint64_t seed, std::uint32_t generation,
               std::uint32_t slot) {
        IDEOTYPE_EXPECT(rows.size() == population_);
        const std::vector<std::uint32_t> order = ranking(rows, senses);
        Eigen::MatrixXd ranked(distribution_.mean().size(), order.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            ranked.col(static_cast<Eigen::Index>(i)) =
                point(seed, generation, slot, order[i]);
        distribution_.update(ranked);
        points_.clear();
        course_.push_back(better_half(rows, senses));
    }

    double extent() const { return distribution_.deviations().maxCoeff(); }

    //! Returns whether the last generations are not better than as many before
    //! them by more than the standard error of that difference.
    bool gains_nothing(Sense sense) const {
        constexpr std::size_t window = 20;
        if (course_.size() < 2 * window) return false;
        const double* last = course_.data() + course_.size() - window;
        const double* before = last - window;
        const double now = mean_of(last, window);
        const double then = mean_of(before, window);
        double squares = 0;
        for (std::size_t i = 0; i < window; ++i)
            squares += (last[i] - now) * (last[i] - now) +
                       (before[i] - then) * (before[i] - then);
        const double error =
            std::sqrt(squares / static_cast<double>(window * (window - 1)));
        const double gain = sense == Sense::maximise ? now - then : then - now;
        return !(gain > error);
    }

  private:
    std::size_t population_;
    DdCma distribution_;
    std::vector<VectorXd> points_;  //!< drawn so far, of the next generation
    std::vector<double> course_;
};

//! A search by dd-CMA-ES that begins at the start or the baseline.
class CmaEs : public GenerationalOptimizer {
  public:
    CmaEs(const SearchSettings& settings, SearchSpace space, std::uint64_t seed)
        : space_(std::move(space)),
          coordinates_(space_.genes),
          seed_(seed),
          arm_(coordinates_,
               settings.start.empty() ? space_.baseline : settings.start,
               settings.step, static_cast<std::size_t>(settings.population)) {}

    std::size_t next_size() const override { return arm_.population(); }

    Candidate candidate(std::uint32_t slot) override {
        return sample(arm_.point(seed_, generation(), 0, slot));
    }

    //! Returns the plant at the mean of the distribution, then the best of the
    //! last generation.
    std::vector<Candidate> best(std::size_t count) const override {
        IDEOTYPE_EXPECT(count > 0);
        std::vector<Candidate> candidates{sample(arm_.distribution().mean())};
        for (const Candidate& each :
             best_of(last_, count - 1, space_.senses, parents_row()))
            candidates.push_back(each);
        return candidates;
    }

  private:
    void take(Population evaluated) override {
        arm_.learn(evaluated, space_.senses, seed_, generation(), 0);
        last_ = std::move(evaluated);
    }

    Candidate sample(const VectorXd& x) const {
        return {coordinates_.genome({x.begin(), x.end()}, space_.baseline),
                Origin::sample};
    }

    SearchSpace space_;
    UnboundedGenes coordinates_;
    std::uint64_t seed_;
    Arm arm_;
    Population last_;
};

//! Cycles of searches by dd-CMA-ES. A cycle begins with a design: the champion,
//! which is the baseline at first, mixtures that have each trait of the
//! champion with probability one half, and plants uniform within the bounds.
//! One arm begins at the best mixture, another at the best uniform plant. They
//! race for some generations, of which each has half; then the one whose
//! better halves were better goes on alone. When it no longer gains, it goes on
//! with twice the plants, up to eight times as many, since noise may hide what
//! is left to gain. After that a cycle with 1.5 times the plants begins, whose
//! champion is where the last one ended.
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
    }

    std::size_t next_size() const override {
        if (arms_.empty()) return design_size();
        std::size_t size = 0;
        for (const Arm& arm : arms_) size += arm.population();
        return size;
    }

    Candidate candidate(std::uint32_t slot) override {
        IDEOTYPE_EXPECT(slot < next_size());
        if (arms_.empty()) return of_design(slot);
        std::uint32_t first = 0;
        auto arm = arms_.begin();
        for (; slot - first >= arm->population(); ++arm)
            first += static_cast<std::uint32_t>(arm->population());
        return sample(arm->point(seed_, generation(), first, slot - first));
    }

    //! Returns the plants at the means of arms and of earlier cycles, those of
    //! the better generations first, then the best of the last generation.
    std::vector<Candidate> best(std::size_t count) const override {
        std::vector<Champion> means = champions_;
        for (const Arm& arm : arms_)
            if (!arm.course().empty()) means.push_back(champion_of(arm));
        std::stable_sort(means.begin(), means.end(),
                         [&](const Champion& a, const Champion& b) {
                             return is_better(a.value, b.value,
                                              space_.senses.front());
                         });
        std::vector<Candidate> candidates;
        for (Champion& each : means)
            candidates.push_back({std::move(each.genome), Origin::sample});
        for (const Candidate& each :
             best_of(last_, count, space_.senses, parents_row()))
            candidates.push_back(each);
        candidates.resize(std::min(count, candidates.size()));
        return candidates;
    }

  private:
    //! The plant at the mean of a search, and how good its last generation was.
    struct Champion {
        Genome genome;
        double value = 0;
    };
    Champion champion_of(const Arm& arm) const {
        return {sample(arm.distribution().mean()).genome, arm.course().back()};
    }

    //! The largest standard deviations, relative to the range of a gene, at
    //! which no number changes any more, and at which no gain means
    //! convergence.
    static constexpr double tiny = 1e-11, narrow = 1e-6;
    //! The most by which the population of an arm is multiplied.
    static constexpr std::size_t most_growth = 8;

    //! Returns the rows of the design; the first half of them are mixtures.
    std::size_t design_size() const { return 3 * population_; }
    std::size_t last_mixture() const { return design_size() / 2; }

    Candidate of_design(std::uint32_t slot) const {
        if (slot == 0)
            return {champion_,
                    generation() == 0 ? Origin::baseline : Origin::elite};
        Genome genome = random_genome(space_, seed_, generation(), slot);
        if (slot < last_mixture()) mix(genome, slot);
        return {std::move(genome), Origin::random};
    }

    void mix(Genome& genome, std::uint32_t slot) const {
        RandomStream stream(seed_, Purpose::selection, generation(), slot);
        std::map<std::string, bool> kept;
        for (std::size_t i = 0; i < genome.size(); ++i) {
            const Gene& gene = space_.genes[i];
            if (!gene.is_free) continue;
            const auto [trait, is_new] = kept.try_emplace(gene.trait);
            if (is_new) trait->second = stream.uniform() < 0.5;
            if (trait->second) genome[i] = champion_[i];
        }
    }

    void take(Population evaluated) override {
        if (arms_.empty())
            begin_race(evaluated);
        else
            learn_race(evaluated);
        last_ = std::move(evaluated);
    }

    void begin_race(const Population& design) {
        const auto middle =
            design.begin() + static_cast<std::ptrdiff_t>(last_mixture());
        const auto begin_at_best = [&](auto first, auto last) {
            const Population part(first, last);
            const Genome& start =
                part[ranking(part, space_.senses).front()].candidate.genome;
            arms_.emplace_back(coordinates_, start, settings_.step,
                               population_ / 2);
        };
        begin_at_best(design.begin(), middle);
        begin_at_best(middle, design.end());
    }

    void learn_race(const Population& rows) {
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
        if (arms_.size() > 1 && generations >= race) {
            const auto result = [&](const Arm& arm) {
                return mean_of(&arm.course()[generations - judged], judged);
            };
            const bool is_second_better =
                is_better(result(arms_[1]), result(arms_[0]), sense);
            arms_.erase(arms_.begin() + (is_second_better ? 0 : 1));
        }
        if (arms_.size() > 1) return;
        Arm& arm = arms_.front();
        if (arm.extent() > tiny) {
            if (!arm.gains_nothing(sense)) return;
            // Noise hides what is left to gain: more plants tell more.
            if (arm.extent() > narrow &&
                arm.population() < most_growth * population_ / 2)
                return arm.grow();
        }
        champions_.push_back(champion_of(arm));
        champion_ = champions_.back().genome;
        arms_.clear();
        population_ += population_ / 2;
    }

    Candidate sample(const VectorXd& x) const {
        return {coordinates_.genome({x.begin(), x.end()}, space_.baseline),
                Origin::sample};
    }

    SearchSettings settings_;
    SearchSpace space_;
    UnboundedGenes coordinates_;
    std::uint64_t seed_;
    std::size_t population_;  //!< plants of a generation of two arms
    Genome champion_;
    std::vector<Champion> champions_;  //!< means of earlier cycles
    std::vector<Arm> arms_;  //!< searches that go on; none: a design is next
    Population last_;
};

}  // namespace

std::unique_ptr<GenerationalOptimizer> make_cma_es(
    const SearchSettings& settings, SearchSpace space, std::uint64_t seed) {
    return std::make_unique<CmaEs>(settings, std::move(space), seed);
}

std::unique_ptr<GenerationalOptimizer> make_auto_search(
    const SearchSettings& settings, SearchSpace space, std::uint64_t seed) {
    return std::make_unique<AutoSearch>(settings, std::move(space), seed);
}

}  // namespace ideotype
