// SPDX-License-Identifier: Apache-2.0
#include "ideotype/light/report.hpp"

#include <algorithm>
#include <cmath>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/mapped.hpp"

namespace ideotype {

namespace {

double count(const std::vector<Tally>& tallies) {
    return static_cast<double>(tallies.size());
}

//! Returns the combined resolution of all tallies, or an empty one if they were
//! not simulated.
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

Estimate over(const std::vector<Tally>& tallies, const auto& figure) {
    return estimate(mapped(tallies, figure));
}

//! Returns the estimate of a figure to which a path of any source may
//! contribute the fraction `part` of its energy.
Estimate over(const std::vector<Tally>& tallies, const Resolution& resolution,
              double part, const auto& figure) {
    return at_least(over(tallies, figure),
                    part * resolution.largest_path() / count(tallies));
}

//! Returns the estimate of a weighted sum over sources, to which a path may
//! contribute the fraction `part` of its energy.
Estimate weighted(const std::vector<Tally>& tallies,
                  const Resolution& resolution,
                  const std::vector<double>& weights, double part,
                  const auto& figure) {
    IDEOTYPE_EXPECT(resolution.path_energy.size() <= weights.size());
    double step = 0;
    for (std::size_t s = 0; s < resolution.path_energy.size(); ++s)
        step = std::max(step, part * weights[s] * resolution.path_energy[s]);
    const Estimate found = over(tallies, [&](const Tally& tally) {
        double sum = 0;
        for (std::size_t s = 0; s < weights.size(); ++s)
            if (weights[s] > 0) sum += weights[s] * figure(tally.sources[s]);
        return sum;
    });
    return at_least(found, step / count(tallies));
}

BudgetEstimate weighted_budget(const std::vector<Tally>& tallies,
                               const Resolution& resolution,
                               const std::vector<Source>& sources,
                               const std::vector<double>& weights,
                               double incident) {
    std::vector<double> of_beams = weights, of_skies = weights;
    for (std::size_t s = 0; s < sources.size(); ++s)
        (sources[s].direction ? of_skies : of_beams)[s] = 0;
    const auto part = [&](double of_path, double Budget::*member) {
        return weighted(tallies, resolution, weights, of_path,
                        [=](const Budget& b) { return b.*member; });
    };
    const auto unscattered = [&](const std::vector<double>& some) {
        return weighted(tallies, resolution, some, resolution.unscattered,
                        [](const Budget& b) { return b.unscattered; });
    };
    return {incident,
            part(0, &Budget::incident),
            part(resolution.leaves, &Budget::leaves),
            part(resolution.organs, &Budget::organs),
            weighted(tallies, resolution, weights,
                     std::max(resolution.leaves, resolution.organs),
                     [](const Budget& b) { return b.leaves + b.organs; }),
            part(resolution.objects, &Budget::objects),
            part(resolution.soil, &Budget::soil),
            part(resolution.reflected, &Budget::reflected),
            unscattered(of_beams),
            unscattered(of_skies),
            weighted(tallies, resolution, weights, resolution.scattered,
                     [](const Budget& b) { return b.leaves - b.unscattered; })};
}

//! Light of selected instants as a weighted sum over sources.
struct Part {
    explicit Part(std::size_t sources) : weights(sources) {}

    void add(const SeriesIllumination& illumination, std::size_t instant,
             double factor) {
        const auto add_source = [&](int source, double irradiance) {
            if (source < 0) return;
            const auto s = static_cast<std::size_t>(source);
            IDEOTYPE_EXPECT(illumination.light.sources[s].energy > 0);
            weights[s] +=
                factor * irradiance / illumination.light.sources[s].energy;
        };
        const Irradiance& par = illumination.series.steps[instant].par;
        add_source(illumination.beam_of[instant], par.beam);
        add_source(illumination.sky_of[instant], par.diffuse);
        incident += factor * (par.beam + par.diffuse);
    }

    std::vector<double> weights;
    double incident = 0;
};

//! Returns the light of Tally::parts.
std::vector<PartLight> light_of_parts(const std::vector<Tally>& tallies,
                                      const Resolution& resolution,
                                      const std::vector<Part>& hours) {
    std::vector<PartLight> result;
    if (tallies.front().parts.empty()) return result;
    const std::size_t sources = tallies.front().parts.size();
    const double of_path = std::max(resolution.objects, resolution.leaves);
    const auto of_part = [&](std::size_t part,
                             const std::vector<double>& weights,
                             std::vector<double>& values) {
        double step = 0;
        for (std::size_t s = 0; s < sources; ++s)
            step = std::max(step,
                            of_path * weights[s] * resolution.path_energy[s]);
        values.assign(tallies.size(), 0);
        for (std::size_t r = 0; r < tallies.size(); ++r)
            for (std::size_t s = 0; s < sources; ++s)
                values[r] += weights[s] * tallies[r].parts[s][part];
        return at_least(estimate(values), step / count(tallies));
    };
    for (std::size_t part = 0; part < tallies.front().parts.front().size();
         ++part) {
        PartLight& light = result.emplace_back();
        light.day =
            of_part(part, std::vector(sources, 1.0), light.by_randomisation);
        std::vector<double> values;
        for (const Part& hour : hours)
            light.hours.push_back(of_part(part, hour.weights, values));
    }
    return result;
}

double part_of(const std::vector<double>& parts, std::size_t i) {
    return i < parts.size() ? parts[i] : 0;
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
                 const SeriesIllumination& illumination) {
    const LightSeries& series = illumination.series;
    const std::vector<Source>& sources = illumination.light.sources;
    IDEOTYPE_EXPECT(!tallies.empty());
    IDEOTYPE_EXPECT(tallies.front().sources.size() == sources.size());
    const Resolution resolution = resolution_of(tallies);
    DayReport result;
    result.day = weighted_budget(tallies, resolution, sources,
                                 std::vector(sources.size(), 1.0),
                                 illumination.light.energy());
    result.groups = absorbed_by_group(tallies);
    for (std::size_t l = 0; l < tallies.front().layers.size(); ++l)
        result.layers.push_back(
            over(tallies, resolution, part_of(resolution.layers, l),
                 [l](const Tally& t) { return t.layers[l]; }));
    result.adaxial =
        over(tallies, resolution, resolution.leaves, &Tally::adaxial);
    result.abaxial =
        over(tallies, resolution, resolution.leaves, &Tally::abaxial);

    result.utc_offset = series.utc_offset;
    const std::vector<double> hours = series.hours();
    const auto steps_of_hours = series.steps_of_hours();
    std::vector<Part> parts;
    for (std::size_t h = 0; h < hours.size(); ++h) {
        Part& part = parts.emplace_back(sources.size());
        for (const std::size_t i : steps_of_hours[h])
            part.add(illumination, i, 1. / series.days);
        result.steps.push_back({hours[h],
                                weighted_budget(tallies, resolution, sources,
                                                part.weights, part.incident),
                                std::nullopt});
    }
    result.parts = light_of_parts(tallies, resolution, parts);
    if (series.days > 1)
        for (const std::vector<std::size_t>& steps : series.steps_of_dates()) {
            Part part(sources.size());
            for (const std::size_t i : steps)
                part.add(illumination, i, series.steps[i].seconds);
            result.dates.push_back(
                weighted(tallies, resolution, part.weights, resolution.leaves,
                         [](const Budget& budget) { return budget.leaves; }));
        }
    for (const Tally& tally : tallies)
        result.balance_error =
            std::max(result.balance_error, balance_error(tally));
    return result;
}

std::vector<std::vector<double>> absorbed_by_soil(
    const std::vector<Tally>& tallies, const SeriesIllumination& illumination) {
    const std::vector<TimeStep>& steps = illumination.series.steps;
    std::vector<std::vector<double>> light;
    for (const Tally& tally : tallies) {
        std::vector<double>& of_tally = light.emplace_back(steps.size());
        const auto of_source = [&](int source, double irradiance) {
            if (source < 0) return 0.;
            const auto s = static_cast<std::size_t>(source);
            return irradiance / illumination.light.sources[s].energy *
                   tally.sources[s].soil;
        };
        for (std::size_t i = 0; i < steps.size(); ++i)
            of_tally[i] =
                of_source(illumination.beam_of[i], steps[i].par.beam) +
                of_source(illumination.sky_of[i], steps[i].par.diffuse);
    }
    return light;
}

std::vector<Estimate> absorbed_by_group(const std::vector<Tally>& tallies) {
    IDEOTYPE_EXPECT(!tallies.empty());
    const Resolution resolution = resolution_of(tallies);
    std::vector<Estimate> result;
    for (std::size_t g = 0; g < tallies.front().groups.size(); ++g)
        result.push_back(over(tallies, resolution,
                              part_of(resolution.groups, g),
                              [g](const Tally& t) { return t.groups[g]; }));
    return result;
}

Estimate absorbed_by_groups(const std::vector<Tally>& tallies,
                            const std::vector<std::size_t>& groups) {
    const Resolution resolution = resolution_of(tallies);
    double part = 0;
    for (const std::size_t g : groups)
        IDEOTYPE_EXPECT(g < tallies.front().groups.size());
    for (const std::size_t g : groups)
        part = std::max(part, part_of(resolution.groups, g));
    return over(tallies, resolution, part, [&](const Tally& t) {
        double sum = 0;
        for (const std::size_t g : groups) sum += t.groups[g];
        return sum;
    });
}

Estimate absorbed_by_some_leaves(const std::vector<Tally>& tallies,
                                 const std::vector<double>& of_some) {
    const Resolution resolution = resolution_of(tallies);
    return at_least(
        estimate(of_some),
        resolution.leaves * resolution.largest_path() / count(tallies));
}

Estimate absorbed_by_leaves(const std::vector<Tally>& tallies) {
    const Resolution resolution = resolution_of(tallies);
    return over(tallies, resolution, resolution.leaves, &Tally::leaves);
}

}  // namespace ideotype
