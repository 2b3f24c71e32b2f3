// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "ideotype/canopy/canopy.hpp"
#include "ideotype/canopy/sensors.hpp"
#include "ideotype/core/error.hpp"
#include "two_leaves.hpp"

namespace ideotype {
namespace {

class Sensors : public ::testing::Test {
  protected:
    const Device device{Device::supported_isas().back()};
    CanopyRequest request = two_leaves({4096, 16});
};

double day_mean(const std::vector<Estimate>& sensor, const LightSeries& light) {
    double sum = 0;
    for (std::size_t i = 0; i < sensor.size(); ++i) {
        const auto [beam, diffuse] = light.steps[i].par;
        sum += sensor[i].mean * (beam + diffuse) * light.steps[i].seconds;
    }
    return sum / (light.incident() * light.days);
}

TEST_F(Sensors, AboveThePlantsReceiveAllLight) {
    const auto found =
        light_on_sensors(request, device, std::vector<Sensor>{{3, 0}}, 64);
    for (const Estimate& each : found[0]) {
        EXPECT_NEAR(each.mean, 1, 4 * each.standard_error + 1e-9);
        EXPECT_LT(each.standard_error, 0.05);
    }
}

//! Sensors on the ground, averaged over a row distance, receive the light that
//! reaches the soil.
TEST_F(Sensors, OnTheSoilAverageToTheLightThatReachesIt) {
    const double row = request.scene.cell.row_distance;
    std::vector<Sensor> sensors;
    for (int i = 0; i < 10; ++i) sensors.push_back({0, (i + .5) / 10 * row});
    request.accuracy.fields = request.accuracy.randomisations;
    const auto found = light_on_sensors(request, device, sensors, 64);
    double mean = 0;
    for (const auto& sensor : found)
        mean += day_mean(sensor, request.scene.bands[0].light.series) / 10;
    const CanopyReport report = evaluate(request, device);
    const double soil = report.par().light.day.soil.mean /
                        (1 - request.scene.bands[0].optics.soil_albedo) /
                        report.par().light.day.incident;
    EXPECT_NEAR(mean, soil, .01);
}

TEST_F(Sensors, NeedSeveralFields) {
    request.accuracy.randomisations = 1;
    EXPECT_THROW(
        light_on_sensors(request, device, std::vector<Sensor>{{0, 0}}, 1),
        Error);
}

}  // namespace
}  // namespace ideotype
