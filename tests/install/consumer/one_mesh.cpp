// SPDX-License-Identifier: Apache-2.0
// The light in a mesh: one square leaf of 1 m2 above each 4 m2 of ground, on
// a clear day. It absorbs 90 % of what falls on it, and some of what the soil
// reflects.
#include <cstdio>

#include <ideotype/canopy/canopy.hpp>
#include <ideotype/light/device.hpp>

int main() {
    using namespace ideotype;
    const Mesh leaf{{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
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
                   {{{.05, .05}}, .1}}};
    const Device device(Device::supported_isas().back());
    const BudgetEstimate day =
        evaluate({ames, {.25, 4}, {4096, 8}, {1}}, device).par().light.day;
    const Estimate share = scaled(day.leaves, 1 / day.incident);
    std::printf("%.4f +- %.4f\n", share.mean, share.standard_error);
    return share.mean > .225 && share.mean < .25 ? 0 : 1;
}
