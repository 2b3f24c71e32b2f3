// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <fmt/format.h>

#include "mesh_study.hpp"

namespace ideotype {

namespace {

void check_ground(const MeshSpec& spec, const Problems& problems) {
    constexpr double most_plants = 1e6;
    const auto& [x, y] = spec.period.value_or(MeshSpec::Period{});
    const double cell = x * y, area = spec.ground_area.value_or(cell);
    const bool is_isolated = spec.boundary == Boundary::isolated;
    problems.named_rule({"period", "field"}, spec.period && spec.field,
                        "{0} and {1} contradict each other: the spacing of a "
                        "field sets its period");
    problems.named_rule({"jitter", "field"}, spec.jitter && !spec.field,
                        "{0} needs {1}");
    problems.named_rule(
        {"field"},
        spec.field && 1.0 * spec.field->rows * spec.field->plants > most_plants,
        "{0}: from one to a million plants");
    problems.named_rule(
        {"boundary", "ground_area"},
        is_isolated && !spec.ground_area && !spec.field,
        "an isolated mesh needs {1}, the area of ground that fractions "
        "refer to");
    problems.named_rule(
        {"period"}, !is_isolated && !spec.period && !spec.field,
        "{0} X Y is missing (the lattice on which the mesh repeats; it does "
        "not follow from the extent of the mesh)");
    problems.named_rule({"ground_area", "field"},
                        !is_isolated && spec.ground_area && spec.field,
                        "{0}: a field has the area of its spacings");
    problems.named_rule(
        {"ground_area", "period"},
        !is_isolated && spec.period && std::abs(area - cell) > 1e-6 * cell,
        "{0} {2} contradicts {1}, which spans {3:.6g} m2", area, cell);
}

void check_light(const MeshSpec& spec, const Problems& problems) {
    const bool is_clear = spec.sky == SkyModel::clear;
    problems.named_rule({"site", "date"},
                        spec.site.has_value() != spec.has_date(),
                        "{0} and {1} belong together");
    problems.named_rule(
        {"sun", "sky", "site", "date", "climate"},
        !spec.sun && !spec.sky && !spec.has_day(),
        "the light is missing: give {0}, {1}, {2} with {3}, or {4}");
    problems.named_rule(
        {"climate", "site", "sun", "beam_ppfd", "sky_ppfd"},
        !spec.climate.empty() && (spec.site || spec.sun || spec.has_ppfd()),
        "{0} has all light of a season; leave out {1}, {2}, {3} and {4}");
    problems.named_rule({"sun", "site"}, spec.site && spec.sun,
                        "{0} and {1} are two light sources; give one");
    problems.named_rule(
        {"sun", "sky", "beam_ppfd", "sky_ppfd"},
        spec.beam_ppfd.has_value() != spec.sky_ppfd.has_value() && spec.sun &&
            spec.sky,
        "{0} and {1} together need {2} and {3}");
    problems.named_rule({"sun", "sky", "beam_ppfd", "sky_ppfd"},
                        spec.sun && spec.sky && !is_clear && !spec.beam_ppfd,
                        "{0} and {1} are two light sources; give one, or the "
                        "irradiance of each: {2} and {3}");
    problems.named_rule({"beam_ppfd", "sun"}, spec.beam_ppfd && !spec.sun,
                        "{0} needs the position of the sun: {1}");
    problems.named_rule({"sky_ppfd", "sky"}, spec.sky_ppfd && !spec.sky,
                        "{0} needs a sky: {1} uniform, overcast or clear");
    problems.named_rule(
        {"beam_ppfd", "sky_ppfd"},
        spec.has_ppfd() &&
            !(spec.beam_ppfd.value_or(0) + spec.sky_ppfd.value_or(0) > 0),
        "{0} and {1}: there is no light");
    problems.named_rule(
        {"site", "beam_ppfd", "sky_ppfd"}, spec.site && spec.has_ppfd(),
        "{0} has the light of a clear day; leave out {1} and {2}");
    problems.named_rule({"sky", "sun"},
                        is_clear && !spec.sun && !spec.has_day(),
                        "{0} clear needs the position of the sun: {1}");
    problems.named_rule({"sun"}, spec.sun && !(spec.sun->elevation > 0),
                        "{0}: the sun is not above the horizon");
}

void check_leaves(const MeshSpec& spec, const Problems& problems) {
    problems.named_rule(
        {"photosynthesis", "beam_ppfd", "sky_ppfd", "site", "date", "climate"},
        !spec.photosynthesis.empty() && !spec.has_ppfd() && !spec.has_day(),
        "{0} needs the irradiance: {1}, {2}, a day with {3} and {4}, or {5}");
    problems.named_rule(
        {"scene", "photosynthesis"},
        !spec.scene.empty() && !spec.photosynthesis.empty(),
        "{0} states the photosynthesis of each component; leave out {1}");
    problems.named_rule(
        {"exact", "photosynthesis"},
        spec.is_exact && spec.photosynthesis.empty() && spec.scene.empty(),
        "{0} is a method to compute assimilation; it needs {1}");
    for (const auto& [name, surface] :
         {std::pair("leaf", spec.optics.leaf),
          std::pair("stalk", spec.optics.stalk),
          std::pair("sheath", spec.optics.sheath)})
        problems.named_rule(
            {fmt::format("{}_reflectance", name),
             fmt::format("{}_transmittance", name)},
            surface.reflectance + surface.transmittance > 1 + 1e-12,
            "{0} and {1} exceed 1 together");
}

}  // namespace

void check_rules(const MeshSpec& spec, const Problems& problems) {
    check_ground(spec, problems);
    check_light(spec, problems);
    check_leaves(spec, problems);
    problems.throw_wrong_usage();
}

}  // namespace ideotype
