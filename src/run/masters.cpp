#include "ideotype/run/masters.hpp"

#include <algorithm>

namespace ideotype {

namespace {

int part_of_case(int index, int cases, int parts) {
    return static_cast<int>(static_cast<long long>(index) * parts / cases);
}

}  // namespace

int masters(std::optional<int> wanted, int ranks, int cases) {
    constexpr long long ranks_of_one = 1024;
    const int cases_of_one = std::max(
        1, static_cast<int>(cases * ranks_of_one / std::max(ranks, 1)));
    const int enough = (cases + cases_of_one - 1) / cases_of_one;
    return std::clamp(wanted.value_or(enough), 1,
                      std::max(1, std::min(ranks, cases)));
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
