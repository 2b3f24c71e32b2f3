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
                               const std::vector<Source>& sources,
                               const std::vector<double>& weights,
                               double incident) {
    const auto weighted = [&](const auto& figure) {
        return over(tallies, [&](const Tally& tally) {
            double sum = 0;
            for (std::size_t s = 0; s < sources.size(); ++s)
                sum += weights[s] * figure(tally.sources[s], sources[s]);
            return sum;
        });
    };
    const auto part = [&](double Budget::*member) {
        return weighted(
            [=](const Budget& b, const Source&) { return b.*member; });
    };
    return {incident,
            part(&Budget::incident),
            part(&Budget::leaves),
            part(&Budget::stalks),
            part(&Budget::soil),
            part(&Budget::reflected),
            weighted([](const Budget& b, const Source& source) {
                return source.direction ? b.unscattered : 0;
            }),
            weighted([](const Budget& b, const Source& source) {
                return source.direction ? 0 : b.unscattered;
            }),
            weighted([](const Budget& b, const Source&) {
                return b.leaves - b.unscattered;
            })};
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
                 const DayIllumination& illumination) {
    const Day& day = illumination.day;
    const std::vector<Source>& sources = illumination.light.sources;
    DayReport result;
    result.day =
        weighted_budget(tallies, sources, std::vector(sources.size(), 1.0),
                        illumination.light.energy());
    for (std::size_t g = 0; g < tallies.front().groups.size(); ++g)
        result.groups.push_back(
            over(tallies, [g](const Tally& t) { return t.groups[g]; }));
    for (std::size_t l = 0; l < tallies.front().layers.size(); ++l)
        result.layers.push_back(
            over(tallies, [l](const Tally& t) { return t.layers[l]; }));
    result.adaxial = over(tallies, [](const Tally& t) { return t.adaxial; });
    result.abaxial = over(tallies, [](const Tally& t) { return t.abaxial; });

    for (std::size_t i = 0; i < day.steps.size(); ++i) {
        const TimeStep& step = day.steps[i];
        std::vector<double> weights(sources.size(), 0.0);
        const auto add = [&](int source, double irradiance) {
            if (source < 0) return;
            const auto s = static_cast<std::size_t>(source);
            weights[s] = irradiance / sources[s].energy;
        };
        add(illumination.beam_of[i], step.par.beam);
        add(illumination.sky_of[i], step.par.diffuse);
        result.steps.push_back(
            {step.hour,
             weighted_budget(tallies, sources, weights,
                             step.par.beam + step.par.diffuse),
             std::nullopt});
    }
    for (const Tally& tally : tallies)
        result.balance_error =
            std::max(result.balance_error, balance_error(tally));
    return result;
}

void add_sunlit(DayReport& report,
                const std::vector<std::vector<double>>& fractions,
                const DayIllumination& illumination) {
    for (std::size_t i = 0; i < report.steps.size(); ++i) {
        const int beam = illumination.beam_of[i];
        std::vector<double> replicates;
        for (const std::vector<double>& by_source : fractions)
            replicates.push_back(
                beam < 0 ? 0 : by_source[static_cast<std::size_t>(beam)]);
        report.steps[i].sunlit = estimate(replicates);
    }
}

}  // namespace ideotype
