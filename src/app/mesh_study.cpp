#include "ideotype/app/mesh_study.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "ideotype/app/progress.hpp"
#include "ideotype/light/device.hpp"
#include "ideotype/light/scene.hpp"
#include "ideotype/light/transport.hpp"
#include "ideotype/plant/obj_reader.hpp"

namespace ideotype {

namespace {

//! Errors come from this many independent repetitions: enough to know them
//! to an eighth.
constexpr std::uint64_t usual_randomisations = 32;

//! A mesh on its ground.
struct Stand {
    Mesh mesh;
    double period_x = 0;     //!< [m]; 0 if it does not repeat
    double period_y = 0;     //!< [m]
    double ground_area = 0;  //!< [m2]
};

//! The light, and the day that it belongs to; no steps for a single light.
struct MeshLight {
    DayIllumination illumination;
    Day day;
};

MeshLight light_of(const MeshOptions& options) {
    if (options.site) {
        constexpr double par_fraction = 0.45;
        const Day day =
            clear_day(*options.site, {*options.date, 0, 24, 60}, par_fraction);
        return {illuminate(day, options.sky.value_or(SkyModel::uniform), 0),
                day};
    }
    const SunPosition sun = options.sun.value_or(SunPosition{});
    if (options.sky)
        return {{{{{std::nullopt, 1.0, {*options.sky, sun}}}}, {}, {}}, {}};
    return {{{{{beam_direction(sun), 1.0, {}}}}, {}, {}}, {}};
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

Scene scene_of(const Device& device, const Stand& stand,
               MeshOptions::Boundary boundary) {
    if (boundary == MeshOptions::Boundary::isolated)
        throw Error(
            "--boundary isolated is not yet supported; use --boundary "
            "periodic");
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
    const MeshLight light = light_of(options);
    const Illumination& sources = light.illumination.light;
    ObjMesh obj = read_obj(options.path);
    MeshReport result;
    result.warnings = std::move(obj.warnings);
    const Stand stand = stand_of(std::move(obj.mesh), options);
    result.groups = stand.mesh.groups;
    result.ground_area = stand.ground_area;
    result.lai = leaf_area(stand.mesh) / stand.ground_area;

    const Device device(Device::supported_isas().back());
    const Scene scene = scene_of(device, stand, options.boundary);
    const Optics optics{options.leaf, {}, options.soil_albedo};
    constexpr std::uint64_t first_paths = 16384;
    const std::uint64_t least_paths =
        usual_randomisations * sources.sources.size();
    for (std::uint64_t paths =
             options.paths.value_or(std::max(first_paths, least_paths));
         ; paths = 2 * result.paths) {
        const Sampling sampling = share(paths);
        result.paths = paths_of(sampling);
        result.light = report(simulate(scene, stand.mesh.groups, optics,
                                       sources, sampling, {options.seed, 0, 0}),
                              light.illumination, light.day);
        result.relative_error = relative_error(result.light.day);
        if (options.paths || result.relative_error <= options.tolerance ||
            2 * result.paths > most_tolerance_paths)
            break;
    }
    result.seconds = now() - began;
    return result;
}

}  // namespace ideotype
