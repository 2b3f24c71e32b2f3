#include <gtest/gtest.h>

#include "ideotype/search/duplicates.hpp"

namespace ideotype {
namespace {

TEST(Duplicates, PointToTheFirstOfTheirKind) {
    std::vector<Candidate> candidates(4);
    candidates[0].genome = {1, 2};
    candidates[1].genome = {1, 3};
    candidates[2].genome = candidates[3].genome = {1, 2};
    EXPECT_EQ(duplicates(candidates),
              (std::map<std::uint32_t, std::uint32_t>{{2, 0}, {3, 0}}));
}

}  // namespace
}  // namespace ideotype
