// SPDX-License-Identifier: Apache-2.0
#include "ideotype/light/resolution.hpp"

#include <algorithm>

#include "ideotype/core/contract.hpp"

namespace ideotype {

double Resolution::largest_path() const {
    return path_energy.empty()
               ? 0
               : *std::max_element(path_energy.begin(), path_energy.end());
}

Resolution combined(const Resolution& a, const Resolution& b) {
    IDEOTYPE_EXPECT(a.path_energy.size() == b.path_energy.size());
    IDEOTYPE_EXPECT(a.groups.size() == b.groups.size());
    IDEOTYPE_EXPECT(a.layers.size() == b.layers.size());
    Resolution both = a;
    for (std::size_t i = 0; i < b.path_energy.size(); ++i)
        both.path_energy[i] = std::max(a.path_energy[i], b.path_energy[i]);
    for (double Resolution::*part :
         {&Resolution::leaves, &Resolution::organs, &Resolution::objects,
          &Resolution::soil, &Resolution::reflected, &Resolution::unscattered,
          &Resolution::scattered})
        both.*part = std::max(a.*part, b.*part);
    for (std::size_t i = 0; i < b.groups.size(); ++i)
        both.groups[i] = std::max(a.groups[i], b.groups[i]);
    for (std::size_t i = 0; i < b.layers.size(); ++i)
        both.layers[i] = std::max(a.layers[i], b.layers[i]);
    return both;
}

Estimate at_least(Estimate x, double standard_error) {
    return {x.mean, std::max(x.standard_error, standard_error)};
}

}  // namespace ideotype
