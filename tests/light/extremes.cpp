// SPDX-License-Identifier: Apache-2.0
#include "extremes.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ideotype/crop/plant.hpp"

namespace ideotype {

Fractions Findings::closing(const Mesh& mesh, GroundPeriod period,
                            const Optics& optics, const Illumination& light,
                            Accuracy accuracy) {
    const Fractions fractions = trace(mesh, period, optics, light, accuracy);
    require_closed(fractions);
    return fractions;
}

void Findings::require_closed(const Fractions& f) {
    ++traces_;
    balance_error_ = std::max(balance_error_, f.balance_error);
    require(f.balance_error < 1e-12, "the balance closes");
    for (const Estimate& e : {f.leaves, f.soil, f.reflected})
        require(e.mean >= 0 && std::isfinite(e.mean) &&
                    std::isfinite(e.standard_error),
                "figures are finite fractions");
    for (const Estimate& e : f.groups)
        require(std::isfinite(e.mean), "groups are finite");
}

void Findings::require(bool holds, const std::string& what) {
    if (!holds) failures_.push_back(what);
}

void Findings::require_agreement(Estimate ours, Estimate reference,
                                 double bound, const std::string& what) {
    const double off = deviation(ours, reference);
    ++agreements_;
    if (std::abs(off) > std::abs(most_off_)) most_off_ = off;
    require(std::abs(off) <= 4,
            fmt::format("{}: {:.6f} +- {:.6f} for {:.6f}", what, ours.mean,
                        ours.standard_error, reference.mean));
    require(ours.standard_error <= bound,
            fmt::format("{}: the standard error {:.2g} is at most {:.2g}", what,
                        ours.standard_error, bound));
}

void Findings::say(const std::string& words) {
    said_ += (said_.empty() ? "" : "; ") + words;
}

std::string Findings::result() const {
    std::string words = said_;
    if (agreements_ > 0)
        words += fmt::format("{}{} compared, at most {:+.1f} s.e. off",
                             words.empty() ? "" : "; ", agreements_, most_off_);
    return words.empty() ? "as expected" : words;
}

std::vector<ExtremeCase> extreme_cases() {
    std::vector<ExtremeCase> all = extreme_suns_and_fields();
    for (const auto& more : {extreme_surfaces(), extreme_days_and_paths()})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

Mesh leaves_only() {
    Mesh mesh;
    mesh.groups.push_back({"leaf"});
    return mesh;
}

void add_leaf(Mesh& mesh, glm::dvec3 corner, glm::dvec3 u, glm::dvec3 v) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(),
                         {corner, corner + u, corner + u + v, corner + v});
    mesh.faces.push_back({first, first + 1, first + 2, first + 3});
    mesh.face_group.push_back(0);
}

Mesh two_leaves(double length, double width, double insertion_angle) {
    Plant plant;
    plant.leaves = {{length, width, insertion_angle, 60, 0, 0.2},
                    {length, width, insertion_angle, 40, 90, 0.5}};
    plant.blade.width_controls = {0.28,     0.885870, 0.895017,
                                  1.149943, 0.379696, 0.0};
    plant.stalk.is_present = false;
    return build_plant(plant, {});
}

}  // namespace ideotype
