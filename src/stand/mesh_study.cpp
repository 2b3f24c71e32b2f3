// SPDX-License-Identifier: Apache-2.0
#include "mesh_study.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "campaign/campaign.hpp"
#include "ideotype/crop/obj_reader.hpp"
#include "ideotype/light/device.hpp"

namespace ideotype {

namespace {

//! Errors come from this many independent repetitions: enough to know them
//! to an eighth.
constexpr std::uint64_t usual_randomisations = 32;

constexpr std::size_t layers = 10;

//! A single light is that of a second.
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
    constexpr double north = 0;  // the mesh's y axis
    //! Of a season: more than a campaign has, which only compares plants.
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

constexpr double most_faces = most_obj_faces;

//! Crops are lower [m].
constexpr double usual_height = 20;

//! Light may have to cross a periodic cell this often to get through.
constexpr double most_crossings = 1000;

Field field_of(Mesh mesh, const MeshOptions& options) {
    Field field;
    if (options.field) {
        const FieldForm& form = *options.field;
        const double plants = 1.0 * form.rows * form.plants;
        if (plants * static_cast<double>(mesh.faces.size()) > most_faces)
            throw Error(
                fmt::format("a field of {} plants of {} faces is too "
                            "large (at most {:.0e} faces)",
                            plants, mesh.faces.size(), most_faces));
        field = draw_field(mesh, form, {options.seed});
    } else {
        field.mesh = std::move(mesh);
        if (options.period) {
            field.period_x = options.period->x;
            field.period_y = options.period->y;
            field.ground_area = field.period_x * field.period_y;
        }
    }
    field.boundary = options.boundary;
    if (options.ground_area) field.ground_area = *options.ground_area;
    return field;
}

//! Faces much larger than the period have very many images in the cell.
void check_images(const Field& field) {
    double images = 0;
    for (const auto& face : field.mesh.faces) {
        const auto count = [&](double glm::dvec3::*axis, double period) {
            const auto [least, largest] =
                std::minmax({field.mesh.vertices[face[0]].*axis,
                             field.mesh.vertices[face[1]].*axis,
                             field.mesh.vertices[face[2]].*axis,
                             field.mesh.vertices[face[3]].*axis});
            return 1 + (largest - least) / period;
        };
        images += count(&glm::dvec3::x, field.period_x) *
                  count(&glm::dvec3::y, field.period_y);
    }
    if (!(images <= most_faces))
        throw Error(fmt::format(
            "the mesh covers its period of {} x {} m so often that {:.1e} "
            "faces would be needed (at most {:.0e}); is it in metres?",
            field.period_x, field.period_y, images, most_faces));
}

//! Heights of the lowest and the highest face, and of the soil [m].
Range heights(const Mesh& mesh) {
    Range all{0, 0};
    for (const auto& face : mesh.faces)
        for (const std::uint32_t vertex : face) {
            const double z = mesh.vertices[vertex].z;
            all = {std::min(all.lower, z), std::max(all.upper, z)};
        }
    return all;
}

//! Light would have to fall almost for ever to meet so few faces, or to get
//! out of so many.
void check_area(const Field& field) {
    constexpr double least = 1e-6, most = 1e4;
    double area = 0;
    for (const double each : face_areas(field.mesh)) area += each;
    const bool is_much = area > most * field.ground_area;
    if (is_much || (field.boundary == Boundary::periodic &&
                    area < least * field.ground_area))
        throw Error(fmt::format(
            "the mesh has {:.2g} m2 over {:.4g} m2 of ground (the {} is {:.0e} "
            "of it); is it in metres?",
            area, field.ground_area, is_much ? "most" : "least",
            is_much ? most : least));
}

//! Light would take almost for ever through a tower in a narrow cell.
void check_height(const Field& field, double height) {
    const double period = std::min(field.period_x, field.period_y);
    if (height > most_crossings * period)
        throw Error(fmt::format(
            "the mesh is {:.6g} m high over a period of {:.6g} m (the limit is "
            "{:.0f} times the period); is it in metres?",
            height, period, most_crossings));
}

//! At least as many paths as asked for.
Accuracy accuracy_of(const MeshOptions& options) {
    const std::uint64_t paths = options.paths.value_or(most_tolerance_paths);
    const std::uint64_t randomisations =
        std::clamp<std::uint64_t>(paths, 2, usual_randomisations);
    return {static_cast<int>((paths + randomisations - 1) / randomisations),
            static_cast<int>(randomisations),
            options.paths ? 0 : options.tolerance};
}

CanopyRequest to_request(const MeshOptions& options, Field field,
                         std::vector<std::string>& warnings) {
    Details details{
        .sunlit = true, .faces = options.is_by_face, .exact = options.is_exact};
    if (!options.photosynthesis.empty()) {
        details.photosynthesis = read_photosynthesis(options.photosynthesis);
        if (!has_day(options)) details.photosynthesis->photons = 1;
    }
    return {
        std::move(field),
        {{},
         light_of(options, warnings),
         {options.leaf, options.stalk, options.soil_albedo, options.sheath}},
        {0, layers},
        accuracy_of(options),
        {options.seed},
        details};
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
    MeshReport result;
    Field field = field_of(std::move(mesh), options);
    const auto [bottom, top] = heights(field.mesh);
    constexpr double below = -1e-3;  // more than rounding
    if (bottom < below)
        result.warnings.push_back(
            fmt::format("the mesh reaches {:.4g} m below the soil (z = 0), "
                        "where there is no light; lift it",
                        -bottom));
    if (top > usual_height)
        result.warnings.push_back(fmt::format(
            "the mesh is {:.4g} m high (coordinates are taken as metres); if "
            "they are centimetres, divide them by 100",
            top));
    check_area(field);
    if (field.boundary == Boundary::periodic) {
        check_images(field);
        check_height(field, top);
    }
    result.canopy =
        evaluate(to_request(options, std::move(field), result.warnings),
                 Device(Device::supported_isas().back()));
    return result;
}

}  // namespace ideotype
