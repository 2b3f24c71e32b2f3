// SPDX-License-Identifier: Apache-2.0
#include "mesh_study.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/campaign.hpp"
#include "campaign/leaves.hpp"
#include "campaign/mesh_scene.hpp"
#include "campaign/meshes.hpp"
#include "ideotype/canopy/field.hpp"
#include "ideotype/crop/obj_reader.hpp"
#include "ideotype/light/device.hpp"
#include "spec/problems.hpp"

namespace ideotype {

namespace {

//! The number of independent randomisations from which standard errors are
//! estimated, with a relative uncertainty of about an eighth.
constexpr std::uint64_t usual_randomisations = 32;

constexpr std::size_t layers = 10;

//! Returns a single source over one second, or the light of a clear day.
LightSeries day_of(const MeshSpec& spec) {
    constexpr double par_fraction = 0.45;
    if (spec.site)
        return clear_days(*spec.site, {{spec.date}, 0, 24, 60}, par_fraction);
    Irradiance one = spec.sky ? Irradiance{0, 1} : Irradiance{1, 0};
    if (spec.has_ppfd())
        one = {spec.beam_ppfd.value_or(0), spec.sky_ppfd.value_or(0)};
    SunPosition sun;
    if (spec.sun) sun = {90 - spec.sun->elevation, spec.sun->azimuth};
    return {{{0, 1, sun, one}}};
}

SeriesIllumination light_of(const MeshSpec& spec,
                            std::vector<std::string>& warnings) {
    constexpr double north = 0;  // the y axis of the mesh points north
    //! Number of dates that provide sun positions for a season. It is higher
    //! than in campaigns, which only compare plants.
    constexpr int dates = 6;
    const SkyModel sky = spec.sky.value_or(SkyModel::uniform);
    if (spec.climate.empty()) return illuminate(day_of(spec), sky, north);
    SeasonLight season = read_climate(spec.climate);
    for (const Problem& warning : season.warnings)
        warnings.push_back(fmt::format("{}:{}: {}", warning.where.file,
                                       warning.where.line, warning.what));
    return illuminate(std::move(season.series), sky, north, Skies::shared,
                      dates);
}

FieldForm form_of(const MeshSpec& spec) {
    FieldForm form;
    form.rows = spec.field->rows;
    form.plants = spec.field->plants;
    form.spacing.row = spec.field->row_spacing;
    form.spacing.plant = spec.field->plant_spacing;
    form.jitter = spec.jitter.value_or(0);
    return form;
}

Cell ground_of(const MeshSpec& spec) {
    Cell cell;
    if (spec.field) cell = cell_of(form_of(spec));
    if (spec.period) {
        cell.period_x = spec.period->x;
        cell.period_y = spec.period->y;
        cell.ground_area = cell.period_x * cell.period_y;
    }
    cell.boundary = spec.boundary;
    if (spec.ground_area) cell.ground_area = *spec.ground_area;
    return cell;
}

//! Returns the faces of selected groups of a mesh, with only the vertices they
//! use.
Mesh part_of(const Mesh& mesh, const std::vector<bool>& is_wanted) {
    constexpr std::uint32_t none = ~std::uint32_t{0};
    Mesh part;
    std::vector<std::uint32_t> group(mesh.groups.size(), none);
    for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
        if (!is_wanted[g]) continue;
        group[g] = static_cast<std::uint32_t>(part.groups.size());
        part.groups.push_back(mesh.groups[g]);
    }
    std::vector<std::uint32_t> vertex(mesh.vertices.size(), none);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        if (!is_wanted[mesh.face_group[f]]) continue;
        part.face_group.push_back(group[mesh.face_group[f]]);
        part.faces.push_back(mesh.faces[f]);
        for (std::uint32_t& v : part.faces.back()) {
            if (vertex[v] == none) {
                vertex[v] = static_cast<std::uint32_t>(part.vertices.size());
                part.vertices.push_back(mesh.vertices[v]);
            }
            v = vertex[v];
        }
    }
    return part;
}

//! Divides a mesh into the components of a scene file.
//! @throws Error if a group matches no material or no component.
std::vector<Component> components_of(const Mesh& mesh, const MeshScene& file,
                                     std::vector<std::string>& warnings) {
    std::vector<std::string> problems;
    const auto require = [&](const auto& entries, const Group& group,
                             const char* table) {
        const std::size_t place = first_that_fits(entries, group.name);
        if (place == entries.size())
            problems.push_back(fmt::format(
                "{}: group {} fits no [[{}]] (none has groups that it begins "
                "with); add one",
                file.file, group.name, table));
        return place;
    };
    std::vector<std::vector<bool>> is_own(
        file.components.size() + 1, std::vector<bool>(mesh.groups.size()));
    for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
        require(file.materials, mesh.groups[g], "material");
        is_own[require(file.components, mesh.groups[g], "component")][g] = true;
    }
    if (!problems.empty())
        throw Error(fmt::format("{}", fmt::join(problems, "\n")));
    std::vector<Component> components;
    for (std::size_t c = 0; c < file.components.size(); ++c) {
        const MeshScene::Component& kind = file.components[c];
        Component one{.name = kind.name,
                      .mesh = part_of(mesh, is_own[c]),
                      .photosynthesis = {}};
        if (kind.photosynthesis)
            one.photosynthesis = to_photosynthesis(*kind.photosynthesis);
        if (one.mesh.faces.empty())
            warnings.push_back(fmt::format(
                "{}: component \"{}\" has no surfaces (no group of the mesh "
                "begins with {}); it is left out",
                file.file, kind.name, fmt::join(kind.groups, " or ")));
        else if (kind.photosynthesis &&
                 std::ranges::none_of(one.mesh.groups, &SurfaceId::is_leaf,
                                      &Group::id))
            throw Error(fmt::format(
                "{}: component \"{}\" has photosynthesis, but none of its "
                "groups is a leaf; let their names end in leaf01, leaf02, ...",
                file.file, kind.name));
        else
            components.push_back(std::move(one));
    }
    return components;
}

SeriesIllumination light_in(const std::string& band, SeriesIllumination light,
                            const MeshSpec& spec, const Problems& problems) {
    if (!spec.has_day() || band == "par") return light;
    for (const Waveband& each : wavebands)
        if (band == each.name) return in_band(std::move(light), each.light);
    problems.named_rule({"scene", "sun", "sky"}, true,
                        "{3}: there is no light in band \"{4}\" (a day and a "
                        "climate have light in the bands of campaigns only); "
                        "use one of those, such as \"nir\", or give {1} or {2}",
                        spec.scene, band);
    problems.throw_wrong_usage();
    return light;
}

//! Sets the components and bands that a scene file describes.
void add_scene_file(Mesh mesh, const MeshSpec& spec,
                    const SeriesIllumination& light, const Problems& problems,
                    std::vector<std::string>& warnings, Scene& scene) {
    const MeshScene file = read_mesh_scene(spec.scene);
    for (const std::string& band : bands_of(file.materials))
        scene.bands.push_back({band, {}, {{}, file.soil_albedo.at(band)}});
    number_groups(mesh);
    add_surfaces(file.materials, mesh, scene.bands);
    scene.components = components_of(mesh, file, warnings);
    problems.named_rule(
        {"scene", "beam_ppfd", "sky_ppfd", "site", "date", "climate"},
        scene.assimilates() && !spec.has_day() && !spec.has_ppfd(),
        "{0}: photosynthesis needs the irradiance: {1}, {2}, a day with {3} "
        "and {4}, or {5}");
    problems.named_rule(
        {"jitter"}, scene.components.size() > 1 && spec.jitter.value_or(0) > 0,
        "{0}: components of a mesh cannot turn together; leave it out");
    problems.throw_wrong_usage();
    for (Band& band : scene.bands)
        band.light = light_in(band.name, light, spec, problems);
}

Scene scene_of(Mesh mesh, const MeshSpec& spec, const Problems& problems,
               std::vector<std::string>& warnings) {
    Scene scene;
    scene.cell = ground_of(spec);
    if (!spec.has_day()) scene.photons = 1;
    std::optional<Photosynthesis> photosynthesis;
    if (!spec.photosynthesis.empty())
        photosynthesis = read_photosynthesis(spec.photosynthesis);
    SeriesIllumination light = light_of(spec, warnings);
    if (!spec.scene.empty()) {
        add_scene_file(std::move(mesh), spec, light, problems, warnings, scene);
    } else {
        scene.components = {{.name = "",
                             .mesh = std::move(mesh),
                             .photosynthesis = photosynthesis}};
        scene.bands = {{"par",
                        std::move(light),
                        {spec.optics.materials(), spec.soil_albedo}}};
    }
    if (spec.field)
        for (Component& each : scene.components)
            set_places(each, form_of(spec));
    return scene;
}

//! Returns an accuracy with at least the requested number of paths.
Accuracy accuracy_of(const MeshSpec& spec) {
    const std::uint64_t paths = spec.paths > 0
                                    ? static_cast<std::uint64_t>(spec.paths)
                                    : most_tolerance_paths;
    const std::uint64_t randomisations =
        std::clamp<std::uint64_t>(paths, 2, usual_randomisations);
    return {static_cast<int>((paths + randomisations - 1) / randomisations),
            static_cast<int>(randomisations),
            spec.paths > 0 ? 0 : spec.tolerance};
}

}  // namespace

MeshReport study(const MeshSpec& spec, KeyNaming naming) {
    check_rules(spec, Problems(naming));
    ObjMesh obj = read_obj(spec.path);
    MeshReport result = study(std::move(obj.mesh), spec, naming);
    result.warnings.insert(result.warnings.begin(), obj.warnings.begin(),
                           obj.warnings.end());
    return result;
}

MeshReport study(Mesh mesh, const MeshSpec& spec, KeyNaming naming) {
    const Problems problems(naming);
    check_rules(spec, problems);
    const double plants =
        spec.field ? 1.0 * spec.field->rows * spec.field->plants : 1;
    MeshReport result;
    result.warnings =
        check_mesh(mesh, plants, ground_of(spec), spec.sun, problems);
    const CanopyRequest request{
        scene_of(std::move(mesh), spec, problems, result.warnings),
        {0, layers},
        accuracy_of(spec),
        {spec.seed},
        {.sunlit = true, .faces = spec.is_by_face, .exact = spec.is_exact}};
    result.canopy = evaluate(request, Device(Device::supported_isas().back()));
    return result;
}

}  // namespace ideotype
