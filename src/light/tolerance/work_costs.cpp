// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "beams/beam_costs.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/light/tolerance.hpp"
#include "trial.hpp"
#include "workload.hpp"

namespace ideotype {

namespace {

//! The number of first hits of a sun above which a lattice is assumed to be
//! better than independent rays, until a trial measures it.
constexpr double even_for_lattices = 30;

//! Returns the factor by which errors of trials are multiplied, because a trial
//! that underestimates the error leads to too few paths. The mean of sqrt(v /
//! X), with X from a chi-square distribution with v degrees of freedom, would
//! keep the expected error within the tolerance. The factor is slightly above
//! its approximation 1 + 3 / (4 v).
double caution(int randomisations) {
    IDEOTYPE_EXPECT(randomisations > 1);
    return 1 + 0.8 / (randomisations - 1);
}

}  // namespace

ByOrigin<double> WorkCosts::costs(bool is_drawn) const {
    ByOrigin<double> all{Costs::ray, Costs::ray,
                         Costs::ray * found.rays_per_unit};
    if (is_drawn) all[LightOrigin::beams] = Costs::point;
    for (double& cost : all) cost *= accuracy.randomisations;
    return all;
}

double WorkCosts::cost(const Amounts& amounts, bool is_drawn) const {
    const ByOrigin<double> each = costs(is_drawn);
    double sum = 0;
    for (std::size_t o = 0; o < origins; ++o)
        if (!is_drawn || o != LightOrigin::beams) sum += each[o] * amounts[o];
    if (!is_drawn) return sum;
    const Workload work = work_of(amounts, subject.light());
    for (std::size_t s = 0; s < subject.light().sources.size(); ++s)
        if (subject.light().sources[s].direction)
            sum += cost_of_drawing(subject.scene,
                                   *subject.light().sources[s].direction,
                                   work.first_hits[s], accuracy.randomisations);
    return sum;
}

ByOrigin<Law> WorkCosts::guess() const {
    ByOrigin<Law> laws = found.laws;
    Law& law = laws[LightOrigin::beams];
    const double even =
        even_for_lattices *
        static_cast<double>(std::count_if(
            subject.light().sources.begin(), subject.light().sources.end(),
            [](const Source& s) { return s.direction.has_value(); }));
    law = {even, law.at(even), power_of_lattices};
    return laws;
}

bool WorkCosts::pays_to_draw(const Amounts& by_rays,
                             const Amounts& least) const {
    if (subject.scene.boundary() != Boundary::periodic ||
        found.laws[LightOrigin::beams].variance == 0)
        return false;
    // The factor includes the cost of a trial with rasterised beams.
    constexpr double with_trial = 1.3;
    return cost(cheapest(guess(), true, least), true) * with_trial <
           cost(by_rays, false);
}

Amounts WorkCosts::cheapest(const ByOrigin<Law>& laws, bool is_drawn,
                            const Amounts& least) const {
    const double wanted = accuracy.tolerance / caution(trials) * found.mean;
    Amounts amounts = allocate(laws, costs(is_drawn),
                               wanted * wanted * accuracy.randomisations);
    // Figures cannot differ by less than the light of one path.
    const double coarsest = 1 / (accuracy.tolerance * accuracy.randomisations);
    const double part = coarsest / first_hits_of(least);
    for (const LightOrigin origin : {LightOrigin::beams, LightOrigin::skies})
        amounts[origin] = std::max(amounts[origin], part * least[origin]);
    amounts[LightOrigin::scattered] =
        std::max(amounts[LightOrigin::scattered], coarsest);
    for (std::size_t o = 0; o < origins; ++o)
        amounts[o] = std::max(amounts[o], least[o]);
    if (has_pieces) {
        const double more = for_pieces(amounts);
        amounts[LightOrigin::skies] *= more;
        amounts[LightOrigin::scattered] *= more;
    }
    return amounts;
}

double WorkCosts::for_pieces(const Amounts& amounts) const {
    constexpr double most_times = 16;
    const double skies = amounts[LightOrigin::skies];
    const double hits =
        accuracy.randomisations *
        (skies + found.rays_per_unit * amounts[LightOrigin::scattered]);
    if (!(hits > 0)) return 1;
    double times = std::min(
        hits_of_piece * static_cast<double>(subject.groups.size()) / hits,
        most_times);
    if (skies > 0)
        times = std::min(
            times, (accuracy.paths - amounts[LightOrigin::beams]) / skies);
    return std::max(times, 1.);
}

}  // namespace ideotype
