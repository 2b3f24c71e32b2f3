// SPDX-License-Identifier: Apache-2.0
#include "spec/mesh_spec.hpp"
#include "spec/tables.hpp"

namespace ideotype {

namespace {

constexpr Values length = within(1e-4, 1e5, "m");
constexpr Values file{.type = "file"};
constexpr Values groups{.type = "text or list of texts", .count = any_count};

constexpr auto leaf = &PlantOptics::leaf, stalk = &PlantOptics::stalk,
               sheath = &PlantOptics::sheath;
constexpr auto reflectance = &Lambertian::reflectance,
               transmittance = &Lambertian::transmittance;

// Each line declares one key.
// clang-format off
constexpr Key mesh_keys[] = {
    key<&MeshSpec::scene>("scene", file, none(), "FILE.toml with materials, components and wavebands by the names of groups, for several kinds of plants or near infrared; see the manual"),
    key<&MeshSpec::boundary>("boundary", any_value, usual(), "periodic: an endless stand; isolated: the mesh alone on endless soil"),
    key<&MeshSpec::ground_area>("ground_area", within(1e-6, 1e8, "m2"), none("0.114"), "ground area of fractions; in a periodic stand that of the period"),
    key<&MeshSpec::jitter>("jitter", within(0, 180, "deg"), by("0"), "largest random turn of each plant of a field"),
    key<&MeshSpec::sky>("sky", any_value, none(), "light of the sky (clear needs the position of the sun); at a site the sky of that day"),
    key<&MeshSpec::date>("date", Values{.type = "date", .range = "YYYY-MM-DD, 1950 .. 2100"}, none("2025-08-07"), "date of the clear day at the site"),
    key<&MeshSpec::beam_ppfd>("beam_ppfd", within(0, 1e5, "umol m-2 s-1"), none("1500"), "light of the sun on horizontal ground above the canopy; 1 by default"),
    key<&MeshSpec::sky_ppfd>("sky_ppfd", within(0, 1e5, "umol m-2 s-1"), none("300"), "light of the sky on horizontal ground"),
    key<&MeshSpec::climate>("climate", file, none(), "FILE.toml with the tables [site] and [climate] of a campaign: the light of a season, as its mean day"),
    key<&MeshSpec::photosynthesis>("photosynthesis", file, none(), "FILE.toml with a [photosynthesis] table, for the assimilation of the leaves"),
    key<&MeshSpec::is_exact>("exact", any_value, usual(), "computes assimilation at random points of leaves by paths from there to the light: without bias, but slowly, to check the usual method"),
    key<&MeshSpec::optics, leaf, reflectance>("leaf_reflectance", within(0, 1), usual(), "reflectance of both faces of leaves").excluding("scene"),
    key<&MeshSpec::optics, leaf, transmittance>("leaf_transmittance", within(0, 1), usual(), "transmittance of leaves").excluding("scene"),
    key<&MeshSpec::optics, stalk, reflectance>("stalk_reflectance", within(0, 1), usual(), "reflectance of groups with names that begin with stalk, or with plantN_stalk").excluding("scene"),
    key<&MeshSpec::optics, stalk, transmittance>("stalk_transmittance", within(0, 1), usual(), "transmittance of the same groups").excluding("scene"),
    key<&MeshSpec::optics, sheath, reflectance>("sheath_reflectance", within(0, 1), usual(), "reflectance of groups with names that begin with sheath, or with plantN_sheath").excluding("scene"),
    key<&MeshSpec::optics, sheath, transmittance>("sheath_transmittance", within(0, 1), usual(), "transmittance of the same groups").excluding("scene"),
    key<&MeshSpec::soil_albedo>("soil_albedo", within(0, 1), usual(), "reflectance of the soil").excluding("scene"),
    key<&MeshSpec::tolerance>("tolerance", within(1e-9, 1), usual(), "relative standard error of the light absorbed by all leaves"),
    key<&MeshSpec::paths>("paths", within(1, 4294967296), none("4096"), "smallest number of light paths, instead of a tolerance").excluding("tolerance"),
    key<&MeshSpec::seed>("seed", any_value, usual(), "seed of the random numbers"),
};

constexpr Key period_keys[] = {
    key<&MeshSpec::Period::x>("x", length, required("0.76"), "period along x"),
    key<&MeshSpec::Period::y>("y", length, required("0.15"), "period along y"),
};
constexpr Key sun_keys[] = {
    key<&MeshSpec::Sun::elevation>("elevation", within(-90, 90, "deg"), required("60"), "elevation above the horizon"),
    key<&MeshSpec::Sun::azimuth>("azimuth", within(-360, 360, "deg"), required("180"), "azimuth, clockwise from north = +y"),
};
constexpr Key mesh_field_keys[] = {
    key<&MeshSpec::Field::rows>("rows", within(1, 1e6), required("4"), "rows"),
    key<&MeshSpec::Field::plants>("plants", within(1, 1e6), required("4"), "plants of each row"),
    key<&MeshSpec::Field::row_spacing>("row_spacing", length, required("0.76"), "distance between rows"),
    key<&MeshSpec::Field::plant_spacing>("plant_spacing", length, required("0.15"), "distance between plants of a row"),
};

constexpr Key scene_component_keys[] = {
    key<&MeshScene::Component::name>("name", name_text, required("\"maize\""), "name of the component"),
    key<&MeshScene::Component::groups>("groups", groups, by("the name"), "prefixes of the names of the component's groups"),
};
constexpr Key scene_keys[] = {
    key_of<MeshScene>("soil_albedo", within(0, 1), usual(), "reflectance of the soil, or a table of it by waveband"),
};
constexpr Key soil_band = itself<double>("BAND", within(0, 1), none("0.1"), "reflectance of the soil in a waveband");
// clang-format on

constinit const Description period_table =
    describe<MeshSpec::Period>("period", period_keys);
constinit const Description sun_table =
    describe<MeshSpec::Sun>("sun", sun_keys);
constinit const Description mesh_field_table =
    describe<MeshSpec::Field>("field", mesh_field_keys);

constexpr Table leaves_tables[] = {table<&MeshScene::Component::photosynthesis>(
    "photosynthesis", photosynthesis_table)};
constinit const Description mesh_component_table =
    describe<MeshScene::Component>("component", scene_component_keys,
                                   leaves_tables);

constexpr Table mesh_tables[] = {
    table<&MeshSpec::period>("period", period_table)
        .with(&Table::meaning, "lattice on which the mesh repeats"),
    table<&MeshSpec::field>("field", mesh_field_table)
        .with(&Table::meaning,
              "repeats the mesh, a plant at x = y = 0, in rows along y"),
    table<&MeshSpec::sun>("sun", sun_table)
        .with(&Table::meaning,
              "position of the sun, with light of 1 on horizontal "
              "ground unless it is given"),
    table<&MeshSpec::site>("site", place_table)
        .with(&Table::meaning,
              "site with the sun and the sky of a clear day on a date")};
constexpr Table scene_tables[] = {
    table<&MeshScene::materials>("material", material_table),
    table<&MeshScene::components>("component", mesh_component_table)
        .optional()};

}  // namespace

constinit const Description mesh_table =
    describe<MeshSpec>("light", mesh_keys, mesh_tables);
constinit const Description mesh_scene_table =
    describe<MeshScene>("top", scene_keys, scene_tables);
constinit const Description mesh_soil_table =
    describe<MeshScene>("soil_albedo", std::array<Key, 0>())
        .with_others<&MeshScene::soil_albedo>(soil_band);

}  // namespace ideotype
