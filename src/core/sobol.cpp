// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/sobol.hpp"

#include <boost/random/sobol.hpp>

namespace ideotype {

namespace {

std::array<SobolDirections, sobol_dimensions> make_directions() {
    // For each dimension from the second on, the table contains the polynomial
    // and the first direction integers; a recurrence gives the others.
    using Table = boost::random::default_sobol_table;
    std::array<SobolDirections, sobol_dimensions> directions{};
    for (unsigned bit = 0; bit < 32; ++bit)
        directions[0][bit] = 1u << (31 - bit);
    for (std::size_t d = 1; d < sobol_dimensions; ++d) {
        SobolDirections& v = directions[d];
        const unsigned polynomial = Table::polynomial(d - 1);
        const auto degree =
            static_cast<unsigned>(std::bit_width(polynomial)) - 1;
        for (unsigned i = 0; i < degree; ++i)
            v[i] = std::uint32_t{Table::minit(d - 1, i)} << (31 - i);
        for (unsigned i = degree; i < 32; ++i) {
            v[i] = v[i - degree] ^ (v[i - degree] >> degree);
            for (unsigned k = 1; k < degree; ++k)
                if (polynomial >> (degree - k) & 1) v[i] ^= v[i - k];
        }
    }
    return directions;
}

}  // namespace

const std::array<SobolDirections, sobol_dimensions> sobol_directions =
    make_directions();

}  // namespace ideotype
