// Evaluates a plant of two leaves on a clear day with nothing but the canopy
// library.
#include <cstdio>

#include "ideotype/canopy/canopy.hpp"

int main() {
    using namespace ideotype;
    CanopyModel model;
    model.plant.leaves = {{60, .2}, {40, .5}};
    model.plant.blade.width_controls = {.28, .89, .9, 1.15, .38, 0};
    model.field.rows = model.field.plants = 2;
    model.field.spacing = {.76, .15, 90};
    model.optics = {{.05, .05}, {.31, .12}, .1};
    model.light = illuminate(
        clear_day({"ames", 42, -93.6, -5}, {{2025, 8, 7}, 7, 20, 60}, .45),
        SkyModel::uniform, 90);
    const Device device(Device::supported_isas().back());
    const CanopyReport report =
        study(model, device, {{.7, .08, 40, 90}, {.5, .06, 30, 270}},
              {1, 0, {1024, 8}}, Detail::history);
    const Estimate& leaves = report.light.day.leaves;
    std::printf("%.3f +- %.3f MJ m-2 day-1, LAI %.2f\n", leaves.mean / 1e6,
                leaves.standard_error / 1e6, report.lai);
    return leaves.mean > 0 && leaves.standard_error < .05 * leaves.mean ? 0 : 1;
}
