// SPDX-License-Identifier: Apache-2.0
#include "leaf_air.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/units.hpp"
#include "ideotype/physiology/temperature.hpp"
#include "wind_profile.hpp"

namespace ideotype {

namespace {

double fourth_power(double x) {
    return x * x * x * x;
}

//! Returns the mean light of a source on each place, divided by the energy of
//! the source [m2 m-2].
std::vector<double> seen(const OtherLight& light, int source,
                         const LeafPlaces& places) {
    return places.expected(
        DiffuseLight(light.tallies, source, places.pieces()));
}

}  // namespace

LeafAir::LeafAir(const WaterLeaves& leaves)
    : leaves_(leaves),
      water_(*leaves.scene.water),
      series_(leaves.scene.light().series) {
    for (const TimeStep& step : series_.steps)
        if (!step.wind || !step.pressure || !step.longwave)
            throw Error(
                "leaves exchange heat and water, but a step of the light has "
                "no wind, pressure or longwave radiation; give each step all");
}

void LeafAir::see(const LeafPlaces& places) {
    IDEOTYPE_EXPECT(places.width.size() == places.count());
    places_ = &places;
    index_.assign(leaves_.leaves.size(), 0);
    sky_ = -1;
    for (std::size_t p = 0; p < places.count(); ++p)
        index_[places.group[p]] += places.index[p];
    find_classes();
    at_.assign(places.count() + classes(), {});
    for (std::size_t p = 0; p < places.count(); ++p) {
        at_[p].group = places.group[p];
        at_[p].width = places.width[p];
        at_[p].wind =
            std::exp(-water_.wind_attenuation *
                     (1 - std::min(places.height[p] / leaves_.height, 1.)));
    }
    for (std::uint32_t c = 0; c < classes(); ++c)
        at_[mean_place(c)].group = largest_of(c).value_or(0);
    if (leaves_.longwave) {
        const std::vector<Source>& sources =
            leaves_.longwave->band.light.light.sources;
        double energy = 0;
        for (std::size_t s = 0; s < sources.size(); ++s) {
            if (sources[s].direction) continue;
            const std::vector<double> light =
                seen(*leaves_.longwave, static_cast<int>(s), places);
            for (std::size_t p = 0; p < light.size(); ++p)
                at_[p].view += light[p];
            energy += sources[s].energy;
        }
        for (Place& place : at_)
            place.view = energy > 0 ? place.view / energy : 0;
    }
    if (leaves_.nir)
        for (std::size_t p = 0; p < places.count(); ++p)
            at_[p].nir_absorptance =
                leaves_.nir->band.optics
                    .of(leaves_.groups[places.group[p]].material)
                    .most_absorbed();
    take_means(
        {&Place::view, &Place::wind, &Place::width, &Place::nir_absorptance});
}

//! Divides the assimilating leaves of each component into classes with similar
//! total leaf area.
void LeafAir::find_classes() {
    constexpr std::uint32_t most = classes_per_component;
    const std::size_t components = leaves_.scene.components.size();
    std::vector<double> all(components), below(components);
    const auto for_each = [&](const auto& take) {
        for (std::uint32_t g = 0; g < index_.size(); ++g)
            if (leaves_.leaves[g].exchanges_water() && index_[g] > 0)
                take(g, leaves_.groups[g].id.component);
    };
    for_each([&](std::uint32_t g, std::uint32_t of) { all[of] += index_[g]; });
    class_.assign(index_.size(), 0);
    means_.assign(most * components, {});
    for_each([&](std::uint32_t g, std::uint32_t of) {
        const double middle = (below[of] + index_[g] / 2) / all[of];
        below[of] += index_[g];
        class_[g] = most * of + static_cast<std::uint32_t>(most * middle);
        Mean& mean = means_[class_[g]];
        mean.area += index_[g];
        if (!mean.largest || index_[g] > index_[*mean.largest])
            mean.largest = g;
    });
}

//! Assigns each class's mean place the averages of its places, weighted by leaf
//! area.
void LeafAir::take_means(std::initializer_list<double Place::*> parts) {
    for (double Place::*const part : parts) {
        for (std::uint32_t c = 0; c < classes(); ++c)
            at_[mean_place(c)].*part = 0;
        for (std::size_t p = 0; p < places_->count(); ++p) {
            const std::uint32_t g = at_[p].group, of = class_[g];
            if (leaves_.leaves[g].exchanges_water() && means_[of].area > 0)
                at_[mean_place(of)].*part +=
                    places_->index[p] / means_[of].area * at_[p].*part;
        }
    }
}

void LeafAir::meet(int beam, int sky) {
    const bool is_new_sky = sky != std::exchange(sky_, sky);
    beam_ = beam;
    if (!leaves_.nir) return;
    const auto take = [&](int source, double Place::*into) {
        const std::vector<double> light = seen(*leaves_.nir, source, *places_);
        for (std::size_t p = 0; p < light.size(); ++p) at_[p].*into = light[p];
        take_means({into});
    };
    take(beam, &Place::nir_of_sun);
    // Suns with the same sky are consecutive.
    if (is_new_sky) take(sky, &Place::nir_of_sky);
}

void LeafAir::begin(std::size_t number) {
    IDEOTYPE_EXPECT(places_ != nullptr && number < series_.steps.size());
    const TimeStep& step = series_.steps[number];
    step_ = number;
    light_ = {
        step.longwave.value(),
        wind_at_top(step.wind.value(), series_.wind_height, leaves_.height)};
    resistance_ = aerodynamic_resistance(step.wind.value(), series_.wind_height,
                                         leaves_.height);
    if (leaves_.nir) {
        const auto scale = [&](int source, double irradiance) {
            if (source < 0) return 0.;
            const double energy = leaves_.nir->band.light.light
                                      .sources[static_cast<std::size_t>(source)]
                                      .energy;
            return energy > 0 ? irradiance / energy : 0;
        };
        light_.nir_of_sun = scale(beam_, step.nir.beam);
        light_.nir_of_sky = scale(sky_, step.nir.diffuse);
        light_.nir_beam = step.nir.beam;
    }
    leaf_.clear();
    for (std::uint32_t g = 0; g < leaves_.leaves.size(); ++g) {
        leaf_.emplace_back();
        if (leaves_.leaves[g].exchanges_water() && index_[g] > 0)
            leaf_.back() = leaf_in(number, g);
    }
    set_air({});
}

LeafAir::Leaf LeafAir::leaf_in(std::size_t number, std::uint32_t group) const {
    const TimeStep& step = series_.steps[number];
    const LeafGroup& of = leaves_.leaves[group];
    const Component& component =
        leaves_.scene.components[leaves_.groups[group].id.component];
    const Air air = air_of(step, *of.photosynthesis);
    Leaf result{{{},
                 closed(component.stomata, step.opening),
                 leaf_emissivity,
                 water_.stomatal_ratio},
                {},
                air.humidity * saturated_vapour(air.temperature),
                dark_respiration(of.rates, air.temperature)};
    result.above.temperature = air.temperature;
    result.above.humidity = air.humidity;
    result.above.co2 = series_.co2;
    result.above.pressure = step.pressure.value();
    result.above.wind = light_.wind;
    if (const auto* c4 = std::get_if<CollatzLeaf>(&of.rates))
        result.leaf.rates = *c4;
    if (const auto* c3 = std::get_if<FarquharLeaf>(&of.rates))
        result.leaf.rates = *c3;
    return result;
}

void LeafAir::close_stomata(double opening) {
    for (std::uint32_t g = 0; g < leaf_.size(); ++g)
        if (leaf_[g])
            leaf_[g]->leaf.stomata =
                closed(leaves_.scene.components[leaves_.groups[g].id.component]
                           .stomata,
                       opening * series_.steps[step_].opening);
}

void LeafAir::set_air(const CanopyAir& air) {
    const Leaf* last = nullptr;
    for (std::optional<Leaf>& leaf : leaf_) {
        if (!leaf) continue;
        leaf->within = leaf->above;
        leaf->within.temperature += air.warmer;
        if (last && last->within.temperature == leaf->within.temperature &&
            last->vapour == leaf->vapour) {
            leaf->within.humidity = last->within.humidity;
            leaf->black = last->black;
        } else {
            if (air.warmer != 0 || air.moister != 0)
                leaf->within.humidity =
                    std::clamp((leaf->vapour + air.moister) /
                                   saturated_vapour(leaf->within.temperature),
                               0., 1.);
            leaf->black = stefan_boltzmann *
                          fourth_power(leaf->within.temperature + kelvin);
        }
        last = &*leaf;
    }
}

CanopyAir LeafAir::driven_by(std::uint32_t group, double heat,
                             double water) const {
    if (!has_canopy_air()) return {};
    const LeafSurroundings& above = leaf_[group]->above;
    const double per_volume =
        above.pressure / (gas_constant * (above.temperature + kelvin));
    return {heat * resistance_ / (per_volume * air_heat_capacity),
            water * 1e-3 * above.pressure * resistance_ / per_volume};
}

LeafSurroundings LeafAir::around(const Point& point) const {
    const Place& place = at_[point.place];
    const Leaf& leaf = *leaf_[place.group];
    LeafSurroundings around = leaf.within;
    around.ppfd = point.ppfd;
    around.nir = light_.nir_of_sun * place.nir_of_sun +
                 light_.nir_of_sky * place.nir_of_sky +
                 place.nir_absorptance * light_.nir_beam * point.cosine;
    around.longwave =
        leaf_emissivity *
        (2 * leaf.black + place.view * (light_.longwave - leaf.black));
    around.wind *= place.wind;
    around.width = place.width;
    return around;
}

void LeafAir::Batch::clear() {
    points_.clear();
    solved_.clear();
}

void LeafAir::Batch::add(const Point& point, const LeafExchange* like) {
    const Leaf& leaf = *air_.leaf_[air_.at_[point.place].group];
    if (air_.warms()) {
        points_.push_back({&leaf.leaf, air_.around(point), like});
        return;
    }
    Expansion net = point.gross;
    net.value -= leaf.respiration;
    solved_.push_back(
        exchange_at_air_temperature(leaf.leaf.stomata, leaf.above, net));
}

std::span<const LeafExchange> LeafAir::Batch::solve() {
    if (air_.warms()) {
        solved_.resize(points_.size());
        leaf_exchange(points_, solved_.data());
    }
    return solved_;
}

LeafAir::Fluxes LeafAir::fluxes_of(const LeafExchange& found,
                                   const Point& point) const {
    const Leaf& leaf = *leaf_[at_[point.place].group];
    Expansion uptake = found.net;
    uptake.value += leaf.respiration;
    const double more =
        water_.has_leaf_temperature
            ? dark_respiration(leaves_.leaves[at_[point.place].group].rates,
                               found.temperature) -
                  leaf.respiration
            : 0;
    return {water_.has_leaf_temperature ? uptake : point.gross,
            found.transpiration,
            {found.sensible, 0, 0},
            {found.temperature - leaf.above.temperature, 0, 0},
            {found.conductance, 0, 0},
            {found.temperature > hot_leaf ? 1. : 0., 0, 0},
            {more, 0, 0}};
}

}  // namespace ideotype
