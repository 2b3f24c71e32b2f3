// SPDX-License-Identifier: Apache-2.0
// The installed library in C++: the light absorbed by a mesh.
//
// A square leaf of 1 m2 is placed at increasing height over each 4 m2 of
// ground, on a clear day. The leaf absorbs 90 % of the incident light, and some
// of the light that the soil reflects. It absorbs more of it at greater height,
// where it shades the visible soil less. This example uses Scene, illuminate()
// and evaluate().
#include <cstdio>

#include <ideotype/canopy/canopy.hpp>
#include <ideotype/light/device.hpp>

using namespace ideotype;

namespace {

Estimate absorbed_at(double height, const Device& device) {
    const Mesh leaf{
        {{0, 0, height}, {1, 0, height}, {1, 1, height}, {0, 1, height}},
        {{0, 1, 2, 3}},
        {0},
        {{"leaf"}}};
    Scene ames;
    ames.components = {{.name = "leaf", .mesh = leaf}};
    ames.cell = {Boundary::periodic, 2, 2, 4};
    ames.bands = {{"par",
                   illuminate(clear_days({"Ames", 42, -93.6, -5},
                                         {{{2025, 8, 7}}, 7, 20, 60}, .45),
                              SkyModel::uniform, 90),
                   {{{.05, .05}}, .3}}};
    const BudgetEstimate day =
        evaluate({ames, {.25, 4}, {16384, 8}, {1}}, device).par().light.day;
    return scaled(day.leaves, 1 / day.incident);
}

}  // namespace

int main() {
    const Device device(Device::supported_isas().back());
    std::printf("height of the leaf [m],absorbed,standard error\n");
    bool is_right = true;
    for (const double height : {.05, .1, .2, .4, .8, 1.6}) {
        const Estimate share = absorbed_at(height, device);
        std::printf("%g,%.5f,%.5f\n", height, share.mean, share.standard_error);
        is_right = is_right && share.mean > .225 && share.mean < .3;
    }
    return is_right ? 0 : 1;
}
