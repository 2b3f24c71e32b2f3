// SPDX-License-Identifier: Apache-2.0
#include "masters.hpp"

#include <algorithm>
#include <cmath>

namespace ideotype {

namespace {

int part_of_case(int index, int cases, int parts) {
    return static_cast<int>(static_cast<long long>(index) * parts / cases);
}

}  // namespace

int masters(std::optional<int> wanted, int ranks, int cases) {
    const int most = std::max(1, std::min(ranks, cases));
    if (wanted) return std::clamp(*wanted, 1, most);
    constexpr int enough_for_one = 512;
    if (ranks < enough_for_one) return 1;
    // An even number of cases for each: while one breeds, another is evaluated.
    constexpr double ranks_of_one = 256;
    const int pairs =
        static_cast<int>(std::lround(cases * ranks_of_one / ranks / 2));
    const int cases_of_one = std::max(1, 2 * pairs);
    return std::clamp((cases + cases_of_one - 1) / cases_of_one, 1, most);
}

int part_of(int rank, int ranks, int cases, int parts) {
    const auto index =
        static_cast<int>(static_cast<long long>(rank) * cases / ranks);
    return part_of_case(index, cases, parts);
}

std::vector<Case> dealt(const std::vector<Case>& cases, int part, int parts) {
    std::vector<Case> own;
    const auto count = static_cast<int>(cases.size());
    for (int i = 0; i < count; ++i)
        if (part_of_case(i, count, parts) == part)
            own.push_back(cases[static_cast<std::size_t>(i)]);
    return own;
}

}  // namespace ideotype
