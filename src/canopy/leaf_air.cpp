// SPDX-License-Identifier: Apache-2.0
#include "leaf_air.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/physiology/temperature.hpp"

namespace ideotype {

namespace {

constexpr double reference = 10;  //!< height that wind is brought to [m]
constexpr double least_wind = 0.3;
constexpr double von_karman = 0.41;

double displacement(double canopy) {
    return 0.67 * canopy;
}

double roughness(double canopy) {
    return 0.1 * canopy;
}

//! Returns the height of a canopy whose profile does not reach the reference.
double canopy_in_profile(double canopy) {
    return std::clamp(canopy, 0.05, 0.7 * reference);
}

//! Returns the wind at 10 m above short grass, from that at another height.
double wind_at_reference(double wind, double height) {
    const auto profile = [](double z) {
        return std::log(std::max(67.8 * z - 5.42, 2.));
    };
    return std::max(wind * profile(reference) / profile(height), least_wind);
}

double fourth_power(double x) {
    return x * x * x * x;
}

//! Returns the mean light of a source on each place, over the energy of the
//! source [m2 m-2].
std::vector<double> seen(const OtherLight& light, int source,
                         const LeafPlaces& places,
                         const ExpectedLight& expectation) {
    return expectation.of(DiffuseLight(light.tallies, source, places.pieces()));
}

}  // namespace

double wind_at_top(double wind, double height, double canopy) {
    IDEOTYPE_EXPECT(wind >= 0 && height > 0);
    const double h = canopy_in_profile(canopy);
    const double d = displacement(h), z0 = roughness(h);
    return wind_at_reference(wind, height) * std::log((h - d) / z0) /
           std::log((reference - d) / z0);
}

double aerodynamic_resistance(double wind, double height, double canopy) {
    IDEOTYPE_EXPECT(wind >= 0 && height > 0);
    const double h = canopy_in_profile(canopy);
    const double profile =
        std::log((reference - displacement(h)) / roughness(h));
    return profile * profile /
           (von_karman * von_karman * wind_at_reference(wind, height));
}

LeafAir::LeafAir(const WaterLeaves& leaves,
                 std::vector<std::optional<CanopyAir>>& air)
    : leaves_(leaves),
      water_(*leaves.scene.water),
      series_(leaves.scene.light().series),
      has_canopy_air_(water_.has_leaf_temperature && water_.has_canopy_air),
      air_(air) {
    for (const TimeStep& step : series_.steps)
        if (!step.wind || !step.pressure || !step.longwave)
            throw Error(
                "leaves exchange heat and water, but a step of the light has "
                "no wind, pressure or longwave radiation; give each step all");
    air_.resize(series_.steps.size());
}

void LeafAir::see(const LeafPlaces& places, const ExpectedLight& expectation) {
    places_ = &places;
    expectation_ = &expectation;
    at_.assign(places.count(), {});
    sky_ = -1;
    for (std::size_t p = 0; p < places.count(); ++p) {
        at_[p].group = places.group[p];
        at_[p].wind =
            std::exp(-water_.wind_attenuation *
                     (1 - std::min(places.height[p] / leaves_.height, 1.)));
    }
    if (!leaves_.longwave) return;
    const std::vector<Source>& sources =
        leaves_.longwave->band.light.light.sources;
    double energy = 0;
    for (std::size_t s = 0; s < sources.size(); ++s) {
        if (sources[s].direction) continue;
        const std::vector<double> light =
            seen(*leaves_.longwave, static_cast<int>(s), places, expectation);
        for (std::size_t p = 0; p < light.size(); ++p) at_[p].view += light[p];
        energy += sources[s].energy;
    }
    for (Place& place : at_) place.view = energy > 0 ? place.view / energy : 0;
    for (std::size_t p = 0; p < places.count(); ++p) {
        const std::uint32_t material = leaves_.groups[places.group[p]].material;
        at_[p].nir_absorptance =
            leaves_.nir->band.optics.of(material).most_absorbed();
    }
}

void LeafAir::meet(int beam, int sky) {
    const bool is_new_sky = sky != std::exchange(sky_, sky);
    beam_ = beam;
    if (!leaves_.nir) return;
    const auto take = [&](int source, double Place::*into) {
        const std::vector<double> light =
            seen(*leaves_.nir, source, *places_, *expectation_);
        for (std::size_t p = 0; p < light.size(); ++p) at_[p].*into = light[p];
    };
    take(beam, &Place::nir_of_sun);
    // Suns of one sky come one after the other.
    if (is_new_sky) take(sky, &Place::nir_of_sky);
}

LeafAir::Above LeafAir::above(std::size_t number,
                              const Photosynthesis& photosynthesis) const {
    const TimeStep& step = series_.steps[number];
    const Air air = air_of(step, photosynthesis);
    Above result;
    result.air.temperature = air.temperature;
    result.air.humidity = air.humidity;
    result.air.co2 = series_.co2;
    result.air.pressure = step.pressure.value();
    result.air.wind =
        wind_at_top(step.wind.value(), series_.wind_height, leaves_.height);
    result.vapour = air.humidity * saturated_vapour(air.temperature);
    result.sky = step.longwave.value();
    if (!leaves_.nir) return result;
    const auto scale = [&](int source, double irradiance) {
        if (source < 0) return 0.;
        const double energy = leaves_.nir->band.light.light
                                  .sources[static_cast<std::size_t>(source)]
                                  .energy;
        return energy > 0 ? irradiance / energy : 0;
    };
    result.nir_of_sun = scale(beam_, step.nir.beam);
    result.nir_of_sky = scale(sky_, step.nir.diffuse);
    result.nir_beam = step.nir.beam;
    return result;
}

LeafAir::LeafInAir LeafAir::leaf_in(const Above& above,
                                    std::uint32_t group) const {
    const LeafRates& rates = leaves_.leaves[group].rates;
    const Component& component =
        leaves_.scene.components[leaves_.groups[group].id.component];
    const Air air{above.air.temperature, above.air.humidity};
    LeafInAir result{
        {{}, component.stomata, water_.emissivity, water_.stomatal_ratio},
        response(rates, air),
        dark_respiration(rates, air.temperature),
        leaves_.widths[group]};
    if (const auto* c4 = std::get_if<CollatzLeaf>(&rates))
        result.leaf.rates = *c4;
    if (const auto* c3 = std::get_if<FarquharLeaf>(&rates))
        result.leaf.rates = *c3;
    return result;
}

std::array<Expansion, leaf_fluxes> LeafAir::of_own_temperature(
    const Point& point, const LeafInAir& leaf, const Above& above,
    LeafSurroundings around) {
    const Place& place = at_[point.place];
    around.ppfd = point.ppfd;
    around.nir = above.nir_of_sun * place.nir_of_sun +
                 above.nir_of_sky * place.nir_of_sky +
                 place.nir_absorptance * above.nir_beam * point.cosine;
    const double black =
        stefan_boltzmann * fourth_power(around.temperature + kelvin);
    around.longwave =
        water_.emissivity * (2 * black + place.view * (above.sky - black));
    around.wind *= place.wind;
    around.width = leaf.width;
    last_ = leaf_exchange(leaf.leaf, around, last_ ? &*last_ : nullptr);
    const LeafExchange& found = *last_;
    return {Expansion{found.net.value + leaf.respiration, found.net.slope,
                      found.net.curvature},
            found.transpiration,
            {found.sensible, 0, 0},
            {found.temperature - above.air.temperature, 0, 0},
            {found.conductance, 0, 0},
            {found.temperature > water_.hot ? 1. : 0., 0, 0}};
}

std::array<Expansion, leaf_fluxes> LeafAir::of_air_temperature(
    const Point& point, const LeafInAir& leaf,
    const LeafSurroundings& around) const {
    Expansion gross{};
    expand(leaf.response, {&point.ppfd, 1}, &gross.value, &gross.slope,
           &gross.curvature);
    const LeafExchange found = exchange_at_air_temperature(
        leaf.leaf.stomata, around,
        {gross.value - leaf.respiration, gross.slope, gross.curvature});
    return {gross,
            found.transpiration,
            {},
            {},
            {found.conductance, 0, 0},
            {found.temperature > water_.hot ? 1. : 0., 0, 0}};
}

void LeafAir::exchange_in(std::size_t step, const CanopyAir& air) {
    found_.assign(points_.size(), {});
    last_.reset();
    const Photosynthesis* of = nullptr;
    std::optional<std::uint32_t> last_group;
    Above over;
    LeafSurroundings around;
    LeafInAir leaf;
    for (std::size_t j = 0; j < points_.size(); ++j) {
        const std::uint32_t group = at_[points_[j].place].group;
        const Photosynthesis* own = leaves_.leaves[group].photosynthesis;
        if (!own) continue;
        if (own != of) {
            of = own;
            over = above(step, *of);
            around = over.air;
            around.temperature += air.warmer;
            if (air.warmer != 0 || air.moister != 0)
                around.humidity =
                    std::clamp((over.vapour + air.moister) /
                                   saturated_vapour(around.temperature),
                               0., 1.);
        }
        if (group != last_group) {
            leaf = leaf_in(over, group);
            last_group = group;
        }
        found_[j] = water_.has_leaf_temperature
                        ? of_own_temperature(points_[j], leaf, over, around)
                        : of_air_temperature(points_[j], leaf, around);
    }
}

//! Joins the points of each leaf in the sun, and those in the shade, to one at
//! a place that is their mean.
//! @return the new point that each old one is a part of
std::vector<std::size_t> LeafAir::join_points() {
    std::vector<std::size_t> part_of;
    std::vector<Point> joined;
    std::map<std::pair<bool, std::uint32_t>, std::size_t> known;
    at_.resize(places_->count());
    for (const Point& point : points_) {
        const Place own = at_[point.place];
        const auto [found, is_new] = known.emplace(
            std::pair(point.cosine > 0, own.group), joined.size());
        if (is_new) {
            joined.push_back({at_.size(), 0, 0, 0});
            at_.push_back({own.group, 0, 0});
        }
        part_of.push_back(found->second);
        Point& sum = joined[found->second];
        Place& mean = at_[sum.place];
        const double area = std::max(point.area, 0.);
        sum.area += area;
        if (!(sum.area > 0)) continue;
        // Means grow point by point.
        const double part = area / sum.area;
        const auto join = [&](double& x, double more) {
            x += part * (more - x);
        };
        join(sum.ppfd, point.ppfd);
        join(sum.cosine, point.cosine);
        join(mean.view, own.view);
        join(mean.wind, own.wind);
        join(mean.nir_of_sun, own.nir_of_sun);
        join(mean.nir_of_sky, own.nir_of_sky);
        join(mean.nir_absorptance, own.nir_absorptance);
    }
    points_ = std::move(joined);
    return part_of;
}

//! Solves the exchange of the canopy with the air above for the air within, by
//! a secant of both numbers.
CanopyAir LeafAir::canopy_air(std::size_t number) {
    const TimeStep& step = series_.steps[number];
    const double resistance = aerodynamic_resistance(
        step.wind.value(), series_.wind_height, leaves_.height);
    const auto leaf = std::find_if(
        leaves_.leaves.begin(), leaves_.leaves.end(),
        [](const LeafGroup& each) { return each.photosynthesis != nullptr; });
    if (leaf == leaves_.leaves.end()) return {};
    const Air air = air_of(step, *leaf->photosynthesis);
    const double per_volume =
        step.pressure.value() / (gas_constant * (air.temperature + kelvin));
    const double per_heat = resistance / (per_volume * air_heat_capacity);
    const double per_water =
        1e-3 * step.pressure.value() * resistance / per_volume;
    const auto driven = [&](const CanopyAir& in) {
        exchange_in(number, in);
        CanopyAir sum;
        for (std::size_t j = 0; j < points_.size(); ++j) {
            const auto& flux = found_[j];
            sum.warmer +=
                points_[j].area *
                flux[static_cast<std::size_t>(LeafFlux::sensible)].value;
            sum.moister +=
                points_[j].area *
                flux[static_cast<std::size_t>(LeafFlux::transpiration)].value;
        }
        return CanopyAir{per_heat * sum.warmer, per_water * sum.moister};
    };
    const CanopyAir first = driven({});
    // Steps of about the size of the answer.
    const double dt = std::copysign(
        std::clamp(std::abs(first.warmer) / 2, 0.1, 2.), first.warmer);
    const double de = std::copysign(
        std::clamp(std::abs(first.moister) / 2, 0.02, 0.5), first.moister);
    const CanopyAir warm = driven({dt, 0}), moist = driven({0, de});
    const double a = (warm.warmer - first.warmer) / dt - 1;
    const double b = (moist.warmer - first.warmer) / de;
    const double c = (warm.moister - first.moister) / dt;
    const double d = (moist.moister - first.moister) / de - 1;
    const double determinant = a * d - b * c;
    if (!(std::abs(determinant) > 1e-9)) return {};
    constexpr double most_warmer = 8, most_moister = 2;
    return {std::clamp((b * first.moister - d * first.warmer) / determinant,
                       -most_warmer, most_warmer),
            std::clamp((c * first.warmer - a * first.moister) / determinant,
                       -most_moister, most_moister)};
}

void LeafAir::exchange(std::size_t step) {
    IDEOTYPE_EXPECT(places_ != nullptr && step < air_.size());
    if (has_canopy_air_ && !air_[step]) {
        std::vector<Point> all = points_;
        join_points();
        air_[step] = canopy_air(step);
        points_ = std::move(all);
    }
    exchange_in(step, air_[step].value_or(CanopyAir{}));
}

void LeafAir::exchange_at_night(std::size_t step) {
    IDEOTYPE_EXPECT(places_ != nullptr && step < air_.size());
    const std::vector<std::size_t> part_of = join_points();
    if (has_canopy_air_ && !air_[step]) air_[step] = canopy_air(step);
    exchange_in(step, air_[step].value_or(CanopyAir{}));
    std::vector<std::array<Expansion, leaf_fluxes>> joined;
    std::swap(joined, found_);
    for (const std::size_t part : part_of) found_.push_back(joined[part]);
}

}  // namespace ideotype
