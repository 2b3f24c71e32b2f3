// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "ideotype/core/error.hpp"
#include "reference_cases.hpp"

namespace ideotype {

namespace {

double part_of(const Tally& tally, std::size_t source, const Mesh& mesh,
               const std::string& quantity) {
    const Budget& budget = tally.sources[source];
    if (quantity == "leaves") return budget.leaves;
    if (quantity == "soil") return budget.soil;
    if (quantity == "reflected") return budget.reflected;
    for (std::size_t g = 0; g < mesh.groups.size(); ++g)
        if (mesh.groups[g].name == quantity) return tally.groups[g];
    throw Error("no group is called " + quantity);
}

//! Returns an accuracy with fewer paths; for random stands also with fewer
//! realisations, if there are enough.
Accuracy spare(const ReferenceScene& scene, const Setup& setup, int thrift) {
    Accuracy accuracy = scene.accuracy;
    if (scene.kind == ReferenceScene::Kind::random) {
        constexpr int least = 128;
        const int fewer = std::min(thrift, accuracy.randomisations / least);
        accuracy.randomisations /= fewer;
        thrift /= fewer;
    }
    accuracy.paths /= thrift * setup.split;
    accuracy.randomisations *= setup.split;
    return accuracy;
}

}  // namespace

double Comparison::off() const {
    return deviation(ours, reference);
}

std::size_t count_cases(const std::vector<ReferenceScene>& scenes) {
    std::size_t count = 0;
    for (const ReferenceScene& scene : scenes) count += scene.cases.size();
    return count;
}

SceneResult compare(const ReferenceScene& reference, const Setup& setup,
                    int thrift) {
    const Device device(setup.isa);
    const Accuracy accuracy = spare(reference, setup, thrift);

    Setting stand;
    std::optional<RayScene> scene;
    const auto build = [&](std::uint32_t realisation) {
        stand = {reference.mesh(realisation), reference.period, {}};
        for (const ReferenceCase& one : reference.cases)
            stand.light.sources.push_back(one.light);
        if (setup.rewrite) setup.rewrite(stand);
        scene.emplace(device, stand.mesh, stand.period.x, stand.period.y);
    };
    const auto run = [&](int randomisations, std::uint32_t first) {
        return simulate(*scene, stand.mesh.groups, reference.optics,
                        stand.light, {accuracy.paths, randomisations},
                        {setup.seed, 0, first});
    };
    std::vector<Tally> tallies;
    if (reference.kind == ReferenceScene::Kind::fixed) {
        build(0);
        tallies = run(accuracy.randomisations, 0);
    } else {
        const auto realisations =
            static_cast<std::uint32_t>(accuracy.randomisations);
        for (std::uint32_t i = 0; i < realisations; ++i) {
            build(i);
            tallies.push_back(run(1, i).front());
        }
    }

    SceneResult result;
    for (std::size_t s = 0; s < reference.cases.size(); ++s) {
        const ReferenceCase& one = reference.cases[s];
        for (const KnownValue& known : one.known) {
            std::vector<double> replicates;
            for (const Tally& tally : tallies)
                replicates.push_back(
                    part_of(tally, s, stand.mesh, known.quantity));
            result.comparisons.push_back(
                {one.name, known.quantity, reference.origin, known.value,
                 estimate(replicates),
                 reference.bound * std::pow(thrift, .75)});
        }
        for (const Tally& tally : tallies)
            result.balance_error = std::max(
                result.balance_error, std::abs(tally.sources[s].total() - 1));
    }
    return result;
}

}  // namespace ideotype
