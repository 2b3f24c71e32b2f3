// SPDX-License-Identifier: Apache-2.0
// Plants from traits in C++: from a Plant to a field, hour by hour.
//
// A plant of two leaves becomes a periodic field of 2 x 2 plants. Erect leaves
// transmit more of the light of a high sun than level ones, most of all at
// noon. This example uses Plant, FieldForm, component_of() and reports by hour.
#include <cstdio>
#include <vector>

#include <ideotype/canopy/canopy.hpp>
#include <ideotype/canopy/field.hpp>
#include <ideotype/light/device.hpp>

using namespace ideotype;

namespace {

std::vector<StepReport> by_hour(double angle, const Device& device) {
    Plant plant;
    // Length, width, insertion angle, curvature, azimuth, insertion height.
    plant.leaves = {{.7, .08, angle, 40, 90, .2},
                    {.5, .06, angle, 40, 270, .5}};
    plant.blade.width_controls = {.28, .89, .9, 1.15, .38, 0};
    plant.stalk.height = 2;
    plant.stalk.base_diameter = .027;
    const FieldForm form{2, 2, {.76, .15, 90}};
    Scene ames;
    ames.components = {component_of(plant, form)};
    ames.cell = cell_of(form);
    ames.bands = {{"par",
                   illuminate(clear_days({"Ames", 42, -93.6, -5},
                                         {{{2025, 8, 7}}, 7, 20, 60}, .45),
                              SkyModel::uniform, form.spacing.row_direction),
                   {PlantOptics{{.05, .05}, {.31, .12}, {}}.materials(), .1}}};
    return evaluate({ames, {.25, 4}, {65536, 8}, {1}}, device)
        .par()
        .light.steps;
}

//! Returns the absorbed fraction of the incident light.
double share(const StepReport& step) {
    return step.budget.leaves.mean / step.budget.incident;
}

}  // namespace

int main() {
    const Device device(Device::supported_isas().back());
    const std::vector<StepReport> erect = by_hour(20, device);
    const std::vector<StepReport> level = by_hour(70, device);
    std::printf("clock [h],erect leaves,level leaves\n");
    for (std::size_t i = 0; i < erect.size(); ++i)
        std::printf("%g,%.4f,%.4f\n", erect[i].hour, share(erect[i]),
                    share(level[i]));
    const std::size_t noon = erect.size() / 2;
    return share(level[noon]) > share(erect[noon]) ? 0 : 1;
}
