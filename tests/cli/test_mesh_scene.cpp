// SPDX-License-Identifier: Apache-2.0
// Meshes of several components, materials and wavebands against an independent
// tracer and exact values, see tests/data/stands.
#include <cmath>
#include <fstream>
#include <map>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "stand/mesh_study.hpp"
#include "temporary_folder.hpp"

namespace ideotype {
namespace {

using Ordered = nlohmann::ordered_json;

Ordered stands(const std::string& name) {
    Ordered json;
    std::ifstream(fmt::format("{}/stands/{}.json", IDEOTYPE_TEST_DATA, name)) >>
        json;
    return json;
}

std::string written(const std::string& text) {
    const std::string path = temporary_file("scene.toml");
    std::ofstream(path) << text;
    return path;
}

//! Returns the scene file of a reference scene.
//! @param response rates of leaves by the prefix of their groups, or null
std::string scene_text(const Ordered& scene, const Ordered& response) {
    const Ordered& optics = scene.at("optics");
    std::string text = "soil_albedo = {";
    for (const auto& [band, albedo] : scene.at("soil_albedo").items())
        text += fmt::format(" {} = {},", band, albedo.get<double>());
    text.back() = '}';
    for (std::size_t i = 0; i < optics.front().size(); ++i) {
        text += fmt::format("\n[[material]]\ngroups = {}\n",
                            optics.front()[i][0].dump());
        for (const auto& [band, all] : optics.items())
            text +=
                fmt::format("{} = [{:.4f}, {:.4f}]\n", band,
                            all[i][1].get<double>(), all[i][2].get<double>());
    }
    for (const auto& [kind, area] : scene.at("area_index_by_kind").items()) {
        text += fmt::format("[[component]]\nname = \"{0}\"\ngroups = \"{0}\"\n",
                            kind);
        for (const auto& [prefix, leaf] : response.items())
            if (prefix.starts_with(kind))
                text += fmt::format(
                    "photosynthesis = {{ phi = {:.4f}, theta = {:.4f}, amax = "
                    "{:.4f} }}\n",
                    leaf.at("phi").get<double>(),
                    leaf.at("theta").get<double>(),
                    leaf.at("amax").get<double>());
    }
    return text;
}

MeshSpec options_of(const Ordered& scene, const std::string& light,
                    const Ordered& response = {}) {
    MeshSpec options;
    options.path = fmt::format("{}/stands/{}", IDEOTYPE_TEST_DATA,
                               scene.at("obj").get<std::string>());
    options.scene = written(scene_text(scene, response));
    options.period = {scene.at("period")[0], scene.at("period")[1]};
    double elevation = 0, azimuth = 0;
    if (std::sscanf(light.c_str(), "sun%lf_az%lf", &elevation, &azimuth) == 2)
        options.sun = {elevation, azimuth};
    else
        options.sky = SkyModel::uniform;
    options.tolerance = 5e-4;
    return options;
}

//! Expects a difference from the reference of at most four combined standard
//! errors plus a further tolerance.
void expect_within(Estimate ours, const Ordered& reference, double more,
                   const std::string& subject) {
    const double mean = reference.at(0), error = reference.at(1);
    EXPECT_NEAR(ours.mean, mean,
                4 * std::hypot(ours.standard_error, error) + more)
        << subject;
}

TEST(MeshScene, HasTheLightOfEveryReferenceInEveryBand) {
    const Ordered stand_reports = stands("light");
    std::map<std::string, CanopyReport>
        reports;  // one evaluation for both bands
    int values = 0;
    for (const auto& [name, expected] : stand_reports.at("cases").items()) {
        const std::string scene = name.substr(0, name.find('/'));
        const std::string light = name.substr(name.rfind('/') + 1);
        const std::string band = name.substr(
            scene.size() + 1, name.size() - scene.size() - light.size() - 2);
        const auto [at, is_new] = reports.try_emplace(scene + light);
        if (is_new)
            at->second =
                study(options_of(stand_reports.at("scenes").at(scene), light))
                    .canopy;
        const CanopyReport& report = at->second;
        for (const BandReport& band_report : report.bands) {
            if (band_report.name != band) continue;
            const auto expect = [&, where = name](Estimate ours,
                                                  const Ordered& reference,
                                                  const std::string& subject) {
                expect_within(ours, reference, 1e-4, where + ' ' + subject);
                ++values;
            };
            expect(band_report.light.day.soil, expected.at("soil"), "soil");
            expect(band_report.light.day.reflected, expected.at("reflected"),
                   "reflected");
            for (std::size_t c = 0; c < report.components.size(); ++c) {
                const std::string& kind = report.components[c].name;
                expect(band_report.part(c).all, expected.at("by_kind").at(kind),
                       kind);
            }
            for (std::size_t g = 0; g < report.groups.size(); ++g)
                if (const auto reference =
                        expected.at("by_group").find(report.groups[g].name);
                    reference != expected.at("by_group").end())
                    expect(band_report.light.groups[g], *reference,
                           report.groups[g].name);
        }
    }
    EXPECT_GT(values, 350);
}

TEST(MeshScene, AssimilatesWithTheParametersOfEachComponent) {
    const Ordered scenes = stands("light").at("scenes");
    const Ordered cases = stands("assimilation").at("cases");
    ASSERT_EQ(cases.size(), 9u);
    for (const auto& [name, expected] : cases.items()) {
        const std::string scene = name.substr(0, name.find('/'));
        MeshSpec options =
            options_of(scenes.at(scene), name.substr(name.find('/') + 1),
                       expected.at("response"));
        if (options.sun) {
            options.beam_ppfd = expected.at("beam_ppfd").get<double>();
            options.sky = SkyModel::uniform;
        }
        options.sky_ppfd = expected.at("sky_ppfd").get<double>();
        const CanopyReport report = study(options).canopy;
        const auto components = by_component(
            *report.assimilation, report.groups, report.components.size());
        for (std::size_t c = 0; c < components.size(); ++c) {
            const Ordered& gross = expected.at("by_kind")
                                       .at(report.components[c].name)
                                       .at("A_gross");
            expect_within(scaled(components[c].gross, 1e6), gross,
                          1e-3 * gross[0].get<double>(), name);
        }
    }
}

//! The sun illuminates the upper face; the light reflected by the soil
//! illuminates the lower face.
TEST(MeshScene, FacesOfASheetMayReflectDifferently) {
    MeshSpec options;
    options.path = std::string(IDEOTYPE_MESHES) + "/sheets1.obj";
    options.period = {1, 1};
    options.sun = {60, 100};
    options.tolerance = 2e-4;
    options.scene = written(
        "soil_albedo = 0.5\n[[material]]\ngroups = \"\"\n"
        "par = [0.1, 0.6, 0.2]\n");
    const BudgetEstimate day = study(options).canopy.par().light.day;
    // Light is reflected back and forth between the soil and the lower face.
    const double onto_soil = .2 / (1 - .5 * .6);
    const double leaf = .7 + .5 * onto_soil * .2;
    EXPECT_NEAR(day.leaves.mean, leaf, 4 * day.leaves.standard_error + 1e-9);
    EXPECT_NEAR(day.soil.mean, .5 * onto_soil,
                4 * day.soil.standard_error + 1e-9);
    EXPECT_NEAR(day.reflected.mean, .1 + .5 * onto_soil * .2,
                4 * day.reflected.standard_error + 1e-9);
    EXPECT_LT(day.leaves.standard_error, 1e-3);
}

TEST(MeshScene, FacesWithDifferentReflectanceAssimilateAsTheExactMethod) {
    MeshSpec options;
    options.path = fmt::format("{}/stands/sole_maize.obj", IDEOTYPE_TEST_DATA);
    options.period = {.6, .3};
    options.sun = {55, 140};
    options.sky = SkyModel::uniform;
    options.beam_ppfd = 1300;
    options.sky_ppfd = 300;
    options.scene = written(
        "soil_albedo = 0.3\n[[material]]\ngroups = \"maize\"\n"
        "par = [0.05, 0.5, 0.1]\n[[component]]\nname = \"maize\"\n"
        "photosynthesis = { amax = 50 }\n");
    options.tolerance = 1e-3;
    const Estimate pieces = study(options).canopy.assimilation->gross.sum;
    options.is_exact = true;
    options.tolerance = 4e-3;
    const Estimate exact = study(options).canopy.assimilation->gross.sum;
    EXPECT_NEAR(pieces.mean, exact.mean,
                4 * std::hypot(pieces.standard_error, exact.standard_error) +
                    2e-3 * exact.mean);
}

//! A horizontal black sheet in a beam, at 30 deg C and a vapour pressure
//! deficit of 1.697 kPa.
TEST(MeshScene, ComponentsMayBeOfC3) {
    MeshSpec options;
    options.path = std::string(IDEOTYPE_MESHES) + "/sheets1.obj";
    options.period = {1, 1};
    options.sun = {60, 100};
    options.beam_ppfd = 900;
    const auto set_leaves = [&](const std::string& keys) {
        options.scene = written(
            "[[material]]\ngroups = \"\"\npar = [0, 0]\n"
            "[[component]]\nname = \"soybean\"\ngroups = \"\"\n"
            "photosynthesis = { model = \"farquhar\", " +
            keys + " }\n");
    };
    set_leaves("vcmax = 90, jmax = 150, tpu = 10, theta = 0.9, g1 = 4, rd = 1");
    const AssimilationReport report = *study(options).canopy.assimilation;
    const FarquharLeaf leaf{90, 150, 10, .9, .98, 4, 1};
    const double ci = 400 * 4 / (4 + std::sqrt(1.69717));
    EXPECT_NEAR(1e6 * report.gross.sum.mean,
                farquhar_at(leaf, 30, ci).gross(900), 1e-3);
    EXPECT_NEAR(1e6 * sum_of(report.losses).in_light,
                dark_respiration(leaf, 30), 1e-9);
    set_leaves("vmax = 40");
    try {
        study(options);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what())
                      .find("vmax is not a parameter of the model \"farquhar\" "
                            "(but of \"collatz\"); remove it"),
                  std::string::npos)
            << error.what();
    }
}

TEST(MeshScene, NamesOfComponentsHaveNoEffect) {
    const Ordered scene = stands("light").at("scenes").at("two_maize");
    MeshSpec options = options_of(scene, "sun25_az255");
    options.tolerance = 3e-3;
    const CanopyReport report = study(options).canopy;
    std::string text = scene_text(scene, {});
    const auto replace = [&](const std::string& was, const std::string& is) {
        text.replace(text.find(was), was.size(), is);
    };
    replace("name = \"erect\"", "name = \"x\"");
    replace("name = \"flat\"", "name = \"erect\"");
    options.scene = written(text);
    const CanopyReport again = study(options).canopy;
    EXPECT_EQ(again.components[1].name, "erect");
    EXPECT_EQ(again.par().groups_by_randomisation,
              report.par().groups_by_randomisation);
}

//! Near infrared is the rest of solar radiation after PAR. The share of PAR,
//! 0.4 to 0.5, follows from the photons in the weather data by par_share().
TEST(MeshScene, AClimateHasLightInTheNearInfrared) {
    const std::string season = temporary_file("season.toml");
    std::ofstream(season) << fmt::format(
        "[site]\nlatitude = 40.05\nlongitude = -88.37\nutc_offset = -6\n"
        "[climate]\nfile = \"{}/weather/bondville_2011_0721_0920.csv\"\n"
        "from = 2011-07-21\nto = 2011-07-22\ntime = [\"time\"]\n"
        "stamp = \"middle\"\nglobal = [\"ppfd_umol\", \"umol/m2/s\"]\n"
        "diffuse_fraction = [\"diffuse_fraction_erbs\", \"1\"]\n",
        IDEOTYPE_CAMPAIGNS);
    MeshSpec options;
    options.path = std::string(IDEOTYPE_MESHES) + "/sheets1.obj";
    options.period = {1, 1};
    options.climate = season;
    options.paths = 1024;
    options.scene = written(
        "soil_albedo = { par = 0.1, nir = 0.2 }\n[[material]]\ngroups = \"\"\n"
        "par = [0, 0]\nnir = [0, 0]\n");
    const CanopyReport report = study(options).canopy;
    ASSERT_EQ(report.bands.size(), 2u);
    const double par = report.bands[0].light.day.incident;
    EXPECT_GT(par, 1e6);
    EXPECT_GT(report.bands[1].light.day.incident, .5 / .5 * par);
    EXPECT_LT(report.bands[1].light.day.incident, .6 / .4 * par);
    EXPECT_EQ(report.bands[1].name, "nir");
}

TEST(MeshScene, AMaterialNeedsAWaveband) {
    MeshSpec options;
    options.path = std::string(IDEOTYPE_MESHES) + "/sheets1.obj";
    options.period = {1, 1};
    options.sun = {60, 100};
    options.scene = written("[[material]]\ngroups = \"\"\n");
    try {
        study(options);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("add par = [0.06, 0.03]"),
                  std::string::npos)
            << error.what();
    }
}

TEST(MeshScene, AllProblemsOfAFileAreReportedInOnePass) {
    const std::string path = written(
        "albedo = 0.1\n"
        "soil_albedo = { par = 2, red = 0.1 }\n"
        "[[material]]\ngroups = \"leaf\"\npar = [0.5, 0.6]\n"
        "[[material]]\ngroups = 7\nnir = [0.5]\n"
        "[[component]]\ngroups = \"leaf\"\ncolour = \"red\"\n"
        "photosynthesis = { amaxx = 3 }\n");
    MeshSpec options;
    options.path = std::string(IDEOTYPE_MESHES) + "/sheets1.obj";
    options.period = {1, 1};
    options.sun = {60, 100};
    options.scene = path;
    try {
        study(options);
        FAIL();
    } catch (const InputError& error) {
        const std::string message = error.what();
        for (const char* part :
             {"unknown key 'albedo'", "soil_albedo.par is 2",
              "soil_albedo.red names no band", "more than 1",
              "material.groups is an integer", "has no par", "has no nir",
              "material.nir has 1 values", "missing key 'name' in [component]",
              "unknown key 'colour'", "unknown key 'amaxx'"})
            EXPECT_NE(message.find(part), std::string::npos) << part << '\n'
                                                             << message;
        EXPECT_NE(message.find(path + ":5:"), std::string::npos) << message;
    }
}

TEST(MeshScene, EveryGroupNeedsAMaterialAndAComponent) {
    MeshSpec options;
    options.path = fmt::format("{}/stands/two_maize.obj", IDEOTYPE_TEST_DATA);
    options.period = {1.52, .3};
    options.sun = {60, 100};
    options.scene = written(
        "[[material]]\ngroups = \"erect\"\n"
        "par = [0.05, 0.05]\n"
        "[[component]]\nname = \"flat\"\n");
    try {
        study(options);
        FAIL();
    } catch (const Error& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("group flat_leaf01 fits no [[material]]"),
                  std::string::npos)
            << message;
        EXPECT_NE(message.find("group erect_leaf10 fits no [[component]]"),
                  std::string::npos)
            << message;
    }
}

}  // namespace
}  // namespace ideotype
