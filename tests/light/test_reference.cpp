// Exact and independently computed values. A comparison passes within four
// combined standard errors, ours being bounded as well.
#include <cmath>
#include <cstdio>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "ideotype/core/error.hpp"
#include "reference.hpp"

namespace ideotype {
namespace {

constexpr double bound = 3e-4;

//! The light of a reference case name such as "maize1/par05/sun60_az180".
Illumination light_of(const std::string& name) {
    const std::string light = name.substr(name.rfind('/') + 1);
    double elevation = 0, azimuth = 0;
    if (std::sscanf(light.c_str(), "sun%lf_az%lf", &elevation, &azimuth) == 2)
        return sun_from(elevation, azimuth);
    if (light == "uoc") return uniform_sky();
    if (light == "soc") return overcast_sky();
    throw Error("no light is called " + light);
}

void compare_with_file(const std::string& file, Period period,
                       std::size_t expected_cases) {
    std::ifstream stream(std::string(IDEOTYPE_TEST_DATA) + "/reference/" +
                         file + ".json");
    const auto cases = nlohmann::json::parse(stream).at("cases");
    for (const auto& [name, expected] : cases.items()) {
        const bool is_black = name.find("/black/") != std::string::npos;
        const Mesh mesh = load_reference_mesh(name.substr(0, name.find('/')));
        const Fractions ours =
            trace(mesh, period,
                  leaf_optics(is_black ? 0 : .05, is_black ? 0 : .05, 0),
                  light_of(name), {65536, 32});
        const double error = expected.at("standard_error");
        expect_agreement(ours.leaves, {expected.at("leaf_absorbed"), error},
                         bound, name + " leaves");
        expect_agreement(ours.soil, {expected.at("soil"), error}, bound,
                         name + " soil");
        expect_agreement(ours.reflected, {expected.at("reflected"), error},
                         bound, name + " reflected");
        if (!expected.contains("by_group")) continue;
        for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
            const std::string group = mesh.groups[g].name;
            const auto& value =
                expected.at("by_group").at(group.substr(group.find("leaf")));
            expect_agreement(ours.groups[g], {value[0], value[1]}, 2 * bound,
                             name + " " + group);
        }
    }
    EXPECT_EQ(cases.size(), expected_cases);
}

TEST(Reference, MaizeRowsAgreeWithADoublePrecisionTracer) {
    compare_with_file("maize1", {0.76, 0.15}, 12);
}

TEST(Reference, RandomLeavesAgreeWithADoublePrecisionTracer) {
    compare_with_file("poisson", {1, 1}, 10);
}

TEST(Reference, BlackSphericalLeavesFollowBeersLaw) {
    const Mesh mesh = load_reference_mesh("poisson_spherical_L3");
    const Optics black = leaf_optics(0, 0, 0);
    const auto expect_intercepted = [&](const std::string& name,
                                        const Illumination& light,
                                        double expected) {
        const Estimate leaves =
            trace(mesh, {1, 1}, black, light, {65536, 16}).leaves;
        EXPECT_LT(leaves.standard_error, bound);
        EXPECT_NEAR(leaves.mean / expected, 1, 0.004) << name;
        std::printf("%-12s %.5f +- %.5f  Beer's law %.5f  (%+.2f %%)\n",
                    name.c_str(), leaves.mean, leaves.standard_error, expected,
                    100 * (leaves.mean / expected - 1));
    };
    // 1 - exp(-0.5 LAI / cos z), and its means over two skies.
    expect_intercepted("zenith 0", sun_from(90, 180), .77687);
    expect_intercepted("zenith 30", sun_from(60, 180), .82308);
    expect_intercepted("zenith 60", sun_from(30, 180), .95021);
    expect_intercepted("uniform sky", uniform_sky(), .88652);
    expect_intercepted("overcast sky", overcast_sky(), .87250);
}

TEST(Reference, HorizontalLeavesFollowTheTwoStreamSolution) {
    const Mesh mesh = load_reference_mesh("poisson_horizontal_L3");
    struct Case {
        double rho, soil, absorbed, reflected, to_soil;
    };
    // A finite sample of leaves is within .003 of the theory.
    for (const Case& c : {Case{.05, 0, .915722, .026245, .058033},
                          {.42, 0, .353665, .396296, .250039},
                          {.42, .2, .372874, .409876, .217250}}) {
        const Fractions f =
            trace(mesh, {1, 1}, leaf_optics(c.rho, c.rho, c.soil),
                  uniform_sky(), {65536, 24});
        EXPECT_NEAR(f.leaves.mean, c.absorbed, .003);
        EXPECT_NEAR(f.reflected.mean, c.reflected, .003);
        EXPECT_NEAR(f.soil.mean, c.to_soil, .003);
        EXPECT_LT(f.leaves.standard_error, bound);
    }
}

TEST(Reference, OneSheetOverSoilIsExact) {
    const Fractions f =
        trace(load_reference_mesh("sheets1"), {1, 1}, leaf_optics(.05, .05, .2),
              sun_from(50, 30), {16384, 32});
    expect_agreement(f.leaves, {.9090909, 0}, bound, "leaf");
    expect_agreement(f.soil, {.0404040, 0}, bound, "soil");
    expect_agreement(f.reflected, {.0505051, 0}, bound, "reflected");
}

TEST(Reference, FiveSheetsOverSoilAreExact) {
    const Mesh mesh = load_reference_mesh("sheets5");
    const Fractions f = trace(mesh, {1, 1}, leaf_optics(.45, .45, .3),
                              uniform_sky(), {65536, 32});
    const double expected[] = {.13878, .08617, .05271, .03097, .01611};
    // The published digits are good to half a unit of the fifth place.
    ASSERT_EQ(f.groups.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i)
        expect_agreement(f.groups[i], {expected[i], 2.9e-6}, bound,
                         mesh.groups[i].name);
    expect_agreement(f.soil, {.05076, 2.9e-6}, bound, "soil");
    expect_agreement(f.reflected, {.62450, 2.9e-6}, bound, "reflected");
}

TEST(Reference, InTheFurnaceAllLightComesBack) {
    // Nothing absorbs: whatever the canopy, all light leaves again.
    const Mesh mesh = load_reference_mesh("maize1");
    const Fractions f = trace(mesh, {0.76, 0.15}, leaf_optics(.5, .5, 1),
                              uniform_sky(), {1024, 8});
    EXPECT_NEAR(f.reflected.mean, 1, 1e-12);
    EXPECT_EQ(f.leaves.mean, 0);
    EXPECT_EQ(f.soil.mean, 0);
}

TEST(Reference, InTheFurnaceIrradianceIsOneOnBothFacesOfEverything) {
    // Around a little absorption the light stays uniform to first order, so
    // that every surface absorbs absorptance times both its faces' area.
    const double absorptance = 1e-4;
    const Mesh mesh = load_reference_mesh("maize1");
    const Fractions f =
        trace(mesh, {0.76, 0.15},
              leaf_optics(.5 - absorptance / 2, .5 - absorptance / 2, 1),
              uniform_sky(), {4096, 16});
    const auto areas = face_areas(mesh);
    std::vector<double> area(mesh.groups.size());
    for (std::size_t i = 0; i < areas.size(); ++i)
        area[mesh.face_group[i]] += areas[i];
    for (std::size_t g = 0; g < area.size(); ++g) {
        const double expected = 2 * absorptance * area[g] / (0.76 * 0.15);
        EXPECT_LT(f.groups[g].standard_error, 0.015 * expected);
        // The first-order depletion is at most absorptance x 2 LAI.
        EXPECT_NEAR(f.groups[g].mean / expected, 1,
                    4 * f.groups[g].standard_error / expected + 3e-3)
            << mesh.groups[g].name;
    }
}

}  // namespace
}  // namespace ideotype
