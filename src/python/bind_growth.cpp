// SPDX-License-Identifier: Apache-2.0
#include "bindings.hpp"
#include "campaign/campaign.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype::python {

namespace {

//! A crop whose plants grow, and the dates of its leaves.
struct GrowingCrop {
    explicit GrowingCrop(const std::string& path) : crop(read_crop(path)) {
        if (!crop.growth)
            throw Error(path +
                        ": this crop has no [growth] (how its plants grow and "
                        "age); add the table, which describes a hybrid of "
                        "maize if it is empty");
        leaves = leaf_dates(*crop.growth);
    }

    const Growth& growth() const { return *crop.growth; }

    Crop crop;
    std::vector<LeafDates> leaves;
};

//! Returns the numbers of each leaf by name.
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
    nb::dict found;
    const auto add = [&](const char* name, const std::vector<double>& numbers) {
        found[name] = to_array(numbers, {numbers.size()});
    };
    add("green_area", green);
    add("dead_area", dead);
    add("tip", tip);
    add("collar", collar);
    add("death", death);
    add("collar_height", heights);
    return found;
}

//! Returns thermal time and the green and dead area of one plant at the end of
//! each day.
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
                     plant_at(x.growth(), x.crop.baseline, thermal_time), {}));
             })
        .def("season", &season);
}

}  // namespace ideotype::python
