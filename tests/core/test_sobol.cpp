// SPDX-License-Identifier: Apache-2.0
#include <set>

#include <gtest/gtest.h>

#include "ideotype/core/sobol.hpp"

namespace ideotype {
namespace {

TEST(Sobol, PointsAgreeWithSciPy) {
    // Expected values: SciPy 1.17.1, in which point i is our point i ^ (i >>
    // 1).
    const std::uint32_t points[] = {1, 7, 442, 540};
    const std::size_t dimensions[] = {0, 1, 2, 5, 63, 100, 200, 336};
    const std::uint32_t expected[][4] = {
        {2147483648, 3758096384, 1568669696, 943718400},
        {2147483648, 3758096384, 192937984, 415236096},
        {2147483648, 536870912, 1233125376, 2227175424},
        {2147483648, 2684354560, 2273312768, 3896508416},
        {2147483648, 2684354560, 864026624, 1916796928},
        {2147483648, 536870912, 4269801472, 3300917248},
        {2147483648, 536870912, 1702887424, 3233808384},
        {2147483648, 3758096384, 176160768, 3519021056}};
    for (std::size_t k = 0; k < 8; ++k)
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_EQ(sobol(points[i], dimensions[k]), expected[k][i])
                << "point " << points[i] << ", dimension " << dimensions[k];
}

TEST(Sobol, DimensionsAreStratifiedAndDistinct) {
    constexpr std::uint32_t n = 1024;
    std::set<SobolDirections> seen;
    for (std::size_t d = 0; d < sobol_dimensions; ++d) {
        std::set<std::uint32_t> cells;
        for (std::uint32_t i = 0; i < n; ++i)
            cells.insert(scrambled(sobol(i, d), 7) / (~0u / n + 1));
        EXPECT_EQ(cells.size(), n) << d;
        seen.insert(sobol_directions[d]);
    }
    EXPECT_EQ(seen.size(), sobol_dimensions);
}

}  // namespace
}  // namespace ideotype
