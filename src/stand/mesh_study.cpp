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

//! The number of independent repetitions from which errors are estimated,
//! enough to know errors to an eighth.
constexpr std::uint64_t usual_randomisations = 32;

constexpr std::size_t layers = 10;

//! Returns a single light for one second, or the light of a clear day.
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
    constexpr double north = 0;  // direction of the mesh's y axis
    //! Dates of a season: more than in a campaign, which only compares plants.
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

//! Returns the faces of some groups of a mesh, with only their vertices.
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

//! Puts the parts of a mesh into a scene as a scene file describes.
class SceneBuilder {
  public:
    SceneBuilder(Mesh mesh, const MeshScene& file,
                 std::vector<std::string>& warnings)
        : mesh_(std::move(mesh)), file_(file), warnings_(warnings) {}

    //! @throws Error if a group fits no material or no component.
    std::vector<Component> components() {
        assign();
        std::vector<Component> all;
        for (std::size_t c = 0; c < file_.components.size(); ++c) {
            const MeshScene::Component& kind = file_.components[c];
            std::vector<bool> is_own;
            for (const std::size_t of : component_) is_own.push_back(of == c);
            Component one{.name = kind.name,
                          .mesh = part_of(mesh_, is_own),
                          .photosynthesis = {}};
            if (kind.photosynthesis)
                one.photosynthesis = to_photosynthesis(*kind.photosynthesis);
            if (one.mesh.faces.empty())
                warnings_.push_back(fmt::format(
                    "{}: component \"{}\" has no surfaces (no group of the "
                    "mesh begins with {}); it is left out",
                    file_.file, kind.name, fmt::join(kind.groups, " or ")));
            else if (kind.photosynthesis && !has_leaves(one.mesh))
                throw Error(fmt::format(
                    "{}: component \"{}\" has photosynthesis, but none of its "
                    "groups is a leaf; let their names end in leaf01, leaf02, "
                    "...",
                    file_.file, kind.name));
            else
                all.push_back(std::move(one));
        }
        return all;
    }

  private:
    static bool has_leaves(const Mesh& mesh) {
        return std::ranges::any_of(mesh.groups, &SurfaceId::is_leaf,
                                   &Group::id);
    }

    //! Finds the kind of each group. If no group is called a leaf, all groups
    //! are leaves.
    void assign() {
        number_groups(mesh_);
        std::vector<std::string> problems;
        for (Group& group : mesh_.groups) {
            group.material = static_cast<std::uint32_t>(
                first_that_fits(file_.materials, group.name));
            component_.push_back(first_that_fits(file_.components, group.name));
            const auto require = [&](bool holds, const std::string& table) {
                if (!holds)
                    problems.push_back(fmt::format(
                        "{}: group {} fits no [[{}]] (none has groups that it "
                        "begins with); add one",
                        file_.file, group.name, table));
            };
            require(group.material < file_.materials.size(), "material");
            require(component_.back() < file_.components.size(), "component");
        }
        if (!problems.empty())
            throw Error(fmt::format("{}", fmt::join(problems, "\n")));
    }

    Mesh mesh_;
    const MeshScene& file_;
    std::vector<std::string>& warnings_;
    std::vector<std::size_t> component_;  //!< component of each group
};

SeriesIllumination light_in(const std::string& band, SeriesIllumination light,
                            const MeshSpec& spec, const Problems& problems) {
    if (!spec.has_day() || band == "par") return light;
    for (const Waveband& each : wavebands)
        if (band == each.name) return in_band(std::move(light), each.light);
    problems.named_rule(
        {"scene", "sun", "sky"}, true,
        "{3}: there is no light in band \"{4}\" (a day and a climate have "
        "light in those of campaigns); name the band so, such as \"nir\", or "
        "give {1} or {2}",
        spec.scene, band);
    problems.throw_wrong_usage();
    return light;
}

//! Sets the components and bands that a scene file describes.
void add_scene_file(Mesh mesh, const MeshSpec& spec,
                    const SeriesIllumination& light, const Problems& problems,
                    std::vector<std::string>& warnings, Scene& scene) {
    const MeshScene file = read_mesh_scene(spec.scene);
    scene.components =
        SceneBuilder(std::move(mesh), file, warnings).components();
    problems.named_rule(
        {"scene", "beam_ppfd", "sky_ppfd", "site", "date", "climate"},
        scene.assimilates() && !spec.has_day() && !spec.has_ppfd(),
        "{0}: photosynthesis needs how strong the light is: {1}, {2}, a day "
        "with {3} and {4}, or {5}");
    problems.named_rule(
        {"jitter"}, scene.components.size() > 1 && spec.jitter.value_or(0) > 0,
        "{0}: components of a mesh cannot turn together; leave it out");
    problems.throw_wrong_usage();
    for (const std::string& band : file.bands()) {
        Optics optics{{}, file.soil_albedo.at(band)};
        for (const MeshScene::Material& each : file.materials)
            optics.materials.push_back(material_of(each.bands.at(band)));
        scene.bands.push_back(
            {band, light_in(band, light, spec, problems), std::move(optics)});
    }
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

//! Returns an accuracy with at least the number of paths asked for.
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
