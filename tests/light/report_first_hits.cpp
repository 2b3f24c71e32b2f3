// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "first_hits_referee.hpp"
#include "light_report.hpp"

namespace ideotype {

void report_first_hits() {
    fmt::print(
        "\n## First hits\n\nWhat a depth buffer sees at the points of its "
        "lattices against rays through the same\npoints, under suns at 90, 60, "
        "30, 10, 1, .1 and .01 deg from four sides. They may differ\nwhere the "
        "ray tracer's single precision puts an edge on the other side of a "
        "point, most\nof all under a low sun; all images of all faces in "
        "double "
        "precision then tell which is\nwrong.\n\n"
        "| mesh | points | differ | depth buffer wrong |\n|---|---|---|---|\n");
    for (const FirstHitsCompared& mesh : compare_first_hits(3000))
        fmt::print("| {} | {} | {} | {} |\n", mesh.name, mesh.points,
                   mesh.differ, mesh.wrong);
}

}  // namespace ideotype
