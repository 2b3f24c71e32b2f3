// SPDX-License-Identifier: Apache-2.0
#include "ideotype/light/tolerance.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "ideotype/core/contract.hpp"
#include "ideotype/light/report.hpp"
#include "trial.hpp"
#include "workload.hpp"

namespace ideotype {

namespace {

//! The smallest number of randomisations of a trial. With 16, the relative
//! uncertainty of the error is a fifth.
constexpr int trial_randomisations = 16;

//! The number of the first randomisation of trials, beyond the numbers that
//! results use.
constexpr std::uint32_t first_of_trials = 1u << 16;

//! The smallest number of first hits on leaves from which a trial can estimate
//! the light on leaves and its variance. With 64 hits, the relative uncertainty
//! of their sum is an eighth.
constexpr double fewest_hits = 64;

//! The largest ratio between the work of a result and of its trial. If more
//! work is needed, another trial follows.
constexpr double longest_step = 8;

//! The number of suns in a trial with rasterised beams, selected evenly over
//! the day. The variance is estimated from the randomisations of all these suns
//! together.
constexpr std::size_t trial_suns = 4;

//! The factors by which variances are multiplied if light by piece is needed
//! for assimilation. The factor is larger for diffuse light than for beams,
//! because diffuse light falls mostly on shaded leaves, which use light more
//! efficiently. See tests/benchmark/README.md.
constexpr ByOrigin<double> worth_to_leaves{1.2, 2, 2};

//! The expected number of rays if paths are not divided by a trial.
constexpr double unknown_rays = std::numeric_limits<double>::infinity();

//! Computes the workload that a tolerance requires in one band.
//!
//! With amounts a of work for the origins o of variance, see LightOrigin, the
//! variance of the light on leaves in one randomisation is
//!
//!     V(a) = sum_o v_o (t_o / a_o)^q_o,                                  (1)
//!
//! where the variances v come from a trial with amounts t, and q is Law::power.
//! A result of R randomisations with the mean light m meets the tolerance e if
//!
//!     V(a) / R <= (e m)^2,                                               (2)
//!
//! and allocate() computes the amounts that meet (2) at the lowest cost. The
//! result may not use random numbers of trials, so trials cost extra time. They
//! begin with the least work and grow until the result needs at most `step()`
//! times the work of the last trial; its laws are then sufficiently accurate.
class Search {
  public:
    //! Makes a search that stores references to its arguments.
    //! @param has_pieces whether light by piece is needed
    Search(const Subject& subject, bool has_pieces, const Accuracy& accuracy,
           const Randomness& randomness)
        : subject_(subject),
          has_pieces_(has_pieces),
          light_(subject.light()),
          accuracy_(accuracy),
          randomness_(randomness),
          energy_(light_.energy()),
          trials_(std::max(trial_randomisations, accuracy.randomisations)) {}

    Workload enough() {
        is_capped_ = false;
        Workload work{share_paths(light_, fewest()), {}};
        work.path_energy = {
            std::vector(work.first_hits.size(), energy_ / fewest())};
        const Amounts least = amounts_of(work, light_);
        Amounts amounts = least;
        for (;;) {
            try_out(work);
            // No light can reach leaves.
            if (!found_.is_open && !(found_.mean > 0)) return work;
            // A trial with hardly any hits on leaves does not determine (1).
            if (found_.is_open && found_.first_hits < fewest_hits) {
                amounts = scaled(amounts, longest_step);
                if (is_beyond(amounts)) {
                    is_capped_ = true;
                    return {share_paths(light_, most()), {}};
                }
                work = work_of(amounts, light_);
                continue;
            }
            // Either this trial is sufficient or another one follows.
            const Amounts enough =
                costs_.cheapest(found_.laws, are_drawn_, least);
            const auto next = next_trial(enough, amounts, least);
            if (!next) {
                is_capped_ = is_beyond(enough);
                return work_of(is_capped_ ? capped(enough) : enough, light_);
            }
            amounts = *next;
            for (std::size_t o = 0; o < origins; ++o)
                amounts[o] = std::max(amounts[o], least[o]);
            work =
                work_of(is_beyond(amounts) ? capped(amounts) : amounts, light_);
            if (are_drawn_) leave_suns_out(work, light_, trial_suns);
        }
    }

    //! Returns the expected number of rays of a workload.
    double rays(const Workload& work) const {
        if (work.path_energy.empty()) return unknown_rays;
        const Amounts amounts = amounts_of(work, light_);
        return accuracy_.randomisations *
               ((are_drawn_ ? 0 : amounts[LightOrigin::beams]) +
                amounts[LightOrigin::skies] +
                found_.rays_per_unit * amounts[LightOrigin::scattered]);
    }

    //! Returns whether the tolerance needs more first hits than allowed.
    bool is_capped() const { return is_capped_; }

  private:
    //! Returns the largest ratio between the amounts of the result and of a
    //! trial. A trial may use more randomisations than the result.
    double step() const {
        return longest_step * trials_ / accuracy_.randomisations;
    }

    //! Returns the amounts of the next trial, or nothing if the last one is
    //! sufficient. Beams are rasterised from the first trial in which that
    //! costs less.
    //! @param enough cheapest amounts according to the last trial
    //! @param last amounts of the last trial
    std::optional<Amounts> next_trial(const Amounts& enough,
                                      const Amounts& last,
                                      const Amounts& least) {
        // Rasterised beams follow a different law, which is only estimated so
        // far.
        if (!are_drawn_ && costs_.pays_to_draw(enough, least)) {
            are_drawn_ = true;
            return drawn_trial(costs_.cheapest(costs_.guess(), true, least));
        }
        if (are_drawn_ && enough[LightOrigin::beams] <=
                              longest_step / 2 * last[LightOrigin::beams])
            return std::nullopt;
        // A trial that costs no more than the last one would give no new
        // information.
        const Amounts next = scaled(enough, 1 / step());
        if (costs_.cost(next, are_drawn_) <= costs_.cost(last, are_drawn_) ||
            is_beyond(next))
            return std::nullopt;
        return are_drawn_ ? drawn_trial(enough) : next;
    }

    //! Returns the amounts of a trial with rasterised beams. The time depends
    //! little on the number of points.
    Amounts drawn_trial(const Amounts& enough) const {
        Amounts amounts = scaled(enough, 1 / step());
        amounts[LightOrigin::beams] = enough[LightOrigin::beams] / 2;
        return amounts;
    }

    //! Returns the number of first hits in the first trial. No result uses
    //! fewer, since each source needs at least one path.
    std::uint32_t fewest() const {
        std::uint32_t paths = fewest_paths;
        while (paths < light_.sources.size()) paths *= 2;
        return std::min(paths, most());
    }

    std::uint32_t most() const {
        return static_cast<std::uint32_t>(accuracy_.paths);
    }

    bool is_beyond(const Amounts& amounts) const {
        return first_hits_of(amounts) > most();
    }

    //! Returns amounts with the largest allowed number of first hits. Paths of
    //! scattered light are not reduced: they are limited separately, and fewer
    //! paths would each carry too much energy.
    Amounts capped(const Amounts& amounts) const {
        Amounts most_amounts = scaled(amounts, most() / first_hits_of(amounts));
        most_amounts[LightOrigin::scattered] =
            std::min<double>(amounts[LightOrigin::scattered], most());
        return most_amounts;
    }

    void try_out(const Workload& work) {
        Randomness numbers = randomness_;
        numbers.first_randomisation += ++trial_ * first_of_trials;
        const Findings last = found_;
        found_ =
            ideotype::try_out(subject_, work, trials_, numbers, are_drawn_);
        if (has_pieces_)
            for (std::size_t o = 0; o < origins; ++o)
                found_.laws[o].variance *= worth_to_leaves[o];
        if (!found_.is_whole) {
            found_.mean = last.mean;
            found_.is_open = last.is_open;
        }
    }

    Subject subject_;
    bool has_pieces_;
    const Illumination& light_;
    const Accuracy& accuracy_;
    const Randomness& randomness_;
    double energy_;
    int trials_;
    std::uint32_t trial_ = 0;
    bool is_capped_ = false;
    //! Whether beams are rasterised instead of traced.
    bool are_drawn_ = false;

    Findings found_;  //!< results of the last trial
    WorkCosts costs_{subject_, has_pieces_, accuracy_, trials_, found_};
};

//! Combines the workloads of several bands, some of them bounded.
class Demands {
  public:
    Demands(const Subject& subject, const Accuracy& accuracy,
            const Randomness& randomness)
        : subject_(subject) {
        for (std::size_t b = 0; b < subject.bands.size(); ++b) {
            if (!is_bounded(b)) continue;
            const Subject one{subject.scene, subject.groups,
                              subject.bands.subspan(b, 1), subject.layers};
            Search search(one, b == 0 && subject.pieces > 0, accuracy,
                          randomness);
            Workload enough = search.enough();
            demand_.rays += search.rays(enough);
            add(b, std::move(enough));
            demand_.is_capped.resize(b + 1);
            demand_.is_capped[b] = search.is_capped();
        }
        for (std::size_t b = 0; b < subject.bands.size(); ++b)
            if (!is_bounded(b)) follow_as_often(b);
    }

    Demand demand() && { return std::move(demand_); }

  private:
    //! Returns whether a band is bounded; if no band is, the first one counts
    //! as bounded.
    bool is_bounded(std::size_t b) const {
        const std::span<const Band> bands = subject_.bands;
        return bands[b].is_bounded ||
               (b == 0 &&
                std::none_of(bands.begin(), bands.end(),
                             [](const Band& band) { return band.is_bounded; }));
    }

    void add(std::size_t b, Workload of_band) {
        if (demand_.work.first_hits.empty()) {
            reference_ = b;
            demand_.work.first_hits = of_band.first_hits;
            demand_.work.path_energy.resize(subject_.bands.size());
        }
        for (std::size_t s = 0; s < demand_.work.first_hits.size(); ++s)
            demand_.work.first_hits[s] =
                std::max(demand_.work.first_hits[s], of_band.first_hits[s]);
        if (!of_band.path_energy.empty())
            demand_.work.path_energy[b] =
                std::move(of_band.path_energy.front());
    }

    void follow_as_often(std::size_t b) {
        const Band& reference = subject_.bands[reference_];
        const Band& other = subject_.bands[b];
        const double scattered = reference.optics.most_scattered();
        double factor =
            other.light.light.energy() / reference.light.light.energy();
        if (scattered > 0)
            factor *= std::max(1., other.optics.most_scattered() / scattered);
        demand_.work.path_energy[b] = demand_.work.path_energy[reference_];
        for (double& energy : demand_.work.path_energy[b]) energy *= factor;
    }

    const Subject& subject_;
    Demand demand_;
    std::size_t reference_ = 0;  //!< index of the first bounded band
};

}  // namespace

Demand find_demand(const Subject& subject, const Accuracy& accuracy,
                   const Randomness& randomness) {
    if (!(accuracy.tolerance > 0) || subject.light().sources.empty())
        return {{}, unknown_rays, {}};
    IDEOTYPE_EXPECT(accuracy.paths > 0 && accuracy.randomisations > 0);
    return Demands(subject, accuracy, randomness).demand();
}

Simulation simulate(const Subject& subject, Demand demand,
                    const Accuracy& accuracy, const Randomness& randomness) {
    Simulation found;
    if (demand.work.first_hits.empty()) {
        found.tallies = simulate(subject, accuracy, randomness);
        found.paths = accuracy.paths;
        return found;
    }
    found.work = std::move(demand.work);
    found.tallies =
        simulate(subject, found.work, accuracy.randomisations, randomness);
    for (const std::uint32_t hits : found.work.first_hits)
        found.paths += static_cast<int>(hits);
    for (std::size_t b = 0; b < demand.is_capped.size(); ++b) {
        if (!demand.is_capped[b]) continue;
        const Estimate leaves = absorbed_by_leaves(found.tallies[b]);
        found.is_capped |=
            leaves.standard_error > accuracy.tolerance * leaves.mean;
    }
    return found;
}

Simulation simulate_to_tolerance(const Subject& subject,
                                 const Accuracy& accuracy,
                                 const Randomness& randomness) {
    return simulate(subject, find_demand(subject, accuracy, randomness),
                    accuracy, randomness);
}

}  // namespace ideotype
