// SPDX-License-Identifier: Apache-2.0
#include "reference_cases.hpp"

#include <cmath>
#include <cstdio>
#include <fstream>

#include <nlohmann/json.hpp>

#include "ideotype/core/error.hpp"
#include "random_leaves.hpp"

namespace ideotype {

namespace {

using Kind = ReferenceScene::Kind;

//! Returns the standard error due to rounding to the given number of decimals.
double rounding(int decimals) {
    return std::pow(10., -decimals) / std::sqrt(12.);
}

//! Returns an exact value that was published with the given number of decimals.
KnownValue printed(const std::string& quantity, double value, int decimals) {
    return {quantity, {value, rounding(decimals)}};
}

Source sun(double elevation, double azimuth) {
    return sun_from(elevation, azimuth).sources.front();
}

Source sky(SkyModel model) {
    return {std::nullopt, 1.0, SkySampler({model, {}})};
}

//! Returns the light of a case in a file, from its name such as
//! "maize1/par05/sun60_az180".
Source light_of(const std::string& name) {
    const std::string light = name.substr(name.rfind('/') + 1);
    double elevation = 0, azimuth = 0;
    if (std::sscanf(light.c_str(), "sun%lf_az%lf", &elevation, &azimuth) == 2)
        return sun(elevation, azimuth);
    if (light == "uoc") return sky(SkyModel::uniform);
    if (light == "soc") return sky(SkyModel::overcast);
    throw Error("no light is called " + light);
}

std::function<Mesh(std::uint32_t)> mesh_of(const std::string& name) {
    return [name](std::uint32_t) { return load_reference_mesh(name); };
}

std::function<Mesh(std::uint32_t)> random_mesh(LeafAngles angles,
                                               double height) {
    return [=](std::uint32_t realisation) {
        return random_leaves(angles, 3, height, realisation);
    };
}

//! Adds the cases of a file with values of an independent tracer.
void add_file(std::vector<ReferenceScene>& scenes, const std::string& file,
              GroundPeriod period, int paths) {
    std::ifstream stream(std::string(IDEOTYPE_TEST_DATA) + "/reference/" +
                         file + ".json");
    const auto cases = nlohmann::json::parse(stream).at("cases");
    for (const auto& [name, value] : cases.items()) {
        const bool is_black = name.find("/black/") != std::string::npos;
        const double scattering = is_black ? 0 : .05;
        const auto mesh = mesh_of(name.substr(0, name.find('/')));
        const double error =
            std::hypot(value.at("standard_error").get<double>(), rounding(7));
        ReferenceCase one{name,
                          light_of(name),
                          {{"leaves", {value.at("leaf_absorbed"), error}},
                           {"soil", {value.at("soil"), error}},
                           {"reflected", {value.at("reflected"), error}}}};
        if (value.contains("by_group"))
            for (const Group& group : mesh(0).groups) {
                const auto& part =
                    value.at("by_group")
                        .at(group.name.substr(group.name.find("leaf")));
                one.known.push_back({group.name,
                                     {part[0], std::hypot(part[1].get<double>(),
                                                          rounding(6))}});
            }
        const int factor = one.light.direction ? 1 : 4;
        scenes.push_back({"independent tracer, " + file + ".json",
                          mesh,
                          Kind::fixed,
                          period,
                          leaf_optics(scattering, scattering, 0),
                          {one},
                          {factor * paths, 64}});
    }
}

//! Adds black leaves. The exact values are 1 - exp(-G LAI / cos z) and its
//! means over two skies.
void add_beers_law(std::vector<ReferenceScene>& scenes) {
    struct Row {
        LeafAngles angles;
        std::string name;
        double intercepted[6];
    };
    const Row rows[] = {{LeafAngles::spherical,
                         "spherical",
                         {.77687, .82308, .95021, .99696, .88652, .87250}},
                        {LeafAngles::planophile,
                         "planophile",
                         {.92164, .92245, .94142, .98078, .93623, .93243}},
                        {LeafAngles::erectophile,
                         "erectophile",
                         {.72008, .79063, .95276, .99789, .86979, .85240}},
                        {LeafAngles::uniform,
                         "uniform",
                         {.85190, .87258, .94740, .99363, .91218, .90307}}};
    const std::pair<std::string, Source> lights[] = {
        {"sun90", sun(90, 0)},           {"sun60", sun(60, 75)},
        {"sun30", sun(30, 200)},         {"sun15", sun(15, 310)},
        {"uoc", sky(SkyModel::uniform)}, {"soc", sky(SkyModel::overcast)}};
    for (const Row& row : rows) {
        ReferenceScene scene{"Beer's law",         random_mesh(row.angles, 1),
                             Kind::random,         unit_cell,
                             leaf_optics(0, 0, 0), {},
                             {32768, 1024}};
        for (std::size_t i = 0; i < std::size(lights); ++i)
            scene.cases.push_back(
                {"beer/" + row.name + "/" + lights[i].first,
                 lights[i].second,
                 {printed("leaves", row.intercepted[i], 5),
                  printed("soil", 1 - row.intercepted[i], 5)}});
        scenes.push_back(scene);
    }
}

//! Adds horizontal leaves, for which the two-stream equations are exact with
//! any optics.
void add_two_stream(std::vector<ReferenceScene>& scenes) {
    struct Row {
        std::string name;
        double scattering, soil_albedo;
        double leaves, reflected, soil;
        double of_size;  //!< error of the theory for leaves of 2 cm in 10 m
    };
    // Light scattered by a leaf can escape through the gap through which it
    // arrived. In the near infrared, stands of 1, 3 and 10 m therefore reflect
    // 0.0025, 0.0010 and 0.0004 more than the equations predict, in PAR a
    // quarter of these amounts.
    for (const Row& row :
         {Row{"par", .05, 0, .915722, .026245, .058033, 6e-5},
          {"nir", .42, 0, .353665, .396296, .250039, 25e-5},
          {"nir_soil", .42, .2, .372874, .409876, .217250, 25e-5}}) {
        const Optics optics =
            leaf_optics(row.scattering, row.scattering, row.soil_albedo);
        scenes.push_back({"two-stream",
                          random_mesh(LeafAngles::horizontal, 10),
                          Kind::random,
                          unit_cell,
                          optics,
                          {},
                          {32768, 256}});
        // The error due to a sample of 7,500 leaves is up to 0.003, four times
        // the standard error stated here.
        scenes.push_back({"two-stream, to 0.003",
                          mesh_of("poisson_horizontal_L3"),
                          Kind::fixed,
                          unit_cell,
                          optics,
                          {},
                          {65536, 64}});
        const auto known = [&](double error) {
            return std::vector<KnownValue>{
                {"leaves", {row.leaves, error}},
                {"soil", {row.soil, error}},
                {"reflected", {row.reflected, error}}};
        };
        ReferenceScene& many = scenes[scenes.size() - 2];
        for (const auto& [name, light] :
             {std::pair{"/sun45", sun(45, 30)},
              std::pair{"/uoc", sky(SkyModel::uniform)}})
            many.cases.push_back(
                {"two_stream/" + row.name + name, light, known(row.of_size)});
        scenes.back().cases.push_back(
            {"poisson_horizontal_L3/" + row.name + "/uoc",
             sky(SkyModel::uniform), known(.003 / 4)});
    }
}

//! Adds spherical leaf angles in a turbid medium; the reference is a Monte
//! Carlo solution.
void add_turbid(std::vector<ReferenceScene>& scenes) {
    const auto known = [](double leaves, double reflected, double soil) {
        const double error = std::hypot(2e-4, rounding(4));
        return std::vector<KnownValue>{{"leaves", {leaves, error}},
                                       {"soil", {soil, error}},
                                       {"reflected", {reflected, error}}};
    };
    scenes.push_back(
        {"turbid medium",
         random_mesh(LeafAngles::spherical, 10),
         Kind::random,
         unit_cell,
         leaf_optics(.05, .05, 0),
         {{"turbid/sun90", sun(90, 0), known(.7499, .0167, .2334)},
          {"turbid/sun30", sun(30, 20), known(.9184, .0236, .0580)},
          {"turbid/uoc", sky(SkyModel::uniform), known(.8561, .0216, .1223)}},
         {32768, 512}});
}

void add_sheets(std::vector<ReferenceScene>& scenes) {
    // The soil reflects half of the light that the sheet transmits back to the
    // sheet, and so on.
    const std::vector<KnownValue> one{{"leaves", {1 / 1.1, 0}},
                                      {"soil", {.04 / .99, 0}},
                                      {"reflected", {.05 / .99, 0}}};
    scenes.push_back({"exact",
                      mesh_of("sheets1"),
                      Kind::fixed,
                      unit_cell,
                      leaf_optics(.05, .05, .2),
                      {{"sheets1/sun50", sun(50, 30), one},
                       {"sheets1/uoc", sky(SkyModel::uniform), one}},
                      {32768, 64}});
    scenes.push_back(
        {"exact",
         mesh_of("sheets5"),
         Kind::fixed,
         unit_cell,
         leaf_optics(.45, .45, .3),
         {{"sheets5/uoc",
           sky(SkyModel::uniform),
           {printed("layer0", .13878, 5), printed("layer1", .08617, 5),
            printed("layer2", .05271, 5), printed("layer3", .03097, 5),
            printed("layer4", .01611, 5), printed("soil", .05076, 5),
            printed("reflected", .62450, 5)}}},
         {65536, 64}});
}

//! Adds a furnace: if no surface absorbs, the irradiance is 1 on all faces.
void add_furnace(std::vector<ReferenceScene>& scenes) {
    const GroundPeriod period{.76, .15};
    const auto mesh = mesh_of("maize1");
    scenes.push_back(
        {"exact",
         mesh,
         Kind::fixed,
         period,
         leaf_optics(.5, .5, 1),
         {{"furnace/white",
           sky(SkyModel::uniform),
           {{"leaves", {0, 0}}, {"soil", {0, 0}}, {"reflected", {1, 0}}}}},
         {1024, 64}});
    // A small absorptance makes the irradiance measurable. It reduces the light
    // by at most twice the leaf area times the absorptance, here 7e-4.
    const double absorptance = 1e-4;
    ReferenceCase grey{"furnace/grey", sky(SkyModel::uniform), {}};
    const Mesh maize = mesh(0);
    const auto areas = face_areas(maize);
    for (std::uint32_t g = 0; g < maize.groups.size(); ++g) {
        double area = 0;
        for (std::size_t f = 0; f < areas.size(); ++f)
            if (maize.face_group[f] == g) area += areas[f];
        const double absorbed = 2 * absorptance * area / (period.x * period.y);
        grey.known.push_back(
            {maize.groups[g].name, {absorbed, 7e-4 * absorbed}});
    }
    const double scattering = (1 - absorptance) / 2;
    scenes.push_back({"exact to 7e-4",
                      mesh,
                      Kind::fixed,
                      period,
                      leaf_optics(scattering, scattering, 1),
                      {grey},
                      {4096, 64},
                      1e-6});
}

}  // namespace

std::vector<ReferenceScene> reference_scenes() {
    std::vector<ReferenceScene> scenes;
    add_file(scenes, "maize1", {.76, .15}, 16384);
    add_file(scenes, "poisson", unit_cell, 49152);
    add_beers_law(scenes);
    add_two_stream(scenes);
    add_turbid(scenes);
    add_sheets(scenes);
    add_furnace(scenes);
    return scenes;
}

}  // namespace ideotype
