// Suns, rays, fields and paths at the limits of what can be asked for. In every
// case all figures are finite and the balance closes to rounding.
#include <chrono>
#include <limits>

#include "extremes.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/units.hpp"

namespace ideotype {
namespace {

//! A sheet over the whole period in n x n faces that share edges.
Mesh tiles(Period period, double height, int n) {
    Mesh mesh = leaves_only();
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j)
            mesh.vertices.push_back(
                {period.x * i / n, period.y * j / n, height});
    const auto at = [n](int i, int j) {
        return static_cast<std::uint32_t>(i * (n + 1) + j);
    };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            mesh.faces.push_back(
                {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
            mesh.face_group.push_back(0);
        }
    return mesh;
}

double seconds_of(const auto& work) {
    const auto began = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                         began)
        .count();
}

TEST(ExtremeSun, GrazingLightIsNearlyAllTakenByADenseStand) {
    const Mesh mesh = load_reference_mesh("maize1");
    for (const double elevation : {.01, .1, 1.})
        for (const double azimuth : {0., 37., 90., 180., 270.}) {
            const double seconds = seconds_of([&] {
                const Fractions f =
                    closing(mesh, own_cell, par, sun_from(elevation, azimuth));
                EXPECT_GT(f.leaves.mean, .85)
                    << elevation << " deg from " << azimuth;
            });
            EXPECT_LT(seconds, 10);
        }
}

TEST(ExtremeSun, AtTheZenithItsAzimuthIsOfNoMatter) {
    const Mesh mesh = load_reference_mesh("maize1");
    const double leaves =
        closing(mesh, own_cell, par, sun_from(90, 0)).leaves.mean;
    for (const double azimuth : {90., 123.})
        EXPECT_NEAR(
            closing(mesh, own_cell, par, sun_from(90, azimuth)).leaves.mean,
            leaves, 1e-3);
}

TEST(ExtremeSun, AlongALatticeAxisItIsThatOfANeighbouringDirection) {
    // The angle of 1e-6 deg must not matter, also where it keeps a ray in its
    // row of cells or takes it out.
    const Mesh mesh = load_reference_mesh("maize1");
    for (const double axis : {0., 90., 180., 270.}) {
        const auto leaves = [&](double azimuth) {
            return closing(mesh, own_cell, par, sun_from(20, azimuth),
                           {8192, 16})
                .leaves;
        };
        expect_agreement(leaves(axis), leaves(axis + 1e-6), 1e-3,
                         std::to_string(axis));
    }
}

TEST(ExtremeRays, EdgesAndVerticesOfAClosedSheetLetNothingThrough) {
    const Mesh mesh = tiles({0.76, 0.15}, 0.3, 7);
    const Scene scene(widest_device(), mesh, 0.76, 0.15);
    int through = 0, rays = 0;
    for (const double slope : {0., 1e-3, 1., 100.})
        for (int i = 0; i <= 14; ++i)
            for (int j = 0; j <= 14; ++j)
                for (const double turn : {0., 1.0, 90., 180., 271.}) {
                    const double a = turn * degree;
                    Vec3 d{slope * std::sin(a), slope * std::cos(a), -1};
                    const double length = std::hypot(slope, 1.0);
                    d = {d.x / length, d.y / length, d.z / length};
                    // Aim from a hair above, so that the ray stays in the
                    // cell.
                    const double up = 1e-4;
                    const Vec3 target{0.76 * i / 14, 0.15 * j / 14, 0.3};
                    const Vec3 from{target.x - d.x / -d.z * up,
                                    target.y - d.y / -d.z * up, 0.3 + up};
                    Hit hit;
                    ++rays;
                    through += !scene.intersect(from, d, 1, hit);
                }
    EXPECT_EQ(through, 0) << "of " << rays;
}

TEST(ExtremeRays, AClosedMirrorAboveWhiteSoilSendsAllLightBack) {
    // Light that slips through a seam could never leave again.
    const Fractions f =
        closing(tiles({0.7, 0.3}, 0.3, 6), {0.7, 0.3}, leaf_optics(1, 0, 1),
                uniform_sky(), {16384, 8});
    EXPECT_NEAR(f.reflected.mean, 1, 1e-12);
}

TEST(ExtremeFields, AHundredByAHundredPlantsAreAsGoodAsOne) {
    const Mesh plant = two_leaves(.7, .08, 40);
    const auto leaves = [&](int n, Sampling sampling) {
        const FieldForm form{n, n, {.76, .15}, 90, 0};
        const Field field = build_field(
            plant, form,
            std::vector<double>(static_cast<std::size_t>(n * n), 0.));
        return closing(field.mesh, {field.period_x, field.period_y}, par,
                       sun_from(35, 200), sampling)
            .leaves;
    };
    expect_agreement(leaves(100, {65536, 8}), leaves(1, {16384, 16}), 1e-3,
                     "100 x 100");
}

TEST(ExtremeFields, PlantsOneCentimetreApartTakeAllThatIsNotReflected) {
    const Mesh plant = two_leaves(.7, .08, 40);
    const Field field = build_field(plant, {1, 1, {.01, .01}, 90, 0}, {0});
    for (const double elevation : {90., 1., .01}) {
        const Fractions f =
            closing(field.mesh, {.01, .01}, par, sun_from(elevation, 10));
        EXPECT_GT(f.leaves.mean, .9);
        EXPECT_LT(f.soil.mean, 1e-3);
    }
}

TEST(ExtremeFields, PlantsFiftyMetresApartStandAlone) {
    // From the zenith a black plant far from all others takes its projected
    // area; so do four of them in a field of two rows.
    Mesh mesh = leaves_only();
    add_leaf(mesh, {-2, -2, .4}, {4, 0, 0}, {0, 4, 1});
    const Field field =
        build_field(mesh, {2, 2, {50, 50}, 90, 0}, {0, 0, 0, 0});
    const Fractions f = closing(field.mesh, {100, 100}, leaf_optics(0, 0, 0),
                                sun_from(90, 0), {65536, 16});
    expect_agreement(f.leaves, {16. / 2500, 0}, 5e-5, "plant");
    closing(field.mesh, {100, 100}, par, sun_from(.01, 40));
}

TEST(ExtremeFields, TenKilometresFromTheOriginNothingChanges) {
    const Mesh mesh = load_reference_mesh("maize1");
    Mesh moved = mesh;
    for (Vec3& v : moved.vertices) v = {v.x + 1e4, v.y - 1e4, v.z};
    const auto leaves = [](const Mesh& m) {
        return closing(m, own_cell, par, sun_from(3, 10), {16384, 16}).leaves;
    };
    expect_agreement(leaves(moved), leaves(mesh), 5e-4, "far away");
}

TEST(ExtremeFields, VerticesBeyondReasonAreAnError) {
    for (const double x : {9e6, 1e12, 1e30, std::numeric_limits<double>::max(),
                           std::numeric_limits<double>::infinity()}) {
        Mesh mesh = leaves_only();
        add_leaf(mesh, {0, 0, 1}, {x, 0, 0}, {0, 2, 0});
        EXPECT_THROW(Scene(widest_device(), mesh, .1, .1), Error) << x;
    }
}

TEST(ExtremeSampling, OnePathIsAnEstimate) {
    const Mesh mesh = load_reference_mesh("maize1");
    closing(mesh, own_cell, par, uniform_sky(), {1, 2});
    closing(mesh, own_cell, par, sun_from(.01, 0), {1, 2});
}

}  // namespace
}  // namespace ideotype
