// SPDX-License-Identifier: Apache-2.0
#include "spec/tables.hpp"

namespace ideotype {

namespace {

//! Joins two lists of keys.
template <std::size_t n, std::size_t m>
constexpr std::array<Key, n + m> join(const std::array<Key, n>& first,
                                      const std::array<Key, m>& second) {
    std::array<Key, n + m> all;
    std::ranges::copy(second, std::ranges::copy(first, all.begin()).out);
    return all;
}

bool never(const NamedSpacing& /*spacing*/) {
    return false;
}
bool repeats(const FieldForm& field) {
    return field.boundary == Boundary::periodic;
}
bool differs(const FieldForm& field) {
    return field.variation.is_any();
}
bool follows_nir(const Spec& spec) {
    return spec.plant.crop.follows[nir_band];
}
bool has_nir(const CropSpec& crop) {
    return crop.follows[nir_band];
}

// Each line declares one key.
// clang-format off
constexpr Key spacing_keys[] = {
    key<&NamedSpacing::name>("name", name_text, by("row x plant in mm", "\"762x152\""), "name of the spacing, a part of the names of cases"),
    key<&NamedSpacing::value, &Spacing::row>("row", metres_or_inches(0.02, 10), required("0.762"), "distance between neighbouring rows"),
    key<&NamedSpacing::value, &Spacing::plant>("plant", metres_or_inches(0.02, 10), by("by `density`", "0.1524"), "distance between neighbours in a row"),
    key<&NamedSpacing::value, &Spacing::density>("density", within(0.01, 1000, "m-2"), by("by `plant`"), "plants per ground area, instead of `plant`").written_if<NamedSpacing, never>(),
    key<&NamedSpacing::value, &Spacing::row_direction>("row_direction", within(0, 360, "deg"), usual(), "direction of rows, clockwise from north; 90 is east-west"),
};

constexpr Key field_keys[] = {
    key<&FieldForm::rows>("rows", within(1, 100), usual(), "number of rows of the field").trades<FieldForm, repeats>({1, 2, 4, 6}),
    key<&FieldForm::plants>("plants", within(1, 100), usual(), "number of plants in each row").trades<FieldForm, repeats>({1, 2, 4, 6}),
    key<&FieldForm::row_pattern>("row_pattern", numbers(0.01, 100), by("all equal", "[1, 3]"), "distances from each row to the next, relative to their mean, which is `spacing.row`; they repeat: [1, 3] are twin rows"),
    key<&FieldForm::boundary>("boundary", any_value, usual(), "edge of the field: it repeats without end, or it is an isolated plot on endless soil, which receives light from the sides"),
    key<&FieldForm::border_rows>("border_rows", within(0, 49), usual(), "border rows, and plants of each row, that are removed on all sides of an isolated plot"),
    key<&FieldForm::jitter>("jitter", within(0, 180, "deg"), usual(), "largest random turn of each plant, either way"),
};

//! The keys of differences between plants, stored in a record or a part of it.
template <auto... Path>
constexpr std::array variation_keys{
    key<Path..., &PlantVariation::length>("length", within(0, 0.3), usual(), "standard deviation of the length of each blade, relative to it"),
    key<Path..., &PlantVariation::width>("width", within(0, 0.3), usual(), "standard deviation of the width of each blade, relative to it"),
    key<Path..., &PlantVariation::insertion_angle>("insertion_angle", number_or_list(0, 30, "deg"), usual(), "standard deviation of the insertion angle of each leaf"),
    key<Path..., &PlantVariation::curvature>("curvature", number_or_list(0, 90, "deg"), usual(), "standard deviation of the curvature of each leaf, the angle by which its tip bends down"),
    key<Path..., &PlantVariation::azimuth>("azimuth", number_or_list(0, 60, "deg"), usual(), "standard deviation of the azimuth of each leaf"),
    key<Path..., &PlantVariation::roll>("roll", number_or_list(0, 90, "deg"), usual(), "standard deviation of the roll of each blade, its turn about its midrib halfway along"),
    key<Path..., &PlantVariation::twist>("twist", number_or_list(0, 180, "deg"), usual(), "standard deviation of the twist of each blade, its turn about its midrib from the base to the tip (Laplace distribution)"),
    key<Path..., &PlantVariation::height>("height", within(0, 0.3), usual(), "standard deviation of the height of each plant, relative to it: of stalk, sheaths, and where leaves begin"),
    key<Path..., &PlantVariation::across_row>("across_row", within(0, 1), by("as the baseline"), "fraction of plants with leaves across the row, within 45 deg; by default all plants have the azimuth of the baseline, except for `field.jitter`"),
    key<Path..., &PlantVariation::missing>("missing", within(0, 0.5), usual(), "fraction of missing plants"),
    key<Path..., &PlantVariation::late>("late", within(0, 0.5), usual(), "fraction of plants that emerge late"),
    key<Path..., &PlantVariation::position>("position", within(0, 0.3, "m"), usual(), "standard deviation of the position of each plant along the row"),
    key<Path..., &PlantVariation::position_across>("position_across", within(0, 0.3, "m"), usual(), "standard deviation of the position of each plant across the row")};

constexpr std::array crop_jitter{
    key<&CropVariation::jitter>("jitter", within(0, 180, "deg"), usual(), "largest random turn of each plant, either way")};

//! The keys for both sides of panels or objects, in all wavebands.
template <auto optics>
constexpr std::array side_keys{
    key<optics, par_band, &Lambertian::reflectance>("reflectance", within(0, 1), usual(), "reflectance of both sides, in the PAR band"),
    key<optics, par_band, &Lambertian::transmittance>("transmittance", within(0, 1), usual(), "transmittance, in the PAR band; with the reflectance 0.99 at most"),
    key<optics, nir_band, &Lambertian::reflectance>("nir_reflectance", within(0, 1), usual(), "reflectance of both sides, in the near infrared band"),
    key<optics, nir_band, &Lambertian::transmittance>("nir_transmittance", within(0, 1), usual(), "transmittance, in the near infrared band; with the reflectance 0.99 at most")};

constexpr std::array own_panel_keys{
    key<&PanelEntry::rows, &PanelRows::name>("name", name_text, usual(), "name of the rows in figures"),
    key<&PanelEntry::rows, &PanelRows::pitch>("pitch", metres(0, 100), usual(), "distance between rows of panels, which divides the field into a whole number of parts; 0: the width of the field"),
    key<&PanelEntry::rows, &PanelRows::height>("height", metres(0, 50), required("4"), "height of the middle of modules above the soil"),
    key<&PanelEntry::rows, &PanelRows::width>("width", metres(0.01, 50), required("2"), "width of modules, across the row"),
    key<&PanelEntry::rows, &PanelRows::tilt>("tilt", within(0, 90, "deg"), usual(), "angle of modules from horizontal; 90 is upright"),
    key<&PanelEntry::rows, &PanelRows::azimuth>("azimuth", within(0, 360, "deg"), required("180"), "direction of the front, clockwise from north: parallel to the rows of plants or at right angles to them"),
    key<&PanelEntry::rows, &PanelRows::offset>("offset", within(0, 100, "m"), usual(), "distance of the middle of the first row from the edge of the field, which is halfway between rows of plants"),
    key<&PanelEntry::rows, &PanelRows::module_length>("module_length", within(0, 100, "m"), usual(), "length of a module along the row; 0: endless"),
    key<&PanelEntry::rows, &PanelRows::gap>("gap", within(0, 100, "m"), usual(), "gap between the modules of a row"),
    key<&PanelEntry::rows, &PanelRows::tracks>("tracks", any_value, usual(), "true for modules that follow the sun about a horizontal axis, instead of `tilt`"),
    key<&PanelEntry::rows, &PanelRows::max_angle>("max_angle", within(0, 85, "deg"), usual(), "largest angle of tracking modules from horizontal, either way"),
    key<&PanelEntry::rows, &PanelRows::backtracks>("backtracks", any_value, usual(), "true for tracking modules that turn back under a low sun, so that no row shades another")};

constexpr std::array own_object_keys{
    key<&ObjectEntry::name>("name", name_text, required("\"post\""), "name of the object in figures"),
    key<&ObjectEntry::mesh, &MeshContent::file>("obj", file_path, none("\"post.obj\""), "Wavefront OBJ file of its surfaces in metres, z up, y along the rows"),
    key<&ObjectEntry::x>("x", within(-1000, 1000, "m"), usual(), "distance of its origin from the edge of the field, across the rows"),
    key<&ObjectEntry::y>("y", within(-1000, 1000, "m"), usual(), "distance of its origin from the edge of the field, along the rows"),
    key<&ObjectEntry::z>("z", within(-1000, 1000, "m"), usual(), "height of its origin above the soil"),
    key<&ObjectEntry::turn>("turn", within(-360, 360, "deg"), usual(), "turn about the vertical, clockwise from above"),
    key<&ObjectEntry::mesh, &MeshContent::vertices>("vertices", numbers(0, 0, "m"), by("those of the file", "[0, 1, 2, 2]"), "coordinates of each vertex, as the program writes them instead of a file"),
    key<&ObjectEntry::mesh, &MeshContent::faces>("faces", numbers(0, 0), by("those of the file", "[0, 1, 2, 2]"), "four vertices of each face, from 0")};

constexpr Values parts = numbers(0, 1, "", "[reflectance, transmittance], or [reflectance of the upper face, of the lower face, transmittance]");
constexpr Key material_keys[] = {
    key<&MaterialSpec::groups>("groups", Values{.type = "text or list of texts", .count = any_count}, required("\"leaf\""), "prefixes of the names of the material's groups; the first material with a matching prefix applies"),
    key<&MaterialSpec::optics, par_band>("par", parts, none("[0.06, 0.03]"), "optical properties in PAR; campaigns require it"),
    key<&MaterialSpec::optics, nir_band>("nir", parts, none("[0.4, 0.4]"), "optical properties in the near infrared, if the campaign has that band"),
};
constexpr Key other_band = itself<std::vector<double>>("BAND", parts, none("[0.06, 0.03]"), "optical properties in a waveband");

constexpr Key band_keys[] = {
    key<&BandEntry::name>("name", texts("par", "nir"), required("\"nir\""), "additional waveband of light: near infrared is the solar radiation beyond PAR"),
};

//! The keys for the surfaces of plants in one waveband.
template <auto... Optics>
constexpr std::array surface_keys{
    key<Optics..., &PlantOptics::leaf, &Lambertian::reflectance>("leaf_reflectance", within(0, 1), usual(), "reflectance of both faces of leaves"),
    key<Optics..., &PlantOptics::leaf, &Lambertian::transmittance>("leaf_transmittance", within(0, 1), usual(), "transmittance of leaves; with the reflectance 1 at most"),
    key<Optics..., &PlantOptics::stalk, &Lambertian::reflectance>("stalk_reflectance", within(0, 1), usual(), "reflectance of the stalk's surface"),
    key<Optics..., &PlantOptics::stalk, &Lambertian::transmittance>("stalk_transmittance", within(0, 1), usual(), "transmittance of the stalk; with the reflectance 1 at most"),
    key<Optics..., &PlantOptics::sheath, &Lambertian::reflectance>("sheath_reflectance", within(0, 1), usual(), "reflectance of the surface of sheaths"),
    key<Optics..., &PlantOptics::sheath, &Lambertian::transmittance>("sheath_transmittance", within(0, 1), usual(), "transmittance of sheaths; with the reflectance 1 at most")};

constexpr std::array soil_keys{
    key<&Spec::soil_albedo, par_band>("soil_albedo", within(0, 1), usual(), "reflectance of the soil"),
    key<&Spec::par_fraction>("par_fraction", within(0.01, 1), usual(), "PAR as a fraction of solar energy")};

constexpr std::array nir_soil_keys{
    key<&Spec::soil_albedo, nir_band>("soil_albedo", within(0, 1), usual(), "reflectance of the soil")};
// clang-format on

constexpr Table field_tables[] = {
    table<&FieldForm::variation>("variation", variation_table)
        .optional()
        .written_if<FieldForm, differs>()};

constexpr auto optics_keys = join(
    surface_keys<&Spec::plant, &PlantSpec::crop, &CropSpec::optics, par_band>,
    soil_keys);
constexpr auto nir_keys = join(
    surface_keys<&Spec::plant, &PlantSpec::crop, &CropSpec::optics, nir_band>,
    nir_soil_keys);
constexpr auto crop_variation_keys =
    join(variation_keys<&CropVariation::plants>, crop_jitter);
constexpr auto panel_keys =
    join(own_panel_keys, side_keys<&PanelEntry::optics>);
constexpr auto object_keys =
    join(own_object_keys, side_keys<&ObjectEntry::optics>);

constinit const Description nir_table = describe<Spec>("nir", nir_keys);
constexpr Table optics_tables[] = {table_of<Spec>("nir", nir_table)
                                       .optional()
                                       .written_if<Spec, follows_nir>()};

constinit const Description crop_nir_table =
    describe<CropSpec>("nir", surface_keys<&CropSpec::optics, nir_band>);
constexpr Table crop_optics_tables[] = {
    table_of<CropSpec>("nir", crop_nir_table)
        .optional()
        .written_if<CropSpec, has_nir>()};

}  // namespace

constinit const Description spacing_table =
    describe<NamedSpacing>("spacing", spacing_keys);
constinit const Description variation_table =
    describe<PlantVariation>("variation", variation_keys<>);
constinit const Description crop_variation_table =
    describe<CropVariation>("variation", crop_variation_keys);
constinit const Description field_table =
    describe<FieldForm>("field", field_keys, field_tables);
constinit const Description panel_table =
    describe<PanelEntry>("panel", panel_keys);
constinit const Description object_table =
    describe<ObjectEntry>("object", object_keys);
constinit const Description material_table =
    describe<MaterialSpec>("material", material_keys)
        .with_others<&MaterialSpec::others>(other_band);
constinit const Description band_table = describe<BandEntry>("band", band_keys);
constinit const Description optics_table =
    describe<Spec>("optics", optics_keys, optics_tables);
constinit const Description crop_optics_table = describe<CropSpec>(
    "optics", surface_keys<&CropSpec::optics, par_band>, crop_optics_tables);

}  // namespace ideotype
