// SPDX-License-Identifier: Apache-2.0
#include "difference.hpp"

#include <bit>
#include <cstdint>

#include <fmt/format.h>

namespace ideotype {

namespace {

// Bits, because two zeros compare equal and two NaN do not.
bool is_same(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

std::string first_difference(const GeneSpace& genes, const Candidate& was,
                             const Candidate& is) {
    for (std::size_t i = 0; i < genes.size(); ++i)
        if (!is_same(was.genome[i], is.genome[i]))
            return fmt::format("gene {} was {}, is {} [{}]", genes[i].name,
                               was.genome[i], is.genome[i], genes[i].unit);
    if (was.origin != is.origin)
        return fmt::format("its origin was {}, is {}", name_of(was.origin),
                           name_of(is.origin));
    if (was.parents != is.parents)
        return fmt::format("its parents were {} and {}, are {} and {}",
                           was.parents[0], was.parents[1], is.parents[0],
                           is.parents[1]);
    return "";
}

}  // namespace ideotype
