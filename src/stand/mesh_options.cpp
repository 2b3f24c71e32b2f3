// SPDX-License-Identifier: Apache-2.0
#include "mesh_options.hpp"

#include <cmath>
#include <initializer_list>
#include <utility>

#include <fmt/format.h>

#include "spec/problems.hpp"

namespace ideotype {

namespace {

template <class... Args>
void require(bool holds, fmt::format_string<Args...> text, Args&&... args) {
    if (!holds) throw wrong_usage(text, std::forward<Args>(args)...);
}

bool is_positive(double x) {
    return x > 0;
}

bool is_fraction(double x) {
    return x >= 0 && x <= 1;
}

//! Refuses numbers that are NaN or infinite, which ranges would not name.
void check_finite(const std::string& option,
                  std::initializer_list<double> values) {
    for (const double value : values)
        require(std::isfinite(value),
                "{}: {} is not a finite number; correct it", option, value);
}

void check_finite(const std::string& material, const Lambertian& surface) {
    check_finite(material + "-reflectance", {surface.reflectance});
    check_finite(material + "-transmittance", {surface.transmittance});
}

void check_numbers(const MeshOptions& options) {
    const auto& [period, area] = std::tie(options.period, options.ground_area);
    if (period) check_finite("--period", {period->x, period->y});
    if (area) check_finite("--ground-area", {*area});
    if (const auto& field = options.field) {
        check_finite("--field", {field->spacing.row, field->spacing.plant});
        check_finite("--jitter", {field->jitter});
    }
    if (const auto& sun = options.sun)
        check_finite("--sun", {90 - sun->zenith, sun->azimuth});
    if (const auto& site = options.site)
        check_finite("--site",
                     {site->latitude, site->longitude, site->utc_offset});
    check_finite("--beam-ppfd", {options.beam_ppfd.value_or(0)});
    check_finite("--sky-ppfd", {options.sky_ppfd.value_or(0)});
    check_finite("--leaf", options.optics.leaf);
    check_finite("--stalk", options.optics.stalk);
    check_finite("--sheath", options.optics.sheath);
    check_finite("--soil-albedo", {options.soil_albedo});
    check_finite("--tolerance", {options.tolerance});
}

void check_field(const FieldForm& field) {
    constexpr double most_plants = 1e6;
    require(field.rows >= 1 && field.plants >= 1 &&
                1.0 * field.rows * field.plants <= most_plants,
            "--field: from one to a million plants");
    require(is_positive(field.spacing.row) && is_positive(field.spacing.plant),
            "--field: spacings must be positive [m]");
    require(field.jitter >= 0 && field.jitter <= 180,
            "--jitter: a turn from 0 to 180 degrees");
}

void check_ground(const MeshOptions& options) {
    const auto& [period, area] = std::tie(options.period, options.ground_area);
    if (period)
        require(is_positive(period->x) && is_positive(period->y),
                "--period: both lengths must be positive [m]");
    if (area)
        require(is_positive(*area), "--ground-area: must be positive [m2]");
    if (options.boundary == Boundary::isolated) {
        require(area || options.field,
                "--boundary isolated needs --ground-area, the area of ground "
                "that fractions refer to");
        return;
    }
    require(period || options.field,
            "--period X Y is missing (the lattice on which the mesh repeats; "
            "the extent of the mesh does not tell it)");
    if (!area || !period) {
        require(!area, "--ground-area: a field has the area of its spacings");
        return;
    }
    const double cell = period->x * period->y;
    require(std::abs(*area - cell) <= 1e-6 * cell,
            "--ground-area {} contradicts --period, which spans {:.6g} m2",
            *area, cell);
}

void check_site(const Site& site, const Date& date) {
    require(std::abs(site.latitude) <= 90, "--site: latitude is -90 to 90");
    require(std::abs(site.longitude) <= 180,
            "--site: longitude is -180 to 180");
    require(site.utc_offset >= -12 && site.utc_offset <= 14,
            "--site: the UTC offset is -12 to 14 h");
    require(date.year >= 1950 && date.year <= 2100,
            "--date: {} is no day from 1950 to 2100", to_string(date));
}

void check_light(const MeshOptions& options) {
    const bool is_clear = options.sky == SkyModel::clear;
    require(options.site.has_value() == options.date.has_value(),
            "--site and --date belong together");
    require(options.sun || options.sky || has_day(options),
            "the light is missing: give --sun, --sky, --site with --date, or "
            "--climate");
    require(options.climate.empty() || !(options.site || options.sun ||
                                         options.beam_ppfd || options.sky_ppfd),
            "--climate has all light of a season; leave out --site, --sun, "
            "--beam-ppfd and --sky-ppfd");
    require(!options.site || !options.sun,
            "--sun and --site are two lights; give one");
    require(options.beam_ppfd.has_value() == options.sky_ppfd.has_value() ||
                !options.sun || !options.sky,
            "--sun and --sky together need --beam-ppfd and --sky-ppfd");
    require(!options.sun || !options.sky || is_clear || options.beam_ppfd,
            "--sun and --sky are two lights; give one, or how strong each is: "
            "--beam-ppfd and --sky-ppfd");
    require(!options.beam_ppfd || options.sun,
            "--beam-ppfd needs the position of the sun: --sun");
    require(!options.sky_ppfd || options.sky,
            "--sky-ppfd needs a sky: --sky uniform, overcast or clear");
    require(options.beam_ppfd || options.sky_ppfd || has_day(options) ||
                options.photosynthesis.empty(),
            "--photosynthesis needs how strong the light is: --beam-ppfd, "
            "--sky-ppfd, a day with --site and --date, or --climate");
    require(options.scene.empty() || options.photosynthesis.empty(),
            "--scene tells the photosynthesis of each component; leave out "
            "--photosynthesis");
    require(!options.is_exact || !options.photosynthesis.empty() ||
                !options.scene.empty(),
            "--exact is a way to find assimilation; it needs --photosynthesis");
    for (const auto& [name, ppfd] :
         {std::pair("--beam-ppfd", options.beam_ppfd),
          std::pair("--sky-ppfd", options.sky_ppfd)})
        require(!ppfd || (*ppfd >= 0 && *ppfd <= 1e5),
                "{}: from 0 to 100000 umol m-2 s-1", name);
    require(options.beam_ppfd.value_or(0) + options.sky_ppfd.value_or(0) > 0 ||
                !(options.beam_ppfd || options.sky_ppfd),
            "--beam-ppfd and --sky-ppfd: there is no light");
    require(!options.site || !(options.beam_ppfd || options.sky_ppfd),
            "--site has the light of a clear day; leave out --beam-ppfd and "
            "--sky-ppfd");
    require(!is_clear || options.sun || has_day(options),
            "--sky clear needs the position of the sun: --sun");
    if (options.site) check_site(*options.site, *options.date);
    if (!options.sun) return;
    const double elevation = 90 - options.sun->zenith;
    require(elevation > 0, "--sun: the sun is not above the horizon");
    require(elevation <= 90, "--sun: the elevation is at most 90");
    require(std::abs(options.sun->azimuth) <= 360,
            "--sun: the azimuth is -360 to 360, clockwise from north");
}

void check_surface(const std::string& name, const Lambertian& surface) {
    const auto& [reflectance, transmittance] = surface;
    require(is_fraction(reflectance), "{}-reflectance: from 0 to 1", name);
    require(is_fraction(transmittance), "{}-transmittance: from 0 to 1", name);
    require(reflectance + transmittance <= 1 + 1e-12,
            "{0}-reflectance and {0}-transmittance exceed 1 together", name);
}

void check_optics(const MeshOptions& options) {
    check_surface("--leaf", options.optics.leaf);
    check_surface("--stalk", options.optics.stalk);
    check_surface("--sheath", options.optics.sheath);
    require(is_fraction(options.soil_albedo), "--soil-albedo: from 0 to 1");
}

}  // namespace

void check(const MeshOptions& options) {
    check_numbers(options);
    require(!options.period || !options.field,
            "--period and --field contradict each other: the period of a "
            "field is that of its plants");
    if (options.field) check_field(*options.field);
    check_ground(options);
    check_light(options);
    check_optics(options);
    require(is_positive(options.tolerance), "--tolerance: must be positive");
    constexpr std::uint64_t most_paths = std::uint64_t{1} << 32;
    if (options.paths)
        require(*options.paths >= 1 && *options.paths <= most_paths,
                "--paths: from 1 to {}", most_paths);
}

}  // namespace ideotype
