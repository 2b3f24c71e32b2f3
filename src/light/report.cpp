#include "ideotype/light/report.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace ideotype {

namespace {

//! Estimate of a figure that is a function of a tally.
Estimate over(const std::vector<Tally>& tallies,
              const std::function<double(const Tally&)>& figure) {
    std::vector<double> replicates;
    replicates.reserve(tallies.size());
    for (const Tally& tally : tallies) replicates.push_back(figure(tally));
    return estimate(replicates);
}

//! A budget that is a weighted sum over sources, part by part.
BudgetEstimate weighted_budget(const std::vector<Tally>& tallies,
                               const std::vector<double>& weights,
                               double incident) {
    const auto part = [&](double Budget::*member) {
        return over(tallies, [&](const Tally& tally) {
            double sum = 0;
            for (std::size_t s = 0; s < weights.size(); ++s)
                sum += weights[s] * (tally.sources[s].*member);
            return sum;
        });
    };
    return {incident, part(&Budget::leaves), part(&Budget::stalks),
            part(&Budget::soil), part(&Budget::reflected)};
}

double balance_error(const Tally& tally) {
    double sum = 0, incident = 0;
    for (const Budget& budget : tally.sources) {
        sum += budget.total();
        incident += budget.incident;
    }
    return incident > 0 ? std::abs(sum - incident) / incident : 0;
}

}  // namespace

DayReport report(const std::vector<Tally>& tallies,
                 const DayIllumination& illumination, const Day& day) {
    const std::size_t sources = illumination.light.sources.size();
    DayReport result;
    result.day = weighted_budget(tallies, std::vector<double>(sources, 1.0),
                                 illumination.light.energy());
    for (std::size_t g = 0; g < tallies.front().groups.size(); ++g)
        result.groups.push_back(
            over(tallies, [g](const Tally& t) { return t.groups[g]; }));

    for (std::size_t i = 0; i < day.steps.size(); ++i) {
        const TimeStep& step = day.steps[i];
        std::vector<double> weights(sources, 0.0);
        const auto add = [&](int source, double irradiance) {
            if (source < 0) return;
            const auto s = static_cast<std::size_t>(source);
            weights[s] = irradiance / illumination.light.sources[s].energy;
        };
        add(illumination.beam_of[i], step.par.beam);
        add(illumination.sky_of[i], step.par.diffuse);
        result.steps.push_back(
            {step.hour, weighted_budget(tallies, weights,
                                        step.par.beam + step.par.diffuse)});
    }
    for (const Tally& tally : tallies)
        result.balance_error =
            std::max(result.balance_error, balance_error(tally));
    return result;
}

}  // namespace ideotype
