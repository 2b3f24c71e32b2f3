#include "ideotype/app/mesh_study.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "ideotype/app/progress.hpp"
#include "ideotype/light/device.hpp"
#include "ideotype/light/sunlit.hpp"
#include "ideotype/plant/obj_reader.hpp"

namespace ideotype {

namespace {

//! Errors come from this many independent repetitions: enough to know them
//! to an eighth.
constexpr std::uint64_t usual_randomisations = 32;

//! Where a tolerance begins.
constexpr std::uint64_t first_paths = 16384;

//! Layers of equal thickness up to the top of the canopy.
constexpr std::size_t layers = 10;

//! A mesh on its ground.
struct Stand {
    Mesh mesh;
    double period_x = 0;     //!< [m]; 0 if it does not repeat
    double period_y = 0;     //!< [m]
    double ground_area = 0;  //!< [m2]
};

//! A single light is that of a second.
Day day_of(const MeshOptions& options) {
    constexpr double par_fraction = 0.45;
    if (options.site)
        return clear_day(*options.site, {*options.date, 0, 24, 60},
                         par_fraction);
    const Irradiance one = options.sky ? Irradiance{0, 1} : Irradiance{1, 0};
    return {{{0, 1, options.sun.value_or(SunPosition{}), one}}};
}

//! Beyond this many faces a stand needs more memory than most computers have.
constexpr double most_faces = 2e7;

Stand stand_of(Mesh mesh, const MeshOptions& options) {
    Stand stand;
    if (options.field) {
        const FieldForm& form = *options.field;
        const double plants = 1.0 * form.rows * form.plants;
        if (plants * static_cast<double>(mesh.faces.size()) > most_faces)
            throw Error(
                fmt::format("a field of {} plants of {} faces is too "
                            "large (at most {:.0e} faces)",
                            plants, mesh.faces.size(), most_faces));
        Field field =
            build_field(mesh, form, draw_turns(form, options.seed, 0, 0));
        stand = {std::move(field.mesh), field.period_x, field.period_y,
                 field.ground_area()};
    } else {
        stand.mesh = std::move(mesh);
        if (options.period)
            stand = {std::move(stand.mesh), options.period->x,
                     options.period->y, options.period->x * options.period->y};
    }
    if (options.ground_area) stand.ground_area = *options.ground_area;
    return stand;
}

//! Faces much larger than the period have very many images in the cell.
void check_images(const Stand& stand) {
    double images = 0;
    for (const auto& face : stand.mesh.faces) {
        const auto count = [&](double Vec3::*axis, double period) {
            const auto [least, largest] =
                std::minmax({stand.mesh.vertices[face[0]].*axis,
                             stand.mesh.vertices[face[1]].*axis,
                             stand.mesh.vertices[face[2]].*axis,
                             stand.mesh.vertices[face[3]].*axis});
            return 1 + (largest - least) / period;
        };
        images +=
            count(&Vec3::x, stand.period_x) * count(&Vec3::y, stand.period_y);
    }
    if (!(images <= most_faces))
        throw Error(fmt::format(
            "the mesh covers its period of {} x {} m so often that {:.1e} "
            "faces would be needed (at most {:.0e}); is it in metres?",
            stand.period_x, stand.period_y, images, most_faces));
}

Scene scene_of(const Device& device, const Stand& stand, Boundary boundary) {
    if (boundary == Boundary::isolated)
        return Scene::isolated(device, stand.mesh, stand.ground_area);
    check_images(stand);
    return Scene(device, stand.mesh, stand.period_x, stand.period_y);
}

//! At least this many paths in all.
Sampling share(std::uint64_t paths) {
    const std::uint64_t randomisations =
        std::clamp<std::uint64_t>(paths, 2, usual_randomisations);
    return {static_cast<int>(
                std::bit_ceil((paths + randomisations - 1) / randomisations)),
            static_cast<int>(randomisations)};
}

std::uint64_t paths_of(const Sampling& sampling) {
    return static_cast<std::uint64_t>(sampling.paths) *
           static_cast<std::uint64_t>(sampling.randomisations);
}

double relative_error(const BudgetEstimate& budget) {
    const Estimate& leaves = budget.leaves;
    return leaves.standard_error > 0 ? leaves.standard_error / leaves.mean : 0;
}

}  // namespace

MeshReport study(const MeshOptions& options) {
    check(options);
    const double began = now();
    const Day day = day_of(options);
    const DayIllumination illumination =
        illuminate(day, options.sky.value_or(SkyModel::uniform), 0);
    ObjMesh obj = read_obj(options.path);
    MeshReport result;
    result.warnings = std::move(obj.warnings);
    const Stand stand = stand_of(std::move(obj.mesh), options);
    CanopyReport& canopy = result.canopy;
    canopy.groups = stand.mesh.groups;
    canopy.boundary = options.boundary;
    canopy.ground_area = stand.ground_area;
    canopy.lai = leaf_area(stand.mesh) / stand.ground_area;

    const Device device(Device::supported_isas().back());
    const Scene scene = scene_of(device, stand, options.boundary);
    canopy.layers = {scene.top() / layers, layers};
    const Optics optics{options.leaf, {}, options.soil_albedo};
    const Randomness randomness{options.seed, 0, 0};
    const std::uint64_t least_paths =
        usual_randomisations * illumination.light.sources.size();
    Sampling sampling;
    for (std::uint64_t paths =
             options.paths.value_or(std::max(first_paths, least_paths));
         ; paths = 2 * result.paths) {
        sampling = share(paths);
        result.paths = paths_of(sampling);
        canopy.light = report(
            simulate(scene, stand.mesh.groups, optics, illumination.light,
                     sampling, randomness, canopy.layers),
            illumination, day);
        result.relative_error = relative_error(canopy.light.day);
        if (options.paths || result.relative_error <= options.tolerance ||
            2 * result.paths > most_tolerance_paths)
            break;
    }
    add_sunlit(canopy.light,
               sunlit_fractions(scene, stand.mesh, illumination.light,
                                sunlit_sampling(sampling), randomness),
               illumination);
    result.seconds = now() - began;
    return result;
}

}  // namespace ideotype
