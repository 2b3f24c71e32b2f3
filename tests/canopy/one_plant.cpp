// SPDX-License-Identifier: Apache-2.0
// Evaluates plants of two leaves on a clear day; links only the canopy library.
#include <cstdio>

#include "ideotype/canopy/canopy.hpp"
#include "ideotype/light/device.hpp"
#include "two_leaves.hpp"

int main() {
    using namespace ideotype;
    const Device device(Device::supported_isas().back());
    const CanopyReport report = evaluate(two_leaves({1024, 8}), device);
    const Estimate& leaves = report.par().light.day.leaves;
    std::printf("%.3f +- %.3f MJ m-2 day-1, LAI %.2f\n", leaves.mean / 1e6,
                leaves.standard_error / 1e6, report.lai);
    return leaves.mean > 0 && leaves.standard_error < .05 * leaves.mean ? 0 : 1;
}
