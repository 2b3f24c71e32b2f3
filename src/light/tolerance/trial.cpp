// SPDX-License-Identifier: Apache-2.0
#include "trial.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ideotype/core/contract.hpp"
#include "workload.hpp"

namespace ideotype {

namespace {

double squared(double x) {
    return x * x;
}

//! Factors that convert the variance of a few suns to that of all suns. For
//! independent first hits in proportion to energy, the factor is the ratio of
//! energies; for lattices, the ratio of their square roots.
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

double variance_of(const std::vector<double>& randomisations) {
    return squared(estimate(randomisations).standard_error) *
           static_cast<double>(randomisations.size());
}

}  // namespace

Findings try_out(const Subject& subject, const Workload& work,
                 int randomisations, const Randomness& randomness,
                 bool is_drawn) {
    IDEOTYPE_EXPECT(randomisations > 1 && !work.path_energy.empty());
    const Illumination& light = subject.light();
    const std::vector<Tally> tallies =
        std::move(simulate(subject, work, randomisations, randomness).front());
    Budget all;
    double rays = 0;
    for (const Tally& tally : tallies) {
        for (const Budget& budget : tally.sources) all += budget;
        rays += static_cast<double>(tally.next_rays);
    }
    const double caught =
        all.sent_on > 0 ? (all.leaves - all.unscattered) / all.sent_on : 0;
    // The variance has two parts: first hits, with the constant part that each
    // surface scatters to leaves, and further scattering, in paths common to
    // all sources.
    const Suns suns(light, work);
    Amounts amounts = amounts_of(work, light);
    amounts[LightOrigin::beams] *= suns.by_energy;
    const Resolution& resolution = *tallies.front().resolution;
    Findings found;
    ByOrigin<double> variance{}, largest{}, hits{};
    std::vector<double> next(tallies.size());
    double kept = 0;
    for (std::size_t s = 0; s < work.first_hits.size(); ++s) {
        if (work.first_hits[s] == 0) continue;
        std::vector<double> first;
        double incident = 0, unscattered = 0, sent_on = 0;
        for (std::size_t r = 0; r < tallies.size(); ++r) {
            const Budget& budget = tallies[r].sources[s];
            first.push_back(budget.unscattered + caught * budget.sent_on);
            next[r] += budget.leaves - first.back();
            incident = std::max(incident, budget.incident);
            unscattered += budget.unscattered;
            sent_on = std::max(sent_on, budget.sent_on);
        }
        const LightOrigin origin = origin_of(light.sources[s]);
        const double of_hit =
            resolution.unscattered * incident / work.first_hits[s];
        largest[origin] = std::max(largest[origin], of_hit);
        if (of_hit > 0) hits[origin] += unscattered / of_hit;
        largest[LightOrigin::scattered] =
            std::max(largest[LightOrigin::scattered],
                     resolution.scattered *
                         std::min(sent_on, work.path_energy.front()[s]));
        variance[origin] += variance_of(first) *
                            (origin == LightOrigin::beams ? suns.by_root : 1);
        kept += light.sources[s].energy;
    }
    // The lattice may be less accurate for the omitted suns.
    constexpr double for_others = 1.3;
    if (suns.by_energy > 1) variance[LightOrigin::beams] *= for_others;
    variance[LightOrigin::scattered] =
        variance_of(next) * (light.energy() / kept);
    if (largest[LightOrigin::scattered] > 0)
        hits[LightOrigin::scattered] =
            (all.leaves - all.unscattered) / largest[LightOrigin::scattered];
    for (std::size_t o = 0; o < origins; ++o) {
        found.laws[o] = {std::max(1., amounts[o]), variance[o], 1};
        // If each randomisation hit leaves only about once, randomisations may
        // agree by chance. The variance is then at least that of one more hit
        // in one of them.
        if (hits[o] < 1.25 * randomisations)
            found.laws[o].variance =
                std::max(variance[o], squared(largest[o]) / randomisations);
    }
    found.laws[LightOrigin::beams].power =
        is_drawn ? power_of_lattices : power_of_nets;
    found.rays_per_unit = rays * light.energy() /
                          (all.incident * amounts[LightOrigin::scattered]);
    found.mean = all.leaves / randomisations;
    found.first_hits = hits[LightOrigin::beams] + hits[LightOrigin::skies];
    found.is_open = resolution.leaves > 0;
    found.is_whole = suns.by_energy == 1;
    return found;
}

}  // namespace ideotype
