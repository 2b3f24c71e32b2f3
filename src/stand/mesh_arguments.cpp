// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <tuple>

#include <CLI/CLI.hpp>

#include "ideotype/core/error.hpp"
#include "mesh_options.hpp"

namespace ideotype {

namespace {

using Two = std::tuple<double, double>;
using Three = std::tuple<double, double, double>;
using Four = std::tuple<int, int, double, double>;

FieldForm& field_of(MeshOptions& options) {
    if (!options.field) {
        options.field.emplace();
        options.field->jitter = 0;
    }
    return *options.field;
}

template <class Value, class Target>
CLI::Option* add_choice(CLI::App& verb, const std::string& name, Target& target,
                        const std::map<std::string, Value>& choices,
                        const std::string& about) {
    return verb
        .add_option_function<std::string>(
            name,
            [&target, choices](const std::string& text) {
                target = choices.at(text);
            },
            about)
        ->check(CLI::IsMember(choices));
}

void add_light(CLI::App& verb, MeshOptions& options) {
    verb.add_option_function<Two>(
        "--sun",
        [&](const Two& sun) {
            options.sun = {90 - std::get<0>(sun), std::get<1>(sun)};
        },
        "elevation and azimuth, clockwise from north = +y [deg]; its "
        "light on level ground is 1");
    add_choice<SkyModel>(verb, "--sky", options.sky,
                         {{"uniform", SkyModel::uniform},
                          {"overcast", SkyModel::overcast},
                          {"clear", SkyModel::clear}},
                         "light of the sky (clear needs --sun for the sun's "
                         "place); with --site the sky of that day");
    verb.add_option("--beam-ppfd", options.beam_ppfd,
                    "light of --sun on level ground above the canopy "
                    "[umol m-2 s-1]; if not given, it is 1");
    verb.add_option("--sky-ppfd", options.sky_ppfd,
                    "light of --sky on level ground [umol m-2 s-1]");
    verb.add_option("--climate", options.climate,
                    "FILE.toml with the tables [site] and [climate] of a "
                    "campaign: the light of a season, as its mean day");
    verb.add_option("--photosynthesis", options.photosynthesis,
                    "FILE.toml with a [photosynthesis] table, from which the "
                    "assimilation of the leaves follows");
    verb.add_flag("--exact", options.is_exact,
                  "finds assimilation at random points of leaves, by paths "
                  "from there to the light: without bias, but slowly; it "
                  "checks the usual way");
    verb.add_option_function<Three>(
        "--site",
        [&](const Three& site) {
            options.site = Site{};
            std::tie(options.site->latitude, options.site->longitude,
                     options.site->utc_offset) = site;
        },
        "latitude, longitude [deg] and UTC offset [h] of a place with the sun "
        "and the sky of a clear day (--date)");
    verb.add_option_function<std::string>(
        "--date",
        [&](const std::string& text) {
            options.date = to_date(text);
            if (!options.date)
                throw CLI::ValidationError(
                    "--date", text + " is no date; write it as YYYY-MM-DD");
        },
        "date of the clear day at --site: YYYY-MM-DD");
}

void add_ground(CLI::App& verb, MeshOptions& options) {
    verb.add_option_function<Two>(
        "--period",
        [&](const Two& period) {
            options.period = {std::get<0>(period), std::get<1>(period)};
        },
        "lattice on which the mesh repeats, along x and y [m]");
    add_choice<Boundary>(
        verb, "--boundary", options.boundary,
        {{"periodic", Boundary::periodic}, {"isolated", Boundary::isolated}},
        "periodic (default): an endless stand; isolated: the "
        "mesh alone on endless soil");
    verb.add_option("--ground-area", options.ground_area,
                    "ground that fractions refer to [m2]; in a periodic stand "
                    "it is that of the period");
    auto* field = verb.add_option_function<Four>(
        "--field",
        [&](const Four& form) {
            FieldForm& field_form = field_of(options);
            std::tie(field_form.rows, field_form.plants, field_form.spacing.row,
                     field_form.spacing.plant) = form;
        },
        "rows, plants per row, row and plant spacing [m]: repeats the mesh, a "
        "plant at x = y = 0, in rows along y");
    verb.add_option_function<double>(
            "--jitter",
            [&](double jitter) { field_of(options).jitter = jitter; },
            "largest random turn of each plant of a field [deg], default 0")
        ->needs(field);
}

void add_surface(CLI::App& verb, const std::string& material,
                 Lambertian& surface, const std::string& meaning,
                 CLI::Option* scene) {
    verb.add_option(material + "-reflectance", surface.reflectance,
                    "reflected part of the light, " + meaning)
        ->capture_default_str()
        ->excludes(scene);
    verb.add_option(material + "-transmittance", surface.transmittance,
                    "transmitted part of the light, " + meaning)
        ->capture_default_str()
        ->excludes(scene);
}

}  // namespace

void declare(CLI::App& verb, MeshOptions& options) {
    auto* scene = verb.add_option(
        "--scene", options.scene,
        "FILE.toml that tells materials, components and wavebands by the names "
        "of groups, for several kinds of plants or near infrared; see the "
        "manual");
    add_ground(verb, options);
    add_light(verb, options);
    add_surface(verb, "--leaf", options.optics.leaf, "of both faces", scene);
    add_surface(verb, "--stalk", options.optics.stalk,
                "of groups whose names begin with stalk, or with plantN_stalk",
                scene);
    add_surface(
        verb, "--sheath", options.optics.sheath,
        "of groups whose names begin with sheath, or with plantN_sheath",
        scene);
    verb.add_option("--soil-albedo", options.soil_albedo,
                    "part of the light that the soil reflects")
        ->capture_default_str()
        ->excludes(scene);
    auto* tolerance =
        verb.add_option("--tolerance", options.tolerance,
                        "relative standard error of the leaves' total")
            ->capture_default_str();
    verb.add_option("--paths", options.paths,
                    "how many paths of light to follow at least, instead of "
                    "a tolerance")
        ->excludes(tolerance);
    verb.add_option("--seed", options.seed, "seed of the random numbers")
        ->capture_default_str();
}

MeshOptions read_mesh_options(std::vector<std::string> arguments) {
    CLI::App app;
    MeshOptions options;
    declare(app, options);
    std::reverse(arguments.begin(), arguments.end());
    try {
        app.parse(std::move(arguments));
    } catch (const CLI::ParseError& error) {
        throw Error(error.what(), ExitCode::usage);
    }
    return options;
}

}  // namespace ideotype
