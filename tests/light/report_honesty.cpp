// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "extremes.hpp"
#include "light_report.hpp"

namespace ideotype {

namespace {

constexpr std::uint32_t runs = 1000;

//! Accuracies with many randomisations of few points, and with few
//! randomisations of many points.
constexpr Accuracy accuracies[] = {{256, 32}, {2048, 8}};

using Figure = std::function<double(const Tally&)>;

double total(const Tally& tally) {
    double sum = 0;
    for (const Budget& budget : tally.sources) sum += budget.leaves;
    return sum;
}

//! Returns the spread of the estimates of a quantity divided by the root of
//! their mean squared standard error.
Estimate ratio(const std::vector<std::vector<Tally>>& all,
               const Figure& figure) {
    std::vector<double> means, variances;
    for (const auto& tallies : all) {
        std::vector<double> replicates;
        for (const Tally& tally : tallies) replicates.push_back(figure(tally));
        const Estimate e = estimate(replicates);
        means.push_back(e.mean);
        variances.push_back(e.standard_error * e.standard_error);
    }
    const double centre = estimate(means).mean;
    std::vector<double> squares;
    for (const double mean : means)
        squares.push_back((mean - centre) * (mean - centre) * runs /
                          (runs - 1));
    const Estimate spread = estimate(squares), reported = estimate(variances);
    const double value = std::sqrt(spread.mean / reported.mean);
    return {value, value / 2 *
                       std::hypot(spread.standard_error / spread.mean,
                                  reported.standard_error / reported.mean)};
}

}  // namespace

void report_honesty() {
    const Mesh mesh = load_reference_mesh("maize1");
    const RayScene scene(widest_device(), mesh, own_cell.x, own_cell.y);
    Illumination day = uniform_sky();
    for (const double elevation : {10., 40., 65.})
        day.sources.push_back(sun_from(elevation, 100).sources[0]);
    std::vector<std::vector<std::vector<Tally>>> all;
    for (const Accuracy& accuracy : accuracies) {
        all.emplace_back();
        for (std::uint32_t run = 0; run < runs; ++run)
            all.back().push_back(simulate(scene, mesh.groups, par, day,
                                          accuracy, {5000 + run, 0, 0}));
    }
    fmt::print(
        "\n## Standard errors\n\nAre reported standard errors right? The table "
        "has the spread of {} independent runs (maize1, a uniform sky and\n"
        "suns at 10, 40, 65 deg) over the reported s.e.; 1 is right. In "
        "brackets: the part of first hits by depth buffers.\n\n"
        "| quantity |",
        runs);
    for (std::size_t a = 0; a < all.size(); ++a)
        fmt::print(
            " {} x {} paths ({:.2f}) |", accuracies[a].randomisations,
            accuracies[a].paths,
            1 - static_cast<double>(all[a][0][0].rays) / accuracies[a].paths);
    fmt::print("\n|---|---|---|\n");
    for (const auto& [name, figure] :
         {std::pair<std::string, Figure>{"all leaves", total},
          {"leaf 6", [](const Tally& t) { return t.groups[5]; }},
          {"leaves under the sun at 40 deg",
           [](const Tally& t) { return t.sources[2].leaves; }},
          {"soil", [](const Tally& t) {
               double sum = 0;
               for (const Budget& budget : t.sources) sum += budget.soil;
               return sum;
           }}}) {
        fmt::print("| {} |", name);
        for (const auto& of_runs : all) {
            const Estimate r = ratio(of_runs, figure);
            fmt::print(" {:.3f} ± {:.3f} |", r.mean, 1.96 * r.standard_error);
        }
        fmt::print("\n");
    }
}

}  // namespace ideotype
