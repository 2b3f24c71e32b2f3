// SPDX-License-Identifier: Apache-2.0
// Tests exact and independently computed values with fewer paths than the
// report in README.md, and all setups of the engine for some of the values.
#include <gtest/gtest.h>

#include "expectations.hpp"
#include "random_leaves.hpp"
#include "reference_cases.hpp"

namespace ideotype {

void PrintTo(const ReferenceScene& scene, std::ostream* out) {
    *out << scene.cases.front().name;
}

void PrintTo(const Setup& setup, std::ostream* out) {
    *out << setup.name;
}

namespace {

void expect_all(const SceneResult& result) {
    EXPECT_LT(result.balance_error, 1e-12);
    for (const Comparison& c : result.comparisons) {
        EXPECT_LE(std::abs(c.off()), 4)
            << c.name << " " << c.quantity << ": " << c.ours.mean << " +- "
            << c.ours.standard_error << " for " << c.reference.mean;
        EXPECT_LE(c.ours.standard_error, c.bound) << c.name;
    }
}

class Reference : public ::testing::TestWithParam<ReferenceScene> {};

TEST_P(Reference, IsMetWithinFourStandardErrors) {
    expect_all(compare(GetParam(), setups().front(), 16));
}

INSTANTIATE_TEST_SUITE_P(All, Reference,
                         ::testing::ValuesIn(reference_scenes()),
                         [](const auto& test) {
                             return test_name(test.param.cases.front().name);
                         });

class SetupReference : public ::testing::TestWithParam<Setup> {};

TEST_P(SetupReference, ChangesNoAnswer) {
    for (const ReferenceScene& scene : reference_scenes()) {
        const std::string& name = scene.cases.front().name;
        if (name == "maize1/par05/sun30_az180" || name == "maize1/par05/uoc" ||
            name == "sheets5/uoc")
            expect_all(compare(scene, GetParam(), 16));
    }
}

INSTANTIATE_TEST_SUITE_P(All, SetupReference, ::testing::ValuesIn(setups()),
                         [](const auto& test) {
                             return test_name(test.param.name);
                         });

TEST(Setups, KeepTheAreaOfLeaves) {
    const Mesh mesh = load_reference_mesh("maize1");
    EXPECT_NEAR(plant_area(cut_and_wrapped(mesh, own_cell)).leaves,
                plant_area(mesh).leaves, 1e-12);
    EXPECT_NEAR(plant_area(as_triangles(mesh)).leaves, plant_area(mesh).leaves,
                1e-12);
    for (const glm::dvec3& v : cut_and_wrapped(mesh, own_cell).vertices) {
        EXPECT_GE(v.x, -1e-12);
        EXPECT_LE(v.x, own_cell.x + 1e-12);
        EXPECT_GE(v.y, -1e-12);
        EXPECT_LE(v.y, own_cell.y + 1e-12);
    }
}

TEST(RandomLeaves, HaveTheirAreaAndTheirProjection) {
    // The projection G(0) of each distribution is the mean of |cos t|.
    for (const auto& [angles, projection] :
         {std::pair{LeafAngles::spherical, .5},
          std::pair{LeafAngles::planophile, .84883},
          std::pair{LeafAngles::erectophile, .42441},
          std::pair{LeafAngles::uniform, .63662},
          std::pair{LeafAngles::horizontal, 1.}}) {
        const Mesh mesh = random_leaves(angles, 3, 1, 5);
        EXPECT_NEAR(plant_area(mesh).leaves, 3, 1e-9);
        double shadow = 0;
        for (const auto& [a, b, c, d] : mesh.faces) {
            const glm::dvec3 &p = mesh.vertices[a], &q = mesh.vertices[c];
            const glm::dvec3 &r = mesh.vertices[b], &s = mesh.vertices[d];
            shadow += std::abs((q.x - p.x) * (s.y - r.y) -
                               (q.y - p.y) * (s.x - r.x)) /
                      2;
        }
        EXPECT_NEAR(shadow / 3, projection, 1e-4);
    }
}

}  // namespace
}  // namespace ideotype
