// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "first_hits_referee.hpp"
#include "light_report.hpp"

namespace ideotype {

void report_first_hits() {
    fmt::print(
        "\n## First hits\n\nDo depth buffers see the same faces as rays "
        "through "
        "the same points? Suns are at 90, 60, 30, 10, 1, 0.1 and\n0.01 deg "
        "from four sides. Where the two differ, by single precision at edges, "
        "all images of all faces in double\nprecision decide.\n\n"
        "| mesh | points | differ | depth buffer wrong |\n|---|---|---|---|\n");
    for (const FirstHitsCompared& mesh : compare_first_hits(3000))
        fmt::print("| {} | {} | {} | {} |\n", mesh.name, mesh.points,
                   mesh.differ, mesh.wrong);
}

}  // namespace ideotype
