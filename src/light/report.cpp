#include "ideotype/light/report.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace ideotype {

namespace {

double count(const std::vector<Tally>& tallies) {
    return static_cast<double>(tallies.size());
}

//! Of all tallies together; nothing if they were not simulated.
Resolution resolution_of(const std::vector<Tally>& tallies) {
    Resolution all;
    const Resolution* last = nullptr;
    for (const Tally& tally : tallies) {
        if (!tally.resolution || tally.resolution.get() == last) continue;
        all = last ? combined(all, *tally.resolution) : *tally.resolution;
        last = tally.resolution.get();
    }
    return all;
}

//! Estimate of a figure that is a function of a tally.
Estimate over(const std::vector<Tally>& tallies,
              const std::function<double(const Tally&)>& figure) {
    std::vector<double> replicates;
    replicates.reserve(tallies.size());
    for (const Tally& tally : tallies) replicates.push_back(figure(tally));
    return estimate(replicates);
}

//! As over(), of a figure that a path of any source may change.
Estimate over(const std::vector<Tally>& tallies, const Resolution& resolution,
              bool is_open, const std::function<double(const Tally&)>& figure) {
    return at_least(over(tallies, figure),
                    is_open ? resolution.largest_path() / count(tallies) : 0);
}

//! A budget that is a weighted sum over sources, part by part.
BudgetEstimate weighted_budget(const std::vector<Tally>& tallies,
                               const Resolution& resolution,
                               const std::vector<Source>& sources,
                               const std::vector<double>& weights,
                               double incident) {
    using IsOf = bool (*)(const Source&);
    const auto weighted = [&](IsOf is_of, bool is_open, const auto& figure) {
        double step = 0;
        for (std::size_t s = 0; s < resolution.path_energy.size(); ++s)
            if (is_open && is_of(sources[s]))
                step = std::max(step, weights[s] * resolution.path_energy[s]);
        const Estimate found = over(tallies, [&](const Tally& tally) {
            double sum = 0;
            for (std::size_t s = 0; s < sources.size(); ++s)
                if (is_of(sources[s]))
                    sum += weights[s] * figure(tally.sources[s]);
            return sum;
        });
        return at_least(found, step / count(tallies));
    };
    const IsOf any = [](const Source&) { return true; };
    const IsOf is_beam = [](const Source& s) {
        return s.direction.has_value();
    };
    const IsOf is_sky = [](const Source& s) { return !s.direction; };
    const auto part = [&](bool is_open, double Budget::*member) {
        return weighted(any, is_open,
                        [=](const Budget& b) { return b.*member; });
    };
    const auto unscattered = [](const Budget& b) { return b.unscattered; };
    return {incident,
            part(false, &Budget::incident),
            part(resolution.leaves, &Budget::leaves),
            part(resolution.stalks, &Budget::stalks),
            part(resolution.soil, &Budget::soil),
            part(resolution.reflected, &Budget::reflected),
            weighted(is_beam, resolution.unscattered, unscattered),
            weighted(is_sky, resolution.unscattered, unscattered),
            weighted(any, resolution.scattered,
                     [](const Budget& b) { return b.leaves - b.unscattered; })};
}

bool is_set(const std::vector<bool>& flags, std::size_t i) {
    return i < flags.size() && flags[i];
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
    const Resolution resolution = resolution_of(tallies);
    DayReport result;
    result.day = weighted_budget(tallies, resolution, sources,
                                 std::vector(sources.size(), 1.0),
                                 illumination.light.energy());
    result.groups = absorbed_by_group(tallies);
    for (std::size_t l = 0; l < tallies.front().layers.size(); ++l)
        result.layers.push_back(
            over(tallies, resolution, is_set(resolution.layers, l),
                 [l](const Tally& t) { return t.layers[l]; }));
    result.adaxial = over(tallies, resolution, resolution.leaves,
                          [](const Tally& t) { return t.adaxial; });
    result.abaxial = over(tallies, resolution, resolution.leaves,
                          [](const Tally& t) { return t.abaxial; });

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
             weighted_budget(tallies, resolution, sources, weights,
                             step.par.beam + step.par.diffuse),
             std::nullopt});
    }
    for (const Tally& tally : tallies)
        result.balance_error =
            std::max(result.balance_error, balance_error(tally));
    return result;
}

std::vector<Estimate> absorbed_by_group(const std::vector<Tally>& tallies) {
    const Resolution resolution = resolution_of(tallies);
    std::vector<Estimate> result;
    for (std::size_t g = 0; g < tallies.front().groups.size(); ++g)
        result.push_back(over(tallies, resolution, is_set(resolution.groups, g),
                              [g](const Tally& t) { return t.groups[g]; }));
    return result;
}

Estimate absorbed_by_leaves(const std::vector<Tally>& tallies) {
    const Resolution resolution = resolution_of(tallies);
    return over(tallies, resolution, resolution.leaves,
                [](const Tally& t) { return t.leaves(); });
}

void add_sunlit(DayReport& report, const SunlitFractions& sunlit,
                const DayIllumination& illumination) {
    for (std::size_t i = 0; i < report.steps.size(); ++i) {
        const int beam = illumination.beam_of[i];
        if (beam < 0) {
            report.steps[i].sunlit = Estimate{};
            continue;
        }
        std::vector<double> replicates;
        for (const std::vector<double>& by_source : sunlit.fractions)
            replicates.push_back(by_source[static_cast<std::size_t>(beam)]);
        report.steps[i].sunlit =
            at_least(estimate(replicates),
                     sunlit.step / static_cast<double>(replicates.size()));
    }
}

}  // namespace ideotype
