// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "contracts.hpp"
#include "fields/field_light.hpp"
#include "fields/randomisations.hpp"
#include "ideotype/canopy/exact_assimilation.hpp"
#include "ideotype/canopy/panels.hpp"
#include "ideotype/canopy/quantities.hpp"
#include "ideotype/canopy/sensors.hpp"
#include "ideotype/light/device.hpp"
#include "ideotype/light/transport.hpp"
#include "light/one_band.hpp"
#include "pair_light.hpp"
#include "quantities/declaration.hpp"
#include "two_leaves.hpp"
#include "water/wind_profile.hpp"

namespace ideotype {

namespace {

//! Plants of two leaves that assimilate, cut into pieces, and their light in
//! four randomisations.
struct Stand {
    Stand() {
        component().photosynthesis.emplace();
        lines = {cut_leaves(component().mesh)};
        field = draw_field(request.scene, {1}, {&lines[0].mesh, 1});
        drawn = field;
        pieces = pieces_of_field(lines, field);
        groups = pieces.mesh.groups;
        field.mesh = pieces.mesh;
        surfaces.emplace(build_scene(device, field));
        leaves = leaf_groups(request.scene, component().mesh.groups,
                             std::vector<double>(lines[0].uncut_groups, 1));
        tallies = simulate(*surfaces, groups, par().optics, par().light.light,
                           {64, 4}, {1}, {}, pieces.count);
    }

    Component& component() { return request.scene.components[0]; }
    const Band& par() const { return request.scene.bands[0]; }
    LitLeaves lit(double photons = 4.57) const {
        return {*surfaces, groups, par(), photons, leaves, layers};
    }
    LeafPlaces places() const { return {pieces, lit(), false}; }
    FluxTallies fluxes() const { return assimilate(tallies, pieces, lit()); }
    void evaluate_it() const { evaluate(request, device); }

    const Device device{Device::supported_isas().back()};
    const Layers layers;
    CanopyRequest request = two_leaves({64, 4});
    std::vector<Pieces> lines;
    Field field, drawn;
    Pieces pieces;
    std::vector<Group> groups;
    std::optional<RayScene> surfaces;
    std::vector<LeafGroup> leaves;
    std::vector<Tally> tallies;
};

const SunPosition noon{30, 180};

}  // namespace

TEST(Contracts, OfRequestsAreNoticed) {
    const auto changed = [](auto change) {
        return [change] {
            Stand s;
            change(s.request);
            s.evaluate_it();
        };
    };
    Scene dark;
    CanopyReport empty;
    BandReport band;
    band.parts.resize(2);
    const Stand s;
    const Plan plan(s.request);
    expect_noticed({
        {"request.scene.cell.ground_area > 0",
         changed([](auto& r) { r.scene.cell.ground_area = 0; })},
        {"request.layers.count > 0 && request.details.pieces > 0",
         changed([](auto& r) { r.layers.count = 0; })},
        {"request.layers.count > 0 && request.details.pieces > 0",
         changed([](auto& r) { r.details.pieces = 0; })},
        {"accuracy.paths > 0 && accuracy.randomisations > 0",
         changed([](auto& r) { r.accuracy.paths = 0; })},
        {"accuracy.tolerance >= 0",
         changed([](auto& r) { r.accuracy.tolerance = -1; })},
        {"field >= 0 && field < fields", [&] { plan.of_light(1); }},
        {"field >= 0 && field < fields", [&] { plan.of_plants(-1); }},
        {"!bands.empty()", [&] { dark.light(); }},
        {"!bands.empty()", [&] { empty.par(); }},
        {"parts.empty() || number < parts.size()", [&] { band.part(2); }},
        {"hour < light.steps.size()", [&] { band.leaves_at(0, 0); }},
        {"faces > 0 && accuracy.randomisations > 0",
         [] { face_accuracy({}, 0); }},
        {"points > 0", [&] { light_on_sensors(s.request, s.device, {}, 0); }},
    });
}

TEST(Contracts, OfFieldsAreNoticed) {
    const FieldForm form{2, 2, {.76, .15}};
    FieldForm no_rows = form, no_distance = form, touching = form;
    no_rows.rows = 0;
    no_distance.spacing.plant = 0;
    touching.row_pattern = {1, 0};
    Component nowhere, turned, mixed, varied;
    nowhere.places.clear();
    turned.jitter = -1;
    mixed.mixed = 2;
    varied.variation.length = .1;
    Scene crowd, strangers;
    crowd.components = {mixed};
    strangers.components = {varied};
    const Stand s;
    const std::vector<Mesh> two(2);
    Mesh open = s.request.scene.components[0].mesh;
    open.face_group.clear();
    Scene ragged = s.request.scene;
    ragged.components[0].mesh = open;
    Field none;
    expect_noticed({
        {"form.rows > 0 && form.plants > 0 && form.border_rows >= 0",
         [&] { cell_of(no_rows); }},
        {"form.spacing.row > 0 && form.spacing.plant > 0",
         [&] { cell_of(no_distance); }},
        {"std::ranges::min(pattern) > 0", [&] { places_of(touching); }},
        {"!component.places.empty()", [&] { set_places(nowhere, form, {7}); }},
        {"component.plants() > 0 && component.jitter >= 0",
         [&] { draw_plant_azimuths(turned, {}); }},
        {"!items.empty()",
         [&] {
             Scene scene;
             scene.components = {mixed};
             scene.components[0].places.clear();
             draw_places(scene, {});
         }},
        {"each.mixed <= shared.size()", [&] { draw_places(crowd, {}); }},
        {"component.plant.has_value()", [&] { draw_field(strangers, {}); }},
        {"lines.empty() || lines.size() == scene.components.size()",
         [&] { draw_field(s.request.scene, {}, two); }},
        {"plant.face_group.size() == plant.faces.size()",
         [&] { draw_field(ragged, {}); }},
        {"field.first_plant.size() == scene.components.size() + 1",
         [&] { as_drawn(s.request.scene, none); }},
    });
}

TEST(Contracts, OfPanelsAreNoticed) {
    PanelRows tracking;
    tracking.width = 2;
    PanelRows stiff = tracking;
    stiff.pitch = 4;
    stiff.max_angle = -1;
    const Cell cell{Boundary::periodic, 4, 4, 16};
    expect_noticed({
        {"panels.pitch > 0 && panels.width > 0",
         [&] { tracker_angle(tracking, noon); }},
        {"panels.max_angle >= 0", [&] { tracker_angle(stiff, noon); }},
        {"part > 0 && whole > 0", [] { divides(0, 4); }},
        {"panels.width > 0 && panels.module_length >= 0",
         [&] { panel_mesh({}, cell, 0, 30); }},
    });
}

TEST(Contracts, OfPiecesAreNoticed) {
    const Stand s;
    const Mesh& mesh = s.request.scene.components[0].mesh;
    Mesh open = mesh;
    open.face_group.clear();
    Field drawn = s.drawn, cut = s.drawn;
    cut.face_plant.clear();
    Pieces unlike = s.pieces, ahead = s.pieces, rowless = s.pieces;
    unlike.like.pop_back();
    ahead.like.front() = 1;
    rowless.rows = 2;
    const std::vector<Group> few(1);
    std::vector<Tally> longer = s.tallies, lost = s.tallies;
    longer.front().groups.push_back(0);
    lost.front().resolution = nullptr;
    std::vector<double> short_list{1};
    expect_noticed({
        {"mesh.face_group.size() == mesh.faces.size()",
         [&] { cut_leaves(open); }},
        {"per_blade > 0", [&] { cut_leaves(mesh, 0); }},
        {"copies > 0 && tolerance >= 0 && per_blade > 0",
         [&] { cut_coarse_leaves(mesh, 0, 0); }},
        {"field.first_plant.size() == lines.size() + 1",
         [&] { pieces_of_field({}, drawn); }},
        {"field.face_plant.size() == field.mesh.faces.size()",
         [&] { pieces_of_field(s.lines, cut); }},
        {"pieces.like.size() == pieces.count && "
         "pieces.area.size() == pieces.count",
         [&] { LeafPlaces(unlike, s.lit(), false); }},
        {"pieces.like[v] <= v", [&] { LeafPlaces(ahead, s.lit(), false); }},
        {"lit.groups.size() >= pieces.count",
         [&] {
             LeafPlaces(s.pieces,
                        {*s.surfaces, few, s.par(), 1, s.leaves, s.layers},
                        false);
         }},
        {"!all.empty()", [] { mean_of(std::vector<Tally>{}); }},
        {"!all.empty()", [] { mean_of(std::vector<std::vector<double>>{}); }},
        {"mean.resolution != nullptr", [&] { mean_of(lost); }},
        {"more.size() <= all.size()",
         [&] {
             add(short_list, {1, 2});
         }},
        {"pieces.row.size() == groups.size()",
         [&] { light_of_rows(s.tallies, rowless, s.groups); }},
        {"of_pieces.size() == pieces.group.size()",
         [&] { add_up_pieces(longer, s.pieces, 9); }},
    });
}

TEST(Contracts, OfLeafLightAreNoticed) {
    const Stand s;
    const LeafPlaces places = s.places();
    const ExpectedLight expectation(places, s.tallies);
    const DiffuseLight other({}, -1, 1);
    SkyLight sky(s.tallies, -1, places, expectation);
    PairLight pair(s.tallies, s.lit(), places, expectation, -1, sky);
    const std::vector<Tally> two(s.tallies.begin(), s.tallies.begin() + 2);
    PairLight of_two(two, s.lit(), places, expectation, -1, sky);
    std::vector<std::vector<double>> differences;
    SkyWeights of_sky(s.pieces.count);
    int sky_number = 0;
    for (const Source& each : s.par().light.light.sources) {
        if (!each.direction) break;
        ++sky_number;
    }
    expect_noticed({
        {"s < tallies[r].leaf_light.size()",
         [&] { DiffuseLight(s.tallies, 99, s.pieces.count); }},
        {"v < pieces", [&] { DiffuseLight(s.tallies, sky_number, 1); }},
        {"light.sum.size() == places_.pieces()",
         [&] { expectation.of(other); }},
        {"source.direction.has_value()",
         [&] {
             PairLight(s.tallies, s.lit(), places, expectation, sky_number,
                       sky);
         }},
        {"tallies_.size() > 2",
         [&] { of_two.scatter({}, of_sky, differences); }},
        {"weights.places.size() == places_.count() && "
         "weights.bins.size() == bins_.size() && "
         "differences.size() == tallies_.size()",
         [&] { pair.scatter({}, of_sky, differences); }},
        {"tallies.size() == 1 || tallies.size() > 2",
         [&] { assimilate(two, s.pieces, s.lit()); }},
        {"lit.photons > 0", [&] { assimilate(s.tallies, s.pieces, s.lit(0)); }},
        {"!tallies.empty() && lit.photons > 0",
         [&] { leaf_area_by_light({}, s.pieces, s.lit()); }},
        {"!randomisations.empty()",
         [] { report(std::vector<LightClasses>{}); }},
        {"number < ppfd_classes", [] { class_begin(ppfd_classes); }},
        {"accuracy.paths > 0 && accuracy.randomisations > 0",
         [&] {
             const Mesh& mesh = s.request.scene.components[0].mesh;
             assimilate_exactly(mesh, s.lit(), {0, 2}, {});
         }},
        {"lit.leaves.size() == mesh.groups.size()",
         [&] { assimilate_exactly(s.pieces.mesh, s.lit(), {}, {}); }},
    });
}

TEST(Contracts, OfLeafAirAreNoticed) {
    Stand s;
    s.request.scene.water.emplace();
    s.request.scene.bands[0].light.series.steps.clear();
    LeafAir leaves({s.request.scene, s.leaves, s.groups, 2, {}});
    const LeafPlaces places(s.pieces, s.lit(), false);
    const ExpectedLight expectation(places, s.tallies);
    expect_noticed({
        {"wind >= 0 && height > 0", [] { wind_at_top(2, 0, 1); }},
        {"wind >= 0 && height > 0", [] { aerodynamic_resistance(-1, 2, 1); }},
        {"places.width.size() == places.count()",
         [&] { leaves.see(places, expectation); }},
        {"places_ != nullptr && number < series_.steps.size()",
         [&] { leaves.begin(0); }},
    });
}

TEST(Contracts, OfReportsAreNoticed) {
    Stand s;
    const LightSeries& series = s.par().light.series;
    const std::vector<double> areas(s.leaves.size(), 1), one{1};
    const std::vector<Group>& groups = s.component().mesh.groups;
    std::vector<FluxTally> gross = s.fluxes().front();
    const AssimilationReport assimilation =
        report(gross, {}, s.leaves, areas, s.par().light);
    Scene built = s.request.scene;
    built.components[0].built = one;
    Photosynthesis eternal = *s.component().photosynthesis;
    eternal.building_days = 0;
    std::vector<LeafGroup> leaves = s.leaves;
    for (LeafGroup& each : leaves)
        if (each.photosynthesis) each.photosynthesis = &eternal;
    Scene strange = s.request.scene;
    strange.components[0].plant.reset();
    CanopyReport empty;
    FieldLight found, more;
    found.light.resize(1);
    const auto seconds = [](const TimeStep& step) { return step.seconds; };
    expect_noticed({
        {"leaf_area_index.size() == groups.size()",
         [&] { leaf_groups(s.request.scene, groups, one); }},
        {"built.empty() || built.size() >= index.size()",
         [&] { leaf_groups(built, groups, areas); }},
        {"report.losses.size() == groups.size()",
         [&] { by_component(assimilation, {}, 1); }},
        {"!tallies.empty()", [&] { report({}, series, seconds); }},
        {"tallies.front().steps.size() == series.steps.size()",
         [&] { report(gross, LightSeries{}, seconds); }},
        {"leaves.size() == leaf_area_index.size()",
         [&] { report(gross, {}, s.leaves, one, s.par().light); }},
        {"respired.size() == uptake.size()",
         [&] {
             report(gross, std::vector<FluxTally>(1), s.leaves, areas,
                    s.par().light);
         }},
        {"(this->*part).size() == (more.*part).size()",
         [&] { gross.front() += FluxTally{}; }},
        {"photosynthesis->building_days > 0",
         [&] { report(gross, {}, leaves, areas, s.par().light); }},
        {"tallies.size() == leaf_fluxes",
         [&] { report(FluxTallies{gross}, areas, series); }},
        {"light.empty() || light.size() == more.light.size()",
         [&] { found.append(more); }},
        {"!scene.components.empty()", [] { canopy_quantities({}, {}, {}); }},
        {"std::ranges::all_of(scene.components, &has_plant)",
         [&] { canopy_quantities(strange, {}, {}); }},
        {"!parts.empty() && parts.size() == weights.size()",
         [] {
             weighted_sum({{}}, {1, 2});
         }},
        {"each.size() == estimates.size()",
         [] {
             randomised({{1, 0}}, {{1, 2}});
         }},
        {"groups.size() == report.groups.size()",
         [&] { over_leaves(empty, one, 0); }},
    });
}

}  // namespace ideotype
