// SPDX-License-Identifier: Apache-2.0
#include "bindings.hpp"
#include "campaign/campaign.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/physiology/energy_balance.hpp"
#include "ideotype/physiology/soil_water.hpp"

namespace ideotype::python {

namespace {

struct GrowingCrop {
    explicit GrowingCrop(const std::string& path) : crop(read_crop(path)) {
        if (!crop.growth)
            throw Error(path +
                        ": this is no crop file with [growth] (how plants grow "
                        "and age); give such a file, for example "
                        "crops/maize_hybrid.toml, or add the table, which "
                        "describes a hybrid of maize if it is empty");
        leaves = leaf_dates(*crop.growth);
    }

    const Growth& growth() const { return *crop.growth; }

    Crop crop;
    std::vector<LeafDates> leaves;
};

//! Returns the parameters of each leaf, by name.
nb::dict at(const GrowingCrop& crop, double thermal_time) {
    std::vector<double> green, dead, tip, collar, death;
    for (const LeafDates& leaf : crop.leaves) {
        const BladeArea area = blade_area(crop.growth(), leaf, thermal_time);
        green.push_back(area.green);
        dead.push_back(area.dead);
        tip.push_back(leaf.tip);
        collar.push_back(leaf.collar);
        death.push_back(leaf.death);
    }
    const Plant& plant = crop.crop.baseline;
    const std::vector<double> heights = collar_heights(
        crop.growth(), final_collar_heights(crop.growth(), plant),
        plant.sheath.length, thermal_time);
    nb::dict balance;
    const auto add = [&](const char* name, const std::vector<double>& numbers) {
        balance[name] = to_array(numbers, {numbers.size()});
    };
    add("green_area", green);
    add("dead_area", dead);
    add("tip", tip);
    add("collar", collar);
    add("death", death);
    add("collar_height", heights);
    return balance;
}

//! Returns the thermal time and the green and dead leaf area of one plant, each
//! at the end of every day.
nb::tuple season(const GrowingCrop& crop, const Input<double, 1>& hourly) {
    constexpr std::size_t hours = 24;
    std::vector<double> times, green, dead;
    double time = 0;
    for (std::size_t first = 0; first < hourly.size(); first += hours) {
        time +=
            daily_thermal_time(crop.growth(), {hourly.data() + first, hours});
        BladeArea sum;
        for (const LeafDates& leaf : crop.leaves) {
            const BladeArea area = blade_area(crop.growth(), leaf, time);
            sum.green += area.green;
            sum.dead += area.dead;
        }
        times.push_back(time);
        green.push_back(sum.green);
        dead.push_back(sum.dead);
    }
    const std::size_t days = times.size();
    return nb::make_tuple(to_array(times, {days}), to_array(green, {days}),
                          to_array(dead, {days}));
}

//! Makes a leaf from the columns of a point, which ideotype.stand.energy lists.
ThermalLeaf leaf_of(const double* x, bool is_c3) {
    ThermalLeaf leaf{
        .stomata = {static_cast<Stomata::Model>(x[9]), x[10], x[11]},
        .emissivity = x[12],
        .ratio = x[13]};
    if (is_c3)
        leaf.rates = FarquharLeaf{.vcmax = x[14],
                                  .jmax = x[15],
                                  .tpu = x[16],
                                  .theta = x[17],
                                  .beta = x[18],
                                  .respiration = x[19]};
    else
        leaf.rates = CollatzLeaf{x[14], x[15], x[16], x[17], x[18], x[19]};
    return leaf;
}

//! @param points [point, column]
//! @returns [point, quantity], in the order of EnergyBalance
Output<double> energy_balances(const Input<double, 2>& points, bool is_c3) {
    constexpr std::size_t quantities = 10;
    const std::size_t columns = points.shape(1);
    std::vector<double> values;
    for (std::size_t i = 0; i < points.shape(0); ++i) {
        const double* x = points.data() + i * columns;
        const EnergyBalance b = energy_balance(
            leaf_of(x, is_c3),
            {x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8]});
        values.insert(values.end(),
                      {b.temperature, b.net, b.conductance, b.ci,
                       b.transpiration, b.latent, b.sensible, b.net_radiation,
                       b.boundary_heat, static_cast<double>(b.roots)});
    }
    return to_array(values, {points.shape(0), quantities});
}

//! @param soil field capacity, wilting point, total and readily evaporable
//! water, depletion fraction
//! @param initial depletion of the root zone and of the evaporable layer
//! @param days [day, column], columns in the order of SoilDay
//! @returns [day, quantity]: transpiration, evaporation, drainage and both
//! depletions at the end of the day
Output<double> soil_water_balance(const Input<double, 1>& soil,
                                  const Input<double, 1>& initial,
                                  const Input<double, 2>& days) {
    constexpr std::size_t quantities = 5, columns = 5;
    const double* s = soil.data();
    const Soil column{s[0], s[1], s[2], s[3], s[4]};
    SoilWater water{initial.data()[0], initial.data()[1]};
    std::vector<double> values;
    for (std::size_t i = 0; i < days.shape(0); ++i) {
        const double* x = days.data() + i * columns;
        const SoilFluxes out =
            pass_day(column, {x[0], x[1], x[2], x[3], x[4]}, water);
        values.insert(values.end(),
                      {out.transpiration, out.evaporation, out.drainage,
                       water.depletion, water.evaporable_depletion});
    }
    return to_array(values, {days.shape(0), quantities});
}

}  // namespace

void bind_growth(nb::module_& module) {
    nb::class_<GrowingCrop>(module, "GrowingCrop")
        .def(nb::init<const std::string&>())
        .def_prop_ro("name",
                     [](const GrowingCrop& x) { return x.crop.baseline.name; })
        .def_prop_ro(
            "silking",
            [](const GrowingCrop& x) { return silking_time(x.growth()); })
        .def_prop_ro(
            "maturity",
            [](const GrowingCrop& x) { return maturity_time(x.growth()); })
        .def("at", &at)
        .def("mesh",
             [](const GrowingCrop& x, double thermal_time) {
                 return mesh_tuple(build_plant(
                     age_plant(x.growth(), x.crop.baseline, thermal_time), {}));
             })
        .def("season", &season);
}

void bind_energy(nb::module_& module) {
    module.def("energy_balances", &energy_balances);
    module.def("soil_water_balance", &soil_water_balance);
}

}  // namespace ideotype::python
