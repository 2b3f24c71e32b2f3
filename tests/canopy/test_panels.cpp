// SPDX-License-Identifier: Apache-2.0
// Panels over bare ground against pvlib's infinite sheds, which are exact for
// the ground, and an exact radiosity for modules: tests/data/stands.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "ideotype/canopy/canopy.hpp"
#include "ideotype/canopy/panels.hpp"
#include "ideotype/canopy/quantities.hpp"
#include "ideotype/core/units.hpp"
#include "ideotype/light/device.hpp"

namespace ideotype {
namespace {

using Json = nlohmann::json;

constexpr int strips = 12;
constexpr double dni = 800, dhi = 120;

const Json& arrays() {
    static const Json all = [] {
        Json json;
        std::ifstream(IDEOTYPE_TEST_DATA "/stands/pvlib_infinite_sheds.json") >>
            json;
        return json;
    }();
    return all;
}

std::vector<std::string> array_names() {
    std::vector<std::string> names;
    for (const auto& [name, array] : arrays().items())
        if (array.contains("config")) names.push_back(name);
    return names;
}

PanelRows rows_of(const Json& config) {
    PanelRows rows;
    rows.pitch = config["pitch"];
    rows.height = config["height"];
    rows.width = config["width"];
    rows.tilt = config["tilt"];
    rows.azimuth = config["azimuth"];
    return rows;
}

//! Returns an object on the soil that represents the ground between two
//! positions along an axis.
FixedObject strip(int number, double from, double to, double length,
                  bool is_along_x, std::uint32_t material) {
    Mesh mesh;
    mesh.groups = {{fmt::format("strip{}", number), {}, material}};
    mesh.vertices = {
        {from, 0, 0}, {to, 0, 0}, {to, length, 0}, {from, length, 0}};
    if (!is_along_x)
        mesh.vertices = {
            {0, from, 0}, {length, from, 0}, {length, to, 0}, {0, to, 0}};
    mesh.faces = {{0, 1, 2, 3}};
    mesh.face_group = {0};
    return {mesh.groups[0].name, mesh};
}

//! Light of one instant on rows of panels over strips of ground.
//! @param turn of the cell's y axis from the rows of panels [deg]
CanopyReport panels_over_ground(const Json& config, double panel, double albedo,
                                double turn) {
    const PanelRows rows = rows_of(config);
    Scene scene;
    const double length = .5;
    const bool is_along = turn == 0;
    scene.cell.period_x = is_along ? rows.pitch : length;
    scene.cell.period_y = is_along ? length : rows.pitch;
    scene.cell.ground_area = rows.pitch * length;
    const double direction = rows.azimuth - 90 + turn;
    scene.objects.push_back(
        {"panel", panel_mesh(rows, scene.cell, direction, rows.tilt), true});
    for (int i = 0; i < strips; ++i)
        scene.objects.push_back(strip(i, i * rows.pitch / strips,
                                      (i + 1) * rows.pitch / strips, length,
                                      is_along, 1));
    const double elevation = config["el"];
    const SunPosition sun{90 - elevation, config["az"]};
    LightSeries series{
        {{12, 1, sun, {dni * std::sin(elevation * degree), dhi}}}};
    scene.bands = {{"par",
                    illuminate(series, SkyModel::uniform, direction),
                    {{Material(panel, 0), Material(albedo, 0)}, albedo}}};
    return evaluate({scene, {0, 1}, {1 << 17, 16}, {5}},
                    Device(Device::supported_isas().back()));
}

class Panels : public ::testing::TestWithParam<std::string> {};

//! @param side 0 is the front
double on_panel(const CanopyReport& report, int side) {
    return report.par().objects[static_cast<std::size_t>(side)].day.mean;
}

const Estimate& on_strip(const CanopyReport& report, int number) {
    return report.par().objects[static_cast<std::size_t>(2 + 2 * number)].day;
}

double mean_of_strips(const CanopyReport& report) {
    double sum = 0;
    for (int i = 0; i < strips; ++i) sum += on_strip(report, i).mean;
    return sum / strips;
}

TEST_P(Panels, LightOnTheGroundAgreesWithPvlibAndRadiosity) {
    const Json& array = arrays()[GetParam()];
    const CanopyReport report = panels_over_ground(array["config"], 0, .2, 0);
    EXPECT_NEAR(mean_of_strips(report) /
                    array["ground_irradiance_mean_w_m2"].get<double>(),
                1, .003);
    // Strips are numbered from the middle of a row towards the side that the
    // front faces.
    for (int i = 0; i < strips; ++i) {
        const double exact =
            array["exact_radiosity_black_panel_albedo_0.2"]["ground_profile"]
                 [static_cast<std::size_t>(i)];
        const auto& [light, error] = on_strip(report, i);
        EXPECT_NEAR(light, exact, .001 * exact + .05 + 4 * error) << i;
        EXPECT_LT(error, .012 * exact);
    }
}

TEST_P(Panels, LightOnPanelsAndGroundAgreesWithRadiosity) {
    const Json& array = arrays()[GetParam()];
    const auto check = [&](const CanopyReport& report, const Json& exact) {
        for (const int side : {0, 1}) {
            const double value = exact[side == 0 ? "front" : "back"];
            EXPECT_NEAR(on_panel(report, side), value,
                        std::max(.005 * value, .1))
                << side;
        }
        EXPECT_NEAR(mean_of_strips(report) / exact["ground_mean"].get<double>(),
                    1, .003);
    };
    check(panels_over_ground(array["config"], 0, 0, 0),
          array["exact_radiosity_black_panel_albedo_0"]);
    check(panels_over_ground(array["config"], .1, .2, 0),
          array["exact_radiosity_panel_rho_0.1_albedo_0.2"]);
}

TEST(PanelRows, AreTheSameAcrossTheRowsOfPlants) {
    const Json& config = arrays()["fixed_south_morning"]["config"];
    const CanopyReport along = panels_over_ground(config, .1, .2, 0);
    const CanopyReport across = panels_over_ground(config, .1, .2, 90);
    for (const int side : {0, 1})
        EXPECT_NEAR(on_panel(across, side), on_panel(along, side),
                    std::max(.005 * on_panel(along, side), .1));
    EXPECT_NEAR(mean_of_strips(across) / mean_of_strips(along), 1, .003);
}

TEST(PanelRows, TrackTheSunAsPvlibDoes) {
    std::ifstream table(IDEOTYPE_TEST_DATA "/stands/pvlib_tracker_angles.csv");
    std::string line;
    int compared = 0;
    while (std::getline(table, line)) {
        if (!std::isdigit(static_cast<unsigned char>(line[0]))) continue;
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream numbers(line);
        PanelRows rows;
        rows.pitch = 6;
        double coverage = 0, angle = 0;
        SunPosition sun;
        numbers >> rows.azimuth >> coverage >> rows.max_angle >>
            rows.backtracks >> sun.zenith >> sun.azimuth >> angle;
        rows.width = coverage * rows.pitch;
        EXPECT_NEAR(tracker_angle(rows, sun), angle, 1e-6) << line;
        ++compared;
    }
    EXPECT_EQ(compared, 72);
    EXPECT_EQ(tracker_angle({.azimuth = 90}, {95, 90}), 0);
}

INSTANTIATE_TEST_SUITE_P(Arrays, Panels, ::testing::ValuesIn(array_names()),
                         [](const auto& each) { return each.param; });

}  // namespace
}  // namespace ideotype
