// SPDX-License-Identifier: Apache-2.0
#include "workload.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ideotype/core/contract.hpp"

namespace ideotype {

LightOrigin origin_of(const Source& source) {
    return source.direction ? LightOrigin::beams : LightOrigin::skies;
}

std::vector<std::uint32_t> share_paths(const Illumination& illumination,
                                       std::uint32_t paths) {
    const std::vector<Source>& sources = illumination.sources;
    IDEOTYPE_EXPECT(!sources.empty() && paths >= sources.size());
    double total = 0;
    for (const Source& source : sources) total += source.energy * source.effort;
    std::vector<std::uint32_t> counts;
    std::vector<double> remainders;
    std::uint32_t given = 0;
    for (const Source& source : sources) {
        const double exact = source.energy * source.effort / total *
                             static_cast<double>(paths - sources.size());
        counts.push_back(1 + static_cast<std::uint32_t>(exact));
        remainders.push_back(exact - std::floor(exact));
        given += counts.back();
    }
    std::vector<std::size_t> order(sources.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) {
                         return remainders[a] > remainders[b];
                     });
    for (std::size_t i = 0; given < paths; ++i, ++given)
        ++counts[order[i % order.size()]];
    IDEOTYPE_ENSURE(given == paths);
    return counts;
}

Amounts amounts_of(const Workload& work, const Illumination& light) {
    IDEOTYPE_EXPECT(work.first_hits.size() == light.sources.size());
    IDEOTYPE_EXPECT(!work.path_energy.empty() &&
                    !work.path_energy.front().empty());
    Amounts amounts{};
    for (std::size_t s = 0; s < work.first_hits.size(); ++s)
        amounts[origin_of(light.sources[s])] += work.first_hits[s];
    amounts[LightOrigin::scattered] =
        light.energy() / work.path_energy.front().front();
    return amounts;
}

Workload work_of(const Amounts& amounts, const Illumination& light) {
    IDEOTYPE_EXPECT(amounts[LightOrigin::scattered] > 0);
    const std::vector<Source>& sources = light.sources;
    Workload work;
    work.first_hits.resize(sources.size());
    for (const LightOrigin origin : {LightOrigin::beams, LightOrigin::skies}) {
        Illumination part;
        for (const Source& source : sources)
            if (origin_of(source) == origin) part.sources.push_back(source);
        if (part.sources.empty()) continue;
        // First hits that beams lose to rounding are given to skies.
        const double others =
            origin == LightOrigin::beams ? 0 : amounts[LightOrigin::beams];
        const double hits =
            std::max(std::round(others + amounts[origin]) - std::round(others),
                     static_cast<double>(part.sources.size()));
        const auto shares = share_paths(part, static_cast<std::uint32_t>(hits));
        std::size_t next = 0;
        for (std::size_t s = 0; s < sources.size(); ++s)
            if (origin_of(sources[s]) == origin)
                work.first_hits[s] = shares[next++];
    }
    work.path_energy = {std::vector(
        sources.size(), light.energy() / amounts[LightOrigin::scattered])};
    return work;
}

void leave_suns_out(Workload& work, const Illumination& light,
                    std::size_t kept) {
    IDEOTYPE_EXPECT(kept > 0 && work.first_hits.size() == light.sources.size());
    std::vector<std::size_t> suns;
    for (std::size_t s = 0; s < light.sources.size(); ++s)
        if (light.sources[s].direction) suns.push_back(s);
    if (suns.size() <= kept) return;
    std::vector<bool> is_kept(light.sources.size());
    for (std::size_t i = 0; i < kept; ++i)
        is_kept[suns[(2 * i + 1) * suns.size() / (2 * kept)]] = true;
    for (const std::size_t s : suns)
        if (!is_kept[s]) work.first_hits[s] = 0;
}

}  // namespace ideotype
