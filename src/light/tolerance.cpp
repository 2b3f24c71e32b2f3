#include "ideotype/light/tolerance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "allocation.hpp"
#include "beam_costs.hpp"
#include "ideotype/light/report.hpp"

namespace ideotype {

namespace {

//! Of a trial at least: with so many the error is known to a fifth.
constexpr int trial_randomisations = 16;

//! Trials have randomisations that no result has.
constexpr std::uint32_t first_of_trials = 1u << 16;

//! A trial with less than the result by more than this is followed by another.
constexpr double longest_step = 8;

//! Suns of a trial that draws them. All their randomisations together tell the
//! variance.
constexpr std::size_t trial_suns = 4;

//! Powers with which variances fall. Nets converge a little faster than
//! independent rays.
constexpr double power_of_rays = 1, power_of_lattices = 1.4;

//! First hits of a sun from which on a lattice beats independent rays; a guess,
//! which a trial replaces.
constexpr double even_for_lattices = 30;

//! A trial that underestimates the error leads to too few paths. The expected
//! error stays within the tolerance if all estimates are multiplied by the
//! mean of sqrt(v / X), X from a chi-square distribution with v degrees of
//! freedom: 1 + 3 / (4 v) and a little.
double caution(int randomisations) {
    return 1 + 0.8 / (randomisations - 1);
}

Origin origin_of(const Source& source) {
    return source.direction ? Origin::beams : Origin::skies;
}

double squared(double x) {
    return x * x;
}

//! The simulations on the way to one result.
class Search {
  public:
    Search(const Scene& scene, const std::vector<Group>& groups,
           const Optics& optics, const Illumination& light,
           const Accuracy& accuracy, const Randomness& randomness,
           const Layers& layers, Detail detail)
        : scene_(scene),
          groups_(groups),
          optics_(optics),
          light_(light),
          accuracy_(accuracy),
          randomness_(randomness),
          layers_(layers),
          detail_(detail),
          energy_(light.energy()),
          trials_(std::max(trial_randomisations, accuracy.randomisations)) {}

    Simulation result() {
        Workload work = enough();
        Simulation found;
        found.tallies =
            simulate(scene_, groups_, optics_, light_, work,
                     accuracy_.randomisations, randomness_, layers_, detail_);
        for (const std::uint32_t hits : work.first_hits)
            found.paths += static_cast<int>(hits);
        found.work = std::move(work);
        const Estimate leaves = absorbed_by_leaves(found.tallies);
        found.is_capped = is_capped_ && leaves.standard_error >
                                            accuracy_.tolerance * leaves.mean;
        return found;
    }

  private:
    //! The workload that the tolerance asks for.
    Workload enough() {
        is_capped_ = false;
        Workload work{share_paths(light_, fewest()), {}};
        work.path_energy.assign(work.first_hits.size(), energy_ / fewest());
        const Amounts least = amounts_of(work);
        Amounts amounts = least;
        bool is_drawn = false;
        for (;;) {
            try_out(work, is_drawn);
            if (!(mean_ > 0)) {
                if (!is_open_) return work;
                // No path has met a leaf.
                amounts = scaled(amounts, longest_step);
                if (is_beyond(amounts)) {
                    is_capped_ = true;
                    return {share_paths(light_, most()), {}};
                }
                work = work_of(amounts);
                continue;
            }
            Amounts enough = cheapest(laws_, is_drawn, least);
            if (!is_drawn && pays_to_draw(enough, least)) {
                is_drawn = true;
                enough = cheapest(guess(), true, least);
                amounts = drawn_trial(enough);
            } else if (is_drawn &&
                       enough[index(Origin::beams)] <=
                           longest_step / 2 * amounts[index(Origin::beams)]) {
                is_capped_ = is_beyond(enough);
                return work_of(is_capped_ ? capped(enough) : enough);
            } else {
                const Amounts next = scaled(enough, 1 / step());
                if (cost(next, is_drawn) <= cost(amounts, is_drawn) ||
                    is_beyond(next)) {
                    is_capped_ = is_beyond(enough);
                    return work_of(is_capped_ ? capped(enough) : enough);
                }
                amounts = is_drawn ? drawn_trial(enough) : next;
            }
            for (std::size_t o = 0; o < origins; ++o)
                amounts[o] = std::max(amounts[o], least[o]);
            work = work_of(is_beyond(amounts) ? capped(amounts) : amounts);
            if (is_drawn) leave_suns_out(work);
        }
    }

    //! From the amounts of a trial, which may have more randomisations than the
    //! result, to those of the result.
    double step() const {
        return longest_step * trials_ / accuracy_.randomisations;
    }

    //! Drawing takes about as long with few points as with many.
    Amounts drawn_trial(const Amounts& enough) const {
        Amounts amounts = scaled(enough, 1 / step());
        amounts[index(Origin::beams)] = enough[index(Origin::beams)] / 2;
        return amounts;
    }

    //! First hits of the first trial, and of the result: one path for each
    //! source too.
    std::uint32_t fewest() const {
        std::uint32_t paths = fewest_paths;
        while (paths < light_.sources.size()) paths *= 2;
        return std::min(paths, most());
    }

    std::uint32_t most() const {
        return static_cast<std::uint32_t>(accuracy_.paths);
    }

    static double first_hits(const Amounts& amounts) {
        return amounts[index(Origin::beams)] + amounts[index(Origin::skies)];
    }

    bool is_beyond(const Amounts& amounts) const {
        return first_hits(amounts) > most();
    }

    Amounts capped(const Amounts& amounts) const {
        return scaled(amounts, most() / first_hits(amounts));
    }

    Amounts amounts_of(const Workload& work) const {
        Amounts amounts{};
        for (std::size_t s = 0; s < work.first_hits.size(); ++s)
            amounts[index(origin_of(light_.sources[s]))] += work.first_hits[s];
        amounts[index(Origin::scattered)] = energy_ / work.path_energy.front();
        return amounts;
    }

    Workload work_of(const Amounts& amounts) const {
        Workload work;
        work.first_hits.resize(light_.sources.size());
        const double beams = amounts[index(Origin::beams)];
        for (const Origin origin : {Origin::beams, Origin::skies}) {
            Illumination part;
            for (const Source& source : light_.sources)
                if (origin_of(source) == origin) part.sources.push_back(source);
            if (part.sources.empty()) continue;
            // What rounding takes from beams, skies get.
            const double others = origin == Origin::beams ? 0 : beams;
            const double hits =
                std::max(std::round(others + amounts[index(origin)]) -
                             std::round(others),
                         static_cast<double>(part.sources.size()));
            const auto shares =
                share_paths(part, static_cast<std::uint32_t>(hits));
            std::size_t next = 0;
            for (std::size_t s = 0; s < light_.sources.size(); ++s)
                if (origin_of(light_.sources[s]) == origin)
                    work.first_hits[s] = shares[next++];
        }
        work.path_energy.assign(light_.sources.size(),
                                energy_ / amounts[index(Origin::scattered)]);
        return work;
    }

    //! Keeps a few suns, evenly over the day.
    void leave_suns_out(Workload& work) const {
        std::vector<std::size_t> suns;
        for (std::size_t s = 0; s < light_.sources.size(); ++s)
            if (light_.sources[s].direction) suns.push_back(s);
        if (suns.size() <= trial_suns) return;
        std::vector<bool> is_kept(light_.sources.size());
        for (std::size_t i = 0; i < trial_suns; ++i)
            is_kept[suns[(2 * i + 1) * suns.size() / (2 * trial_suns)]] = true;
        for (const std::size_t s : suns)
            if (!is_kept[s]) work.first_hits[s] = 0;
    }

    //! Simulates a trial and learns from it how variances fall.
    void try_out(const Workload& work, bool is_drawn) {
        Randomness numbers = randomness_;
        numbers.first_randomisation += ++trial_ * first_of_trials;
        const std::vector<Tally> tallies = simulate(
            scene_, groups_, optics_, light_, work, trials_, numbers, layers_);
        const Budget all = sum_of(tallies);
        const double caught =
            all.sent_on > 0 ? (all.leaves - all.unscattered) / all.sent_on : 0;
        const Suns suns(light_, work);
        Amounts amounts = amounts_of(work);
        amounts[index(Origin::beams)] *= suns.by_energy;
        ByOrigin<double> variance{};
        for (std::size_t s = 0; s < work.first_hits.size(); ++s) {
            if (work.first_hits[s] == 0) continue;
            const auto [first, next] = variances(tallies, s, caught);
            const Origin origin = origin_of(light_.sources[s]);
            const bool is_beam = origin == Origin::beams;
            variance[index(origin)] += first * (is_beam ? suns.by_root : 1);
            variance[index(Origin::scattered)] +=
                next * (is_beam ? suns.by_energy : 1);
        }
        for (std::size_t o = 0; o < origins; ++o)
            laws_[o] = {std::max(1., amounts[o]), variance[o], power_of_rays};
        if (is_drawn) laws_[index(Origin::beams)].power = power_of_lattices;

        double rays = 0;
        for (const Tally& tally : tallies)
            rays += static_cast<double>(tally.next_rays);
        rays_per_unit_ =
            rays * energy_ / (all.incident * amounts[index(Origin::scattered)]);
        if (suns.by_energy == 1) {
            mean_ = all.leaves / trials_;
            is_open_ = tallies.front().resolution->leaves;
        }
    }

    static Budget sum_of(const std::vector<Tally>& tallies) {
        Budget sum;
        for (const Tally& tally : tallies)
            for (const Budget& budget : tally.sources) sum += budget;
        return sum;
    }

    //! By what the variance of a few suns is multiplied for that of all: it
    //! grows with the energy if first hits in proportion to that are
    //! independent, and with its root if they are a lattice's.
    struct Suns {
        Suns(const Illumination& light, const Workload& work) {
            double energy = 0, kept_energy = 0, roots = 0, kept_roots = 0;
            for (std::size_t s = 0; s < work.first_hits.size(); ++s) {
                const Source& sun = light.sources[s];
                if (!sun.direction) continue;
                const double root = std::sqrt(sun.energy);
                energy += sun.energy;
                roots += root;
                if (work.first_hits[s] == 0) continue;
                kept_energy += sun.energy;
                kept_roots += root;
            }
            if (kept_energy < energy) {
                by_energy = energy / kept_energy;
                by_root = roots / kept_roots;
            }
        }

        double by_energy = 1, by_root = 1;
    };

    struct Variances {
        double first, next;
    };

    //! Of the leaves' light of a source in one randomisation: by what is met
    //! first, each surface of which sends the same part of the scattered light
    //! to leaves; and by what becomes of scattered light beyond that.
    static Variances variances(const std::vector<Tally>& tallies,
                               std::size_t source, double caught) {
        std::vector<double> first, next;
        for (const Tally& tally : tallies) {
            const Budget& budget = tally.sources[source];
            first.push_back(budget.unscattered + caught * budget.sent_on);
            next.push_back(budget.leaves - first.back());
        }
        const auto n = static_cast<double>(tallies.size());
        return {squared(estimate(first).standard_error) * n,
                squared(estimate(next).standard_error) * n};
    }

    static constexpr std::size_t index(Origin origin) {
        return static_cast<std::size_t>(origin);
    }

    //! Of one more in every randomisation of the result [us].
    ByOrigin<double> costs(bool is_drawn) const {
        ByOrigin<double> all{Costs::ray, Costs::ray,
                             Costs::ray * rays_per_unit_};
        if (is_drawn) all[index(Origin::beams)] = Costs::point;
        for (double& cost : all) cost *= accuracy_.randomisations;
        return all;
    }

    //! Of the result [us].
    double cost(const Amounts& amounts, bool is_drawn) const {
        const ByOrigin<double> each = costs(is_drawn);
        double sum = 0;
        for (std::size_t o = 0; o < origins; ++o)
            if (!is_drawn || o != index(Origin::beams))
                sum += each[o] * amounts[o];
        if (!is_drawn) return sum;
        const Workload work = work_of(amounts);
        for (std::size_t s = 0; s < light_.sources.size(); ++s)
            if (light_.sources[s].direction)
                sum += cost_of_drawing(scene_, *light_.sources[s].direction,
                                       work.first_hits[s],
                                       accuracy_.randomisations);
        return sum;
    }

    //! What drawing the beams would need.
    ByOrigin<Law> guess() const {
        ByOrigin<Law> laws = laws_;
        Law& law = laws[index(Origin::beams)];
        const double even =
            even_for_lattices *
            static_cast<double>(std::count_if(
                light_.sources.begin(), light_.sources.end(),
                [](const Source& s) { return s.direction.has_value(); }));
        law = {even, law.at(even), power_of_lattices};
        return laws;
    }

    bool pays_to_draw(const Amounts& by_rays, const Amounts& least) const {
        if (scene_.boundary() != Boundary::periodic ||
            laws_[index(Origin::beams)].variance == 0)
            return false;
        // A trial is drawn too.
        constexpr double with_trial = 1.3;
        return cost(cheapest(guess(), true, least), true) * with_trial <
               cost(by_rays, false);
    }

    //! The cheapest amounts that meet the tolerance.
    Amounts cheapest(const ByOrigin<Law>& laws, bool is_drawn,
                     const Amounts& least) const {
        const double wanted = accuracy_.tolerance / caution(trials_) * mean_;
        Amounts amounts = allocate(laws, costs(is_drawn),
                                   squared(wanted) * accuracy_.randomisations);
        // Nothing is known more finely than to one path.
        const double coarsest =
            1 / (accuracy_.tolerance * accuracy_.randomisations);
        const double part = coarsest / first_hits(least);
        for (const Origin origin : {Origin::beams, Origin::skies})
            amounts[index(origin)] =
                std::max(amounts[index(origin)], part * least[index(origin)]);
        amounts[index(Origin::scattered)] =
            std::max(amounts[index(Origin::scattered)], coarsest);
        for (std::size_t o = 0; o < origins; ++o)
            amounts[o] = std::max(amounts[o], least[o]);
        return amounts;
    }

    const Scene& scene_;
    const std::vector<Group>& groups_;
    const Optics& optics_;
    const Illumination& light_;
    const Accuracy& accuracy_;
    const Randomness& randomness_;
    const Layers& layers_;
    Detail detail_;
    double energy_;
    int trials_;
    std::uint32_t trial_ = 0;
    bool is_capped_ = false;

    // What trials have shown.
    ByOrigin<Law> laws_{};
    double mean_ = 0;           //!< light of leaves
    bool is_open_ = false;      //!< whether it depends on paths
    double rays_per_unit_ = 0;  //!< of the amount of scattered light
};

}  // namespace

Simulation simulate_to_tolerance(
    const Scene& scene, const std::vector<Group>& groups, const Optics& optics,
    const Illumination& illumination, const Accuracy& accuracy,
    const Randomness& randomness, const Layers& layers, Detail detail) {
    if (accuracy.tolerance > 0 && !illumination.sources.empty())
        return Search(scene, groups, optics, illumination, accuracy, randomness,
                      layers, detail)
            .result();
    return {simulate(scene, groups, optics, illumination, accuracy, randomness,
                     layers, detail),
            accuracy.paths,
            false,
            {}};
}

}  // namespace ideotype
