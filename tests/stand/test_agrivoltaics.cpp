// SPDX-License-Identifier: Apache-2.0
// Tests campaigns with panels and other objects.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ideotype/canopy/quantities.hpp"
#include "ideotype/canopy/sensors.hpp"
#include "ideotype/core/error.hpp"
#include "stand/stand.hpp"
#include "temporary_folder.hpp"

namespace ideotype {
namespace {

using ::testing::HasSubstr;
using Settings = std::vector<std::string>;

const std::string panel =
    "panel=[{pitch=3.048, height=4, width=1.5, tilt=25, azimuth=180, "
    "offset=1.524}]";

Campaign campaign_with(Settings settings) {
    settings.insert(settings.begin(),
                    {"light.paths=16384", "light.randomisations=16"});
    return read_campaign(IDEOTYPE_CAMPAIGNS "/ames_quick.toml", settings);
}

CanopyReport light_of_field(const Settings& settings) {
    const Campaign campaign = campaign_with(settings);
    const Case chosen = cases(campaign).front();
    return evaluate(
        request_of(sampling_of(Task{}, campaign, chosen), campaign, chosen,
                   scene_of(campaign, chosen), {campaign.crop.baseline}),
        Device(Device::supported_isas().back()));
}

std::string error_of(const Settings& settings) {
    try {
        campaign_with(settings);
    } catch (const InputError& error) {
        return error.problems().front().what;
    }
    return "";
}

void expect_equal(const Estimate& a, const Estimate& b) {
    EXPECT_NEAR(a.mean, b.mean,
                4 * std::hypot(a.standard_error, b.standard_error));
}

TEST(Agrivoltaics, PanelsAbsorbLightButAreNotLeaves) {
    const CanopyReport open = light_of_field(Settings{});
    const CanopyReport below = light_of_field({panel});
    EXPECT_EQ(below.lai, open.lai);
    EXPECT_EQ(below.plant_area_index, open.plant_area_index);
    EXPECT_EQ(below.layers.count, open.layers.count);
    const BudgetEstimate &shaded = below.par().light.day,
                         &full = open.par().light.day;
    EXPECT_EQ(shaded.incident, full.incident);
    EXPECT_GT(shaded.objects.mean, .4 * full.incident);
    EXPECT_LT(shaded.plants.mean, .6 * full.plants.mean);
    EXPECT_NEAR(shaded.plants.mean + shaded.objects.mean + shaded.soil.mean +
                    shaded.reflected.mean,
                shaded.incident, 1e-9 * shaded.incident);
    // Modules with a reflectance of 5 % absorb the remaining light that falls
    // on them.
    const ObjectReport& object = below.objects.front();
    EXPECT_NEAR(object.area_index, 1.5 / 3.048, 1e-12);
    const std::vector<PartLight>& sides = below.par().objects;
    EXPECT_NEAR(
        (sides[0].day.mean + sides[1].day.mean) * object.area_index * .95,
        shaded.objects.mean, 1e-9 * shaded.incident);
    EXPECT_GT(sides[0].day.mean, 4 * sides[1].day.mean);
    EXPECT_NEAR(measure_objective("panel_light", below).estimate.mean * 1e6,
                shaded.objects.mean / .95, 1e-9 * shaded.incident);
}

//! PAR and near infrared do not overlap, and each counts once.
TEST(Agrivoltaics, LightOnPanelsIsSummedOverBands) {
    const Settings both{panel, "band=[{name=\"nir\"}]"};
    const CanopyReport report = light_of_field(both);
    ASSERT_EQ(report.bands.size(), 2u);
    const DayReport &par = report.bands[par_band].light,
                    &nir = report.bands[nir_band].light;
    EXPECT_NEAR(par.day.incident / (par.day.incident + nir.day.incident),
                campaign_with(both).spec.par_fraction, 1e-9);
    // Modules reflect 5 % of PAR and 15 % of near infrared.
    EXPECT_NEAR(measure_objective("panel_light", report).estimate.mean * 1e6,
                par.day.objects.mean / .95 + nir.day.objects.mean / .85,
                1e-9 * par.day.incident);
}

TEST(Agrivoltaics, HoursOfPanelsSumToTheirDay) {
    const CanopyReport report = light_of_field({panel});
    const Campaign campaign = campaign_with({panel});
    const LightSeries series = light_of(campaign, cases(campaign).front());
    for (const PartLight& side : report.par().objects) {
        double sum = 0;
        for (std::size_t h = 0; h < side.hours.size(); ++h)
            sum += side.hours[h].mean * series.steps[h].seconds;
        EXPECT_NEAR(sum / side.day.mean, 1, 1e-12);
    }
}

TEST(Agrivoltaics, TheCellMayBeMuchNarrowerThanPanelsAreHigh) {
    const Settings four{panel, "field.jitter=0"};
    const Settings one{panel, "field.jitter=0", "field.plants=1"};
    const CanopyReport a = light_of_field(four), b = light_of_field(one);
    expect_equal(a.par().light.day.plants, b.par().light.day.plants);
    expect_equal(a.par().light.day.soil, b.par().light.day.soil);
    for (const std::size_t side : {0, 1})
        expect_equal(a.par().objects[side].day, b.par().objects[side].day);
}

//! At an hour at which a tracking panel has the angle of a fixed panel, both
//! give equal light.
TEST(Agrivoltaics, TrackingPanelsHaveTheAngleOfTheTracker) {
    const std::string rows =
        "pitch=3.048, height=4, width=1.5, offset=1.524, transmittance=0.2, ";
    const Settings day{
        "day=[{date=2025-08-07, start=09:00:00, "
        "end=17:00:00, step_minutes=240}]",
        "spacing.row_direction=0", "light.paths=32768", "light.tolerance=0"};
    const auto with = [&](const std::string& panels) {
        Settings settings = day;
        settings.push_back("panel=[{" + rows + panels + "}]");
        return settings;
    };
    const Settings tracked = with("azimuth=90, tracks=true");
    const Campaign campaign = campaign_with(tracked);
    const LightSeries series = light_of(campaign, cases(campaign).front());
    const CanopyReport moving = light_of_field(tracked);
    ASSERT_EQ(series.steps.size(), 3u);
    std::set<double> angles;
    for (std::size_t h = 0; h < series.steps.size(); ++h) {
        const double angle =
            tracker_angle(campaign.spec.panels[0].rows, series.steps[h].sun);
        angles.insert(angle);
        const CanopyReport standing = light_of_field(with(fmt::format(
            "azimuth={}, tilt={:.9f}", angle > 0 ? 90 : 270, std::abs(angle))));
        const auto budget = [&](const CanopyReport& report) {
            return report.par().light.steps[h].budget;
        };
        expect_equal(budget(moving).leaves, budget(standing).leaves);
        expect_equal(budget(moving).soil, budget(standing).soil);
        for (const std::size_t side : {0, 1}) {
            const auto on_side = [&](const CanopyReport& report) {
                return report.par().objects[side].hours[h];
            };
            expect_equal(on_side(moving), on_side(standing));
            EXPECT_LT(on_side(moving).standard_error,
                      .02 * on_side(moving).mean + .3);
        }
    }
    EXPECT_EQ(angles.size(), 3u);
    EXPECT_LT(*angles.begin(), -20);
    EXPECT_GT(*angles.rbegin(), 20);
}

//! Paths traced backwards, and sensors, see the panels at their position of
//! each instant.
TEST(Agrivoltaics, LightIsTracedBackwardsBelowTrackingPanels) {
    const Settings tracked{
        "day=[{date=2025-08-07, start=09:00:00, end=17:00:00, "
        "step_minutes=240}]",
        "spacing.row_direction=0",
        "spacing.plant=0.762",
        "light.tolerance=0",
        "objective.maximise=gross_assimilation",
        "panel=[{pitch=3.048, height=4, width=1.5, azimuth=90, "
        "tracks=true}]"};
    const Campaign campaign = campaign_with(tracked);
    const Case chosen = cases(campaign).front();
    const Device device(Device::supported_isas().back());
    CanopyRequest request =
        request_of(sampling_of(Task{}, campaign, chosen), campaign, chosen,
                   scene_of(campaign, chosen), {campaign.crop.baseline});
    request.details.exact = true;
    request.accuracy = {1024, 16};
    const CanopyReport exact = evaluate(request, device);
    const CanopyReport pieces = light_of_field(tracked);
    ASSERT_EQ(exact.assimilation->gross.hours.size(), 3u);
    for (std::size_t h = 0; h < 3; ++h) {
        const Estimate &a = exact.assimilation->gross.hours[h],
                       &b = pieces.assimilation->gross.hours[h];
        EXPECT_NEAR(
            a.mean, b.mean,
            .005 * b.mean + 4 * std::hypot(a.standard_error, b.standard_error))
            << h;
        EXPECT_LT(a.standard_error, .01 * a.mean) << h;
    }
    // Averaged over all positions, sensors just above the ground measure the
    // light on the ground.
    const Sensor level{1e-3, std::numeric_limits<double>::quiet_NaN()};
    const auto quantity =
        light_on_sensors(request, device, std::span(&level, 1), 512);
    for (std::size_t h = 0; h < 3; ++h) {
        const StepReport& step = pieces.par().light.steps[h];
        const double factor = .9 * step.budget.incident;
        expect_equal(scaled(step.budget.soil, 1 / factor), quantity[0][h]);
        EXPECT_LT(quantity[0][h].standard_error, .05 * quantity[0][h].mean)
            << h;
    }
}

TEST(Agrivoltaics, GapsBetweenModulesLetLightThrough) {
    const CanopyReport whole = light_of_field({panel});
    const CanopyReport gaps =
        light_of_field({panel.substr(0, panel.size() - 2) +
                        ", module_length=0.2, gap=0.1048}]"});
    EXPECT_NEAR(gaps.objects[0].area_index / whole.objects[0].area_index,
                .2 / .3048, 1e-9);
    EXPECT_GT(gaps.par().light.day.plants.mean,
              1.1 * whole.par().light.day.plants.mean);
}

TEST(Agrivoltaics, ObjectsAreKeptInTheResolvedCampaign) {
    const Folder folder;
    const std::string obj = folder / "post.obj";
    std::ofstream(obj) << "v 0 0 0\nv .2 0 0\nv .2 0 3\nv 0 0 3\nf 1 2 3 4\n";
    const Campaign campaign =
        campaign_with({"object=[{name=\"post\", obj=\"" + obj +
                       "\", x=0.1, y=0.2, turn=90, transmittance=0.1}]"});
    std::filesystem::remove(obj);
    const Campaign again = parse_campaign(campaign.resolved, "again");
    EXPECT_EQ(again.resolved, campaign.resolved);
    for (const Campaign* checked : {&campaign, &again}) {
        const Scene scene = scene_of(*checked, cases(*checked).front());
        ASSERT_EQ(scene.objects.size(), 1u);
        const Mesh& mesh = scene.objects[0].mesh;
        ASSERT_EQ(mesh.vertices.size(), 4u);
        // Seen from above the rotation is clockwise: the axis x becomes -y.
        EXPECT_NEAR(mesh.vertices[2].x, .1, 1e-12);
        EXPECT_NEAR(mesh.vertices[2].y, 0, 1e-12);
        EXPECT_NEAR(mesh.vertices[2].z, 3, 1e-12);
        const Material& material =
            scene.bands[0].optics.of(mesh.groups[0].material);
        EXPECT_EQ(material.adaxial.reflectance, .4);
        EXPECT_EQ(material.abaxial.transmittance, .1);
    }
}

TEST(Agrivoltaics, ThePitchOfPanelsMayEqualTheWidthOfTheField) {
    std::string panel_text = panel;
    panel_text.erase(panel_text.find("pitch=3.048, "), 13);
    for (const std::string direction : {"90", "0"}) {
        // The field is 0.6096 m wide across the rows of plants.
        const Settings settings{
            panel_text, "spacing.row_direction=" + direction,
            direction == "0" ? "field.plants=20" : "field.plants=4"};
        const Campaign campaign = campaign_with(settings);
        const Scene scene = scene_of(campaign, cases(campaign).front());
        EXPECT_EQ(scene.objects[0].mesh.faces.size(), 1u);
    }
    EXPECT_THAT(error_of({panel_text, "spacing.row_direction=0"}),
                HasSubstr("panel.width is 1.5 (rows are 0.6096 m apart"));
}

TEST(Agrivoltaics, PanelHeightAndPitchMayBeOptimisedWithThePlant) {
    std::string panel_text = panel;
    panel_text.erase(panel_text.find("pitch=3.048, "), 13);
    const Campaign campaign =
        campaign_with({panel_text,
                       "search.keys=[{key=\"panel.height\", range=[3, 5]}, "
                       "{key=\"spacing.row\", range=[0.5, 1]}]"});
    const Case chosen = cases(campaign).front();
    const GeneSpace genes = search_genes(campaign, chosen);
    ASSERT_EQ(genes.size(), gene_space(campaign, chosen).size() + 2);
    EXPECT_EQ(genes.back().name, "spacing.row");
    EXPECT_TRUE(genes.back().is_free);
    Genome genome = baseline_numbers(campaign.crop);
    const std::size_t plant = genome.size();
    genome.insert(genome.end(), {3.5, .9});
    const Campaign varied = at_keys(campaign, genome);
    EXPECT_EQ(genome.size(), plant);
    const Scene scene = scene_of(varied, cases(varied).front());
    EXPECT_NEAR(scene.cell.period_x, 3.6, 1e-12);
    ASSERT_EQ(scene.objects[0].mesh.faces.size(), 1u);
    EXPECT_NEAR(face_areas(scene.objects[0].mesh)[0], 1.5 * .6096, 1e-9);
    double height = 0;
    for (const glm::dvec3& v : scene.objects[0].mesh.vertices)
        height += v.z / 4;
    EXPECT_NEAR(height, 3.5, 1e-12);
    // A search that starts at a given plant also starts at the campaign's
    // values of varied keys.
    const std::vector<double> start =
        campaign_with(
            {panel_text, "search.optimizer=cma_es",
             "search.keys=[{key=\"panel.height\", range=[3, 5]}]",
             fmt::format("search.start=[{}]",
                         fmt::join(baseline_numbers(campaign.crop), ", "))})
            .search.start;
    ASSERT_EQ(start.size(), plant + 1);
    EXPECT_EQ(start.back(), 4);
    EXPECT_THAT(error_of({panel_text,
                          "search.keys=[{key=\"panel.height\", "
                          "range=[0.1, 5]}]"}),
                HasSubstr("search.keys: if panel.height is 0.1"));
}

TEST(Agrivoltaics, ASettingRemovesPanels) {
    EXPECT_TRUE(campaign_with({panel, "panel=[]"}).spec.panels.empty());
    EXPECT_EQ(campaign_with({panel, "panel=[]"}).resolved,
              campaign_with({}).resolved);
}

TEST(Agrivoltaics, PanelsThatDoNotRepeatWithTheFieldAreReported) {
    EXPECT_THAT(
        error_of({"panel=[{pitch=6.096, height=4, width=2, azimuth=180}]"}),
        HasSubstr("6.096 m does not go into the cell of field.rows 4 x "
                  "spacing.row 0.762 m = 3.048 m a whole number of times); use "
                  "field.rows = 8"));
    EXPECT_THAT(error_of({"panel=[{pitch=6, height=4, width=2, azimuth=180}]"}),
                HasSubstr("use field.rows = 8 with pitch = 6.096"));
    EXPECT_THAT(
        error_of({"panel=[{pitch=3.048, height=4, width=2, azimuth=120}]"}),
        HasSubstr("panel.azimuth is 120 (rows of plants run towards 90 deg, "
                  "so that no cell repeats both); use 90"));
    EXPECT_THAT(error_of({panel.substr(0, panel.size() - 2) +
                          ", module_length=1, gap=0.05}]"}),
                HasSubstr("use field.plants = 7 with gap = 0.0668"));
    EXPECT_THAT(error_of({"objective.maximise=panel_light"}),
                HasSubstr("add [[panel]]"));
    EXPECT_THAT(error_of({"object=[{name=\"post\"}]"}),
                HasSubstr("give a file: obj ="));
}

}  // namespace
}  // namespace ideotype
