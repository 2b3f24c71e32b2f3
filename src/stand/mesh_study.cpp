// SPDX-License-Identifier: Apache-2.0
#include "mesh_study.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/campaign.hpp"
#include "campaign/mesh_scene.hpp"
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
LightSeries day_of(const MeshOptions& options) {
    constexpr double par_fraction = 0.45;
    if (options.site)
        return clear_days(*options.site, {{*options.date}, 0, 24, 60},
                          par_fraction);
    Irradiance one = options.sky ? Irradiance{0, 1} : Irradiance{1, 0};
    if (options.beam_ppfd || options.sky_ppfd)
        one = {options.beam_ppfd.value_or(0), options.sky_ppfd.value_or(0)};
    return {{{0, 1, options.sun.value_or(SunPosition{}), one}}};
}

SeriesIllumination light_of(const MeshOptions& options,
                            std::vector<std::string>& warnings) {
    constexpr double north = 0;  // direction of the mesh's y axis
    //! Dates of a season: more than in a campaign, which only compares plants.
    constexpr int dates = 6;
    const SkyModel sky = options.sky.value_or(SkyModel::uniform);
    if (options.climate.empty()) return illuminate(day_of(options), sky, north);
    SeasonLight season = read_climate(options.climate);
    for (const Problem& warning : season.warnings)
        warnings.push_back(fmt::format("{}:{}: {}", warning.where.file,
                                       warning.where.line, warning.what));
    return illuminate(std::move(season.series), sky, north, Skies::shared,
                      dates);
}

Cell ground_of(const MeshOptions& options) {
    Cell cell;
    if (options.field) cell = cell_of(*options.field);
    if (options.period) {
        cell.period_x = options.period->x;
        cell.period_y = options.period->y;
        cell.ground_area = cell.period_x * cell.period_y;
    }
    cell.boundary = options.boundary;
    if (options.ground_area) cell.ground_area = *options.ground_area;
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
            const MeshScene::Kind& kind = file_.components[c];
            std::vector<bool> is_own;
            for (const std::size_t of : component_) is_own.push_back(of == c);
            Component one{.name = kind.name,
                          .mesh = part_of(mesh_, is_own),
                          .photosynthesis = kind.photosynthesis};
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

    template <class Entry>
    static std::size_t first_that_fits(const std::vector<Entry>& entries,
                                       const std::string& name) {
        const auto fits = [&](const Entry& entry) {
            return std::ranges::any_of(entry.groups, [&](const auto& prefix) {
                return name.starts_with(prefix);
            });
        };
        return static_cast<std::size_t>(std::ranges::find_if(entries, fits) -
                                        entries.begin());
    }

    //! Finds the kind of each group. If no group is called a leaf, all groups
    //! are leaves.
    void assign() {
        const bool has_ranks =
            std::ranges::any_of(mesh_.groups, leaf_rank, &Group::name);
        std::vector<std::string> problems;
        for (Group& group : mesh_.groups) {
            const std::uint32_t rank = leaf_rank(group.name);
            group.id = {0, has_ranks && rank == 0 ? 1u : 0u, rank};
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
                            const MeshOptions& options) {
    if (!has_day(options) || band == "par") return light;
    for (const Waveband& each : wavebands)
        if (band == each.name) return in_band(std::move(light), each.light);
    throw wrong_usage(
        "{}: there is no light in band \"{}\" (a day and a climate have light "
        "in those of campaigns); name the band so, such as \"nir\", or give "
        "--sun or --sky",
        options.scene, band);
}

Scene scene_of(Mesh mesh, const MeshOptions& options,
               std::vector<std::string>& warnings) {
    Scene scene;
    scene.cell = ground_of(options);
    if (!has_day(options)) scene.photons = 1;
    std::optional<Photosynthesis> photosynthesis;
    if (!options.photosynthesis.empty())
        photosynthesis = read_photosynthesis(options.photosynthesis);
    SeriesIllumination light = light_of(options, warnings);
    if (options.scene.empty()) {
        scene.components = {{.name = "",
                             .mesh = std::move(mesh),
                             .photosynthesis = photosynthesis}};
        scene.bands = {{"par",
                        std::move(light),
                        {options.optics.materials(), options.soil_albedo}}};
    } else {
        const MeshScene file = read_mesh_scene(options.scene);
        scene.components =
            SceneBuilder(std::move(mesh), file, warnings).components();
        if (scene.assimilates() && !has_day(options) && !options.beam_ppfd &&
            !options.sky_ppfd)
            throw wrong_usage(
                "{}: photosynthesis needs how strong the light is: "
                "--beam-ppfd, --sky-ppfd, a day with --site and --date, or "
                "--climate",
                options.scene);
        for (std::size_t b = 0; b < file.bands.size(); ++b) {
            Optics optics{{}, file.soil_albedo[b]};
            for (const MeshScene::Matter& each : file.materials)
                optics.materials.push_back(each.bands[b]);
            scene.bands.push_back({file.bands[b],
                                   light_in(file.bands[b], light, options),
                                   std::move(optics)});
        }
    }
    if (options.field)
        for (Component& each : scene.components)
            set_places(each, *options.field);
    return scene;
}

//! Returns an accuracy with at least the number of paths asked for.
Accuracy accuracy_of(const MeshOptions& options) {
    const std::uint64_t paths = options.paths.value_or(most_tolerance_paths);
    const std::uint64_t randomisations =
        std::clamp<std::uint64_t>(paths, 2, usual_randomisations);
    return {static_cast<int>((paths + randomisations - 1) / randomisations),
            static_cast<int>(randomisations),
            options.paths ? 0 : options.tolerance};
}

}  // namespace

MeshReport study(const MeshOptions& options) {
    check(options);
    ObjMesh obj = read_obj(options.path);
    MeshReport result = study(std::move(obj.mesh), options);
    result.warnings.insert(result.warnings.begin(), obj.warnings.begin(),
                           obj.warnings.end());
    return result;
}

MeshReport study(Mesh mesh, const MeshOptions& options) {
    check(options);
    const double plants =
        options.field ? 1.0 * options.field->rows * options.field->plants : 1;
    MeshReport result;
    result.warnings = check_mesh(mesh, plants, ground_of(options), options.sun);
    CanopyRequest request{scene_of(std::move(mesh), options, result.warnings),
                          {0, layers},
                          accuracy_of(options),
                          {options.seed},
                          {.sunlit = true,
                           .faces = options.is_by_face,
                           .exact = options.is_exact}};
    if (request.scene.components.size() > 1 && options.field &&
        options.field->jitter > 0)
        throw wrong_usage(
            "--jitter: components of a mesh cannot turn together; leave it "
            "out");
    result.canopy = evaluate(request, Device(Device::supported_isas().back()));
    return result;
}

}  // namespace ideotype
