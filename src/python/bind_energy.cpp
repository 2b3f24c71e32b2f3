// SPDX-License-Identifier: Apache-2.0
#include "bindings.hpp"
#include "ideotype/physiology/energy_balance.hpp"

namespace ideotype::python {

namespace {

//! Reads the leaf of a point, whose columns ideotype._energy lists.
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
    std::vector<double> all;
    for (std::size_t i = 0; i < points.shape(0); ++i) {
        const double* x = points.data() + i * columns;
        const EnergyBalance b = energy_balance(
            leaf_of(x, is_c3),
            {x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8]});
        all.insert(all.end(),
                   {b.temperature, b.net, b.conductance, b.ci, b.transpiration,
                    b.latent, b.sensible, b.net_radiation, b.boundary_heat,
                    static_cast<double>(b.roots)});
    }
    return to_array(all, {points.shape(0), quantities});
}

}  // namespace

void bind_energy(nb::module_& module) {
    module.def("energy_balances", &energy_balances);
}

}  // namespace ideotype::python
