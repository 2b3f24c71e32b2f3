// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "beams/beam_costs.hpp"
#include "beams/beam_lattice.hpp"
#include "beams/depth_buffer.hpp"
#include "beams/directions.hpp"
#include "beams/first_hits.hpp"
#include "contracts.hpp"
#include "ideotype/core/random.hpp"
#include "ideotype/light/backward.hpp"
#include "ideotype/light/leaf_points.hpp"
#include "ideotype/light/report.hpp"
#include "ideotype/light/resolution.hpp"
#include "ideotype/light/sunlit.hpp"
#include "ideotype/light/tolerance.hpp"
#include "one_band.hpp"
#include "paths/launch.hpp"
#include "paths/ledger.hpp"
#include "paths/tracer.hpp"
#include "paths/travel.hpp"
#include "resolution_of.hpp"
#include "tolerance/allocation.hpp"
#include "tolerance/trial.hpp"
#include "tolerance/workload.hpp"

namespace ideotype {

namespace {

//! A level leaf in a cell, under one beam.
struct Stand {
    Mesh mesh{{{.2, .2, 1}, {.8, .2, 1}, {.8, .8, 1}, {.2, .8, 1}},
              {{0, 1, 2, 3}},
              {0},
              {{"leaf"}}};
    Device device{Device::supported_isas().front()};
    RayScene scene{device, mesh, 1, 1};
    Optics optics{{{.1, .1}}, .2};
    Illumination light{{{glm::dvec3{0, 0, -1}, 1, {}}}};
    Layers layers{};
    Workload work{{16}, {{.1}}};
    Accuracy accuracy{16, 2};

    std::vector<Tally> tallies() const {
        return simulate(scene, mesh.groups, optics, light, accuracy, {});
    }
    BackwardLight backward() const {
        return {scene, mesh.groups, optics, light.sources};
    }
    void simulate_work(const Workload& other, int randomisations = 2) const {
        simulate(scene, mesh.groups, optics, light, other, randomisations, {});
    }
};

constexpr glm::dvec3 down{0, 0, -1};
const LeafPoint middle{{.5, .5, 1}, {0, 0, 1}, 0, false};

DepthBuffer drawn(const Stand& stand, std::vector<glm::dvec2> shifts,
                  const glm::dvec3& direction = down) {
    return {stand.scene, direction, beam_lattice(1, 1, 11, 1, down),
            std::move(shifts)};
}

}  // namespace

TEST(Contracts, OfSimulationsAreNoticed) {
    const Stand s;
    Illumination none;
    const Band band = band_of(s.optics, s.light), dark = band_of({}, none);
    const std::vector<Band> unequal{band, dark};
    const auto subject = [&](std::span<const Band> bands) {
        return Subject{s.scene, s.mesh.groups, bands, s.layers};
    };
    Accuracy nothing{0, 2, .01};
    expect_noticed({
        {"!bands.empty()", [&] { simulate(subject({}), s.work, 2, {}); }},
        {"randomisations > 0 && subject.layers.count > 0",
         [&] { s.simulate_work(s.work, 0); }},
        {"work.first_hits.size() == sources.size()",
         [&] {
             s.simulate_work({{16, 16}, {{.1}}});
         }},
        {"band.light.light.sources.size() == sources.size()",
         [&] { simulate(subject(unequal), s.work, 2, {}); }},
        {"how.path_energy > 0",
         [&] {
             s.simulate_work({{16}, {{0}}});
         }},
        {"accuracy.paths > 0 && accuracy.randomisations > 0",
         [&] {
             simulate_to_tolerance(s.scene, s.mesh.groups, s.optics, s.light,
                                   nothing, {});
         }},
        {"randomisations > 1 && !work.path_energy.empty()",
         [&] {
             try_out(subject({&band, 1}), s.work, 1, {}, false);
         }},
    });
}

TEST(Contracts, OfWorkAreNoticed) {
    const Stand s;
    expect_noticed({
        {"amount > 0 && other > 0", [] { Law{}.at(0); }},
        {"variance > 0", [] { allocate({}, {}, 0); }},
        {"!sources.empty() && paths >= sources.size()",
         [&] { share_paths(s.light, 0); }},
        {"!sources.empty() && paths >= sources.size()",
         [&] { share_paths({}, 16); }},
        {"work.first_hits.size() == light.sources.size()",
         [&] { amounts_of({}, s.light); }},
        {"!work.path_energy.empty() && !work.path_energy.front().empty()",
         [&] {
             amounts_of({{16}, {}}, s.light);
         }},
        {"amounts[LightOrigin::scattered] > 0", [&] { work_of({}, s.light); }},
        {"kept > 0 && work.first_hits.size() == light.sources.size()",
         [&] {
             Workload work = s.work;
             leave_suns_out(work, s.light, 0);
         }},
    });
}

TEST(Contracts, OfBeamsAreNoticed) {
    const Stand s;
    const auto draw = [&](std::vector<glm::dvec2> shifts,
                          const glm::dvec3& direction) {
        drawn(s, std::move(shifts), direction);
    };
    expect_noticed({
        {"first_hits > 0 && randomisations > 0",
         [&] { lattice_of(s.scene, down, 0, 1); }},
        {"period_x > 0 && period_y > 0",
         [] { beam_lattice(0, 1, 9, 1, down); }},
        {"points > 0 && lanes > 0", [] { beam_lattice(1, 1, 0, 1, down); }},
        {"direction.z < 0", [] { beam_lattice(1, 1, 9, 1, -down); }},
        {"direction.z < 0 && !shifts.empty()", [&] { draw({}, down); }},
        {"direction.z < 0 && !shifts.empty()",
         [&] {
             draw({{0, 0}}, -down);
         }},
        {"shift.x >= 0 && shift.x < 1 && shift.y >= 0 && shift.y < 1",
         [&] {
             draw({{0, 1}}, down);
         }},
        {"point < points() && (randomisation + 1) * per_pixel_ <= lanes_",
         [&] {
             drawn(s, {{0, 0}}).position(0, 11);
         }},
        {"scene.boundary() == Boundary::periodic",
         [&] {
             const RayScene plot = RayScene::isolated(s.device, s.mesh, 1);
             DepthBuffer(plot, down, beam_lattice(1, 1, 11, 1, down), {{0, 0}});
         }},
        {"soil_albedo >= 0 && soil_albedo <= 1",
         [&] { Launcher(s.scene, s.light.sources[0], 2); }},
        {"energy >= 0",
         [&] {
             FirstHits(s.scene, drawn(s, {{0, 0}}), 0, -1);
         }},
        {"i < hits_.size() && hits_[i].group != Hit::sky",
         [&] {
             const DepthBuffer buffer = drawn(s, {{0, 0}});
             const FirstHits hits(s.scene, buffer, 0, 1);
             hits.at(hits.size());
         }},
    });
}

TEST(Contracts, OfRaysAreNoticed) {
    const Stand s;
    Hit hit;
    Mesh open = s.mesh, beyond = s.mesh;
    open.face_group.clear();
    beyond.faces[0][3] = 4;
    Surfaces surfaces;
    expect_noticed({
        {"distance >= 0",
         [&] {
             s.scene.intersect({.5, .5, 2}, down, -1, hit);
         }},
        {"std::abs(glm::dot(direction, direction) - 1) < 1e-3",
         [&] {
             s.scene.intersect({.5, .5, 2}, 2. * down, 1, hit);
         }},
        {"std::abs(glm::dot(normal, normal) - 1) < 1e-6",
         [&] {
             s.scene.offset_origin({.5, .5, 1}, {0, 0, 2});
         }},
        {"direction.z != 0",
         [&] {
             travel(s.scene, {0, 0, 1}, {1, 0, 0});
         }},
        {"u >= 0 && u < 1 && v >= 0 && v < 1",
         [] {
             lambertian({0, 0, 1}, 1, 0);
         }},
        {"std::abs(glm::dot(n, n) - 1) < 1e-6",
         [] {
             lambertian({0, 0, 2}, 0, 0);
         }},
        {"mesh.face_group.size() == mesh.faces.size()",
         [&] { RayScene(s.device, open, 1, 1); }},
        {"mesh.face_group.size() == mesh.faces.size()",
         [&] { RayScene::isolated(s.device, open, 1); }},
        {"mesh.face_group.size() == mesh.faces.size()",
         [&] { LeafPoints{open}; }},
        {"std::ranges::max(face) < mesh.vertices.size()",
         [&] { RayScene(s.device, beyond, 1, 1); }},
        {"std::ranges::max(face) < vertices.size()",
         [&] {
             surfaces.add({0, 1, 2, 3}, 0, 0);
         }},
        {"!ends_.empty() && share >= 0 && share < 1",
         [&] { LeafPoints(s.mesh).at(1, 0, 0); }},
        {"!ends_.empty() && share >= 0 && share < 1",
         [] { LeafPoints(Mesh{}).at(0, 0, 0); }},
    });
}

TEST(Contracts, OfBackwardLightAreNoticed) {
    const Stand s;
    LeafPoint odd = middle;
    odd.group = 1;
    RandomStream random(1, Purpose::backward);
    std::vector<double> light(1), more(2);
    expect_noticed({
        {"source < sources_.size() && sources_[source].direction",
         [&] { s.backward().beam(middle, 1); }},
        {"point.group < groups_.size()", [&] { s.backward().beam(odd, 0); }},
        {"light.size() == sources_.size()",
         [&] { s.backward().add_diffuse(middle, random, more); }},
        {"light.size() == sources_.size()",
         [&] { s.backward().add_level({}, random, more); }},
    });
}

TEST(Contracts, OfIlluminationAreNoticed) {
    LightSeries series;
    series.steps = {{8, 1800, {60, 90}, {100, 50}}};
    const SeriesIllumination day = illuminate(series, SkyModel::uniform, 0);
    SeriesIllumination lacking = day;
    lacking.sky_of.clear();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    expect_noticed({
        {"series.days > 0 && dates >= 0",
         [=] { illuminate(series, SkyModel::uniform, 0, Skies::shared, -1); }},
        {"std::isfinite(row_direction)",
         [=] { illuminate(series, SkyModel::uniform, nan); }},
        {"light.sky_of.size() == light.series.steps.size()",
         [=] { in_band(lacking, &TimeStep::par); }},
    });
}

TEST(Contracts, OfTalliesAreNoticed) {
    const Stand s;
    Tally tally{std::vector<Budget>(1), {0}, {0}};
    Tally without_groups{std::vector<Budget>(1), {}, {0}};
    LeafSums sums;
    const Counted counted{s.scene, s.mesh.groups, s.layers};
    const Counted pieces{s.scene, s.mesh.groups, s.layers, 2};
    const FirstHit hit{0, 0, 1, true, true, 1}, odd{7, 0, 1, true, true, 1};
    expect_noticed({
        {"tally.groups.size() == counted.groups.size()",
         [&] { Ledger(counted, 0, true, without_groups, sums); }},
        {"counted.pieces <= counted.groups.size()",
         [&] { Ledger(pieces, 0, true, tally, sums); }},
        {"sent_on >= 0 && sent_on <= energy * (1 + 1e-12)",
         [&] { Ledger(counted, 0, true, tally, sums).arrive(hit, 1, 2); }},
        {"group < counted_.groups.size()",
         [&] { Ledger(counted, 0, true, tally, sums).arrive(odd, 1, 0); }},
    });
}

TEST(Contracts, OfReportsAreNoticed) {
    const Stand s;
    const std::vector<Tally> tallies = s.tallies();
    Resolution some = *tallies.front().resolution, more = some;
    more.groups.push_back(0);
    Accuracy no_points{0, 2};
    Optics bright;
    bright.soil_albedo = 1.5;
    expect_noticed({
        {"!tallies.empty()",
         [] { report(std::vector<Tally>{}, SeriesIllumination{}); }},
        {"tallies.front().sources.size() == sources.size()",
         [&] { report(tallies, SeriesIllumination{}); }},
        {"!tallies.empty()", [] { absorbed_by_group({}); }},
        {"g < tallies.front().groups.size()",
         [&] { absorbed_by_groups(tallies, {1}); }},
        {"sunlit.steps.size() == illumination.light.sources.size()",
         [] {
             report(SunlitFractions{{}, {1}}, SeriesIllumination{});
         }},
        {"a.groups.size() == b.groups.size()", [&] { combined(some, more); }},
        {"optics.soil_albedo >= 0 && optics.soil_albedo <= 1",
         [&] { resolution_of(s.scene, s.mesh.groups, bright, s.layers, {1}); }},
        {"accuracy.paths > 0 && accuracy.randomisations > 0",
         [&] { sunlit_fractions(s.scene, s.mesh, s.light, no_points, {}); }},
        {"triangle < all.normals.size()",
         [&] { beam_absorptance(s.scene, s.mesh.groups, s.optics, 2, down); }},
        {"triangle < scene.surfaces().normals.size()",
         [&] { beam_cosine(s.scene, 2, down); }},
    });
}

}  // namespace ideotype
