// SPDX-License-Identifier: Apache-2.0
// Equivalent descriptions of a stand give equal light.
#include <algorithm>
#include <cmath>
#include <functional>

#include "expectations.hpp"
#include "lattice.hpp"

namespace ideotype {
namespace {

constexpr Accuracy fine{32768, 16};
const Optics nir = leaf_optics(.42, .42, .2);

Mesh moved(Mesh mesh, const std::function<glm::dvec3(const glm::dvec3&)>& to) {
    for (glm::dvec3& v : mesh.vertices) v = to(v);
    return mesh;
}

//! Expects that two descriptions of a stand give equal budgets.
void expect_same(const Fractions& a, const Fractions& b, double bound,
                 const std::string& what) {
    expect_agreement(a.leaves, b.leaves, bound, what + ": leaves");
    expect_agreement(a.soil, b.soil, bound, what + ": soil");
    expect_agreement(a.reflected, b.reflected, bound, what + ": reflected");
}

TEST(Symmetry, AnyShiftOfTheFieldIsTheSameField) {
    const Mesh mesh = load_reference_mesh("maize1");
    const auto at = [&](double x, double y) {
        return closing(moved(mesh,
                             [&](const glm::dvec3& v) {
                                 return glm::dvec3{v.x + x, v.y + y, v.z};
                             }),
                       own_cell, nir, sun_from(40, 20), fine);
    };
    const Fractions here = at(0, 0);
    expect_same(at(.38, .075), here, 8e-4, "half a period");
    expect_same(at(-.111, 3.03), here, 8e-4, "any offset");
    expect_same(at(7.6, -1.5), here, 8e-4, "ten periods");
}

TEST(Symmetry, SeveralPeriodsAreOne) {
    const Mesh mesh = load_reference_mesh("maize1");
    Mesh four = mesh;
    for (int i = 1; i < 4; ++i) {
        const auto first = static_cast<std::uint32_t>(four.vertices.size());
        for (const glm::dvec3& v : mesh.vertices)
            four.vertices.push_back({v.x, v.y + i * own_cell.y, v.z});
        for (const auto& f : mesh.faces)
            four.faces.push_back(
                {f[0] + first, f[1] + first, f[2] + first, f[3] + first});
        four.face_group.insert(four.face_group.end(), mesh.face_group.begin(),
                               mesh.face_group.end());
    }
    expect_same(closing(four, {own_cell.x, 4 * own_cell.y}, nir,
                        sun_from(25, 70), fine),
                closing(mesh, own_cell, nir, sun_from(25, 70), fine), 8e-4,
                "four plants");
}

TEST(Symmetry, LeavesCutAtTheCellAndWrappedAreTheSameLeaves) {
    // A leaf crosses the side of the cell. If it is cut there, its parts lie at
    // opposite sides of the cell.
    Mesh whole = leaves_only(), cut = leaves_only();
    add_leaf(whole, {.7, .2, .4}, {.6, 0, .3}, {0, .5, 0});
    add_leaf(cut, {.7, .2, .4}, {.3, 0, .15}, {0, .5, 0});
    add_leaf(cut, {0, .2, .55}, {.3, 0, .15}, {0, .5, 0});
    for (const double azimuth : {0., 90., 200.})
        expect_same(closing(cut, {1, 1}, nir, sun_from(25, azimuth), fine),
                    closing(whole, {1, 1}, nir, sun_from(25, azimuth), fine),
                    8e-4, std::to_string(azimuth));
}

TEST(Symmetry, TheOrderOfPlantsIsOfNoMatter) {
    const Mesh plant = two_leaves(.7, .08, 40);
    const FieldForm form{1, 3, {.76, .15}, 0};
    const auto with = [&](const std::vector<double>& turns) {
        return closing(in_lattice(plant, form, turns), {.76, .45}, nir,
                       sun_from(50, 30), fine);
    };
    // Rotating the order of the three plants is a shift along the row.
    expect_same(with({20, -8, 3}), with({-8, 3, 20}), 8e-4, "rotated");

    Mesh mesh = in_lattice(plant, form, {20, -8, 3});
    std::reverse(mesh.faces.begin(), mesh.faces.end());
    std::reverse(mesh.face_group.begin(), mesh.face_group.end());
    expect_same(closing(mesh, {.76, .45}, nir, sun_from(50, 30), fine),
                with({20, -8, 3}), 8e-4, "faces reversed");
}

TEST(Symmetry, AMirroredStandUnderAMirroredSunIsTheSame) {
    const Mesh mesh = load_reference_mesh("maize1");
    const Mesh mirrored = moved(mesh, [](const glm::dvec3& v) {
        return glm::dvec3{-v.x, v.y, v.z};
    });
    expect_same(closing(mirrored, own_cell, nir, sun_from(30, -65), fine),
                closing(mesh, own_cell, nir, sun_from(30, 65), fine), 8e-4,
                "mirrored");
}

TEST(Symmetry, AStandUpsideDownTransmitsAsMuch) {
    // Reciprocity: black soil absorbs as much light of a uniform sky as the sky
    // would receive from uniformly emitting soil. Reflection and absorption may
    // differ.
    const Mesh mesh = load_reference_mesh("maize1");
    double top = 0;
    for (const glm::dvec3& v : mesh.vertices) top = std::max(top, v.z);
    const Mesh over = moved(mesh, [&](const glm::dvec3& v) {
        return glm::dvec3{v.x, v.y, v.z < 0 ? top : top - v.z};
    });
    const Mesh upright = moved(mesh, [&](const glm::dvec3& v) {
        return glm::dvec3{v.x, v.y, std::max(0., v.z)};
    });
    const Optics leaves = leaf_optics(.3, .5, 0);
    expect_agreement(
        closing(over, own_cell, leaves, uniform_sky(), fine).soil,
        closing(upright, own_cell, leaves, uniform_sky(), fine).soil, 8e-4,
        "transmitted");
}

TEST(StandardError, IsTheSpreadOfATotalALeafRankAndAnHour) {
    const Mesh mesh = load_reference_mesh("maize1");
    const RayScene scene(widest_device(), mesh, own_cell.x, own_cell.y);
    Illumination day = uniform_sky();
    for (const double elevation : {10., 40., 65.})
        day.sources.push_back(sun_from(elevation, 100).sources[0]);
    using Figure = std::function<double(const Tally&)>;
    const std::pair<std::string, Figure> figures[] = {
        {"total",
         [](const Tally& t) {
             double sum = 0;
             for (const Budget& b : t.sources) sum += b.leaves;
             return sum;
         }},
        {"leaf rank", [](const Tally& t) { return t.groups[5]; }},
        {"hour", [](const Tally& t) { return t.sources[2].leaves; }}};

    constexpr std::uint32_t runs = 400;
    std::vector<std::vector<Tally>> all;
    for (std::uint32_t run = 0; run < runs; ++run)
        all.push_back(simulate(scene, mesh.groups, par, day, {256, 8},
                               {1000 + run, 0, 0}));
    for (const auto& [name, figure] : figures) {
        std::vector<double> means;
        double variance = 0;
        for (const auto& tallies : all) {
            std::vector<double> replicates;
            for (const Tally& tally : tallies)
                replicates.push_back(figure(tally));
            const Estimate e = estimate(replicates);
            means.push_back(e.mean);
            variance += e.standard_error * e.standard_error / runs;
        }
        const double spread = estimate(means).standard_error * std::sqrt(runs);
        const double ratio = spread / std::sqrt(variance);
        RecordProperty(name, std::to_string(ratio));
        // The relative error of the spread is 1 / sqrt(2 * 399) and that of the
        // mean standard error a third of this, 3.8 % together.
        EXPECT_NEAR(ratio, 1, 4 * .038) << name;
    }
}

}  // namespace
}  // namespace ideotype
