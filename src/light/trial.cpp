#include "trial.hpp"

#include <algorithm>
#include <cmath>

#include "workload.hpp"

namespace ideotype {

namespace {

double squared(double x) {
    return x * x;
}

//! By what the variance of a few suns is multiplied for that of all: it grows
//! with the energy if first hits in proportion to that are independent, and
//! with its root if they are a lattice's.
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

//! Of the leaves' light of a source in one randomisation: by what is met first,
//! each surface of which sends the same part of the scattered light to leaves;
//! and by what becomes of scattered light beyond that.
Variances variances(const std::vector<Tally>& tallies, std::size_t source,
                    double caught) {
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

}  // namespace

Findings try_out(const Subject& subject, const Workload& work,
                 int randomisations, const Randomness& randomness,
                 bool is_drawn) {
    const Illumination& light = subject.light;
    const std::vector<Tally> tallies =
        subject.simulate(work, randomisations, randomness);
    Budget all;
    double rays = 0;
    for (const Tally& tally : tallies) {
        for (const Budget& budget : tally.sources) all += budget;
        rays += static_cast<double>(tally.next_rays);
    }
    const double caught =
        all.sent_on > 0 ? (all.leaves - all.unscattered) / all.sent_on : 0;
    const Suns suns(light, work);
    Amounts amounts = amounts_of(work, light);
    amounts[Origin::beams] *= suns.by_energy;
    ByOrigin<double> variance{};
    for (std::size_t s = 0; s < work.first_hits.size(); ++s) {
        if (work.first_hits[s] == 0) continue;
        const auto [first, next] = variances(tallies, s, caught);
        const Origin origin = origin_of(light.sources[s]);
        const bool is_beam = origin == Origin::beams;
        variance[origin] += first * (is_beam ? suns.by_root : 1);
        variance[Origin::scattered] += next * (is_beam ? suns.by_energy : 1);
    }
    Findings found;
    for (std::size_t o = 0; o < origins; ++o)
        found.laws[o] = {std::max(1., amounts[o]), variance[o], power_of_rays};
    if (is_drawn) found.laws[Origin::beams].power = power_of_lattices;
    found.rays_per_unit =
        rays * light.energy() / (all.incident * amounts[Origin::scattered]);
    found.mean = all.leaves / randomisations;
    found.is_open = tallies.front().resolution->leaves;
    found.is_whole = suns.by_energy == 1;
    return found;
}

}  // namespace ideotype
