// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "fake_evaluator.hpp"

namespace ideotype {

//! Makes the work of one generation; every fifth candidate is a finalist.
inline std::vector<Work> sample_work(std::uint32_t count,
                                     std::size_t genes = 40) {
    std::vector<Work> work;
    for (std::uint32_t slot = 0; slot < count; ++slot) {
        Genome genome(genes);
        for (std::size_t i = 0; i < genes; ++i)
            genome[i] = 0.1 * slot + static_cast<double>(i) / 3;
        work.push_back({{2, 7, slot, 1, slot % 5 == 0}, genome});
    }
    return work;
}

//! Expects that an outcome is bitwise equal to that of a single evaluator.
inline void expect_same_outcome(const Work& work, const Outcome& outcome) {
    const Outcome expected = FakeEvaluator().evaluate(work.task, work.genome);
    EXPECT_EQ(outcome.status, Status::done) << outcome.message;
    ASSERT_EQ(outcome.objectives.size(), expected.objectives.size());
    ASSERT_EQ(outcome.quantities.size(), expected.quantities.size());
    const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
    const auto compare = [&](const auto& a, const auto& b) {
        for (std::size_t i = 0; i < a.size(); ++i) {
            EXPECT_EQ(bits(a[i].mean), bits(b[i].mean));
            EXPECT_EQ(bits(a[i].standard_error), bits(b[i].standard_error));
        }
    };
    compare(outcome.objectives, expected.objectives);
    compare(outcome.quantities, expected.quantities);
}

//! Stores all outcomes, and detects outcomes that arrive twice.
class Kept {
  public:
    Record keep() {
        return [this](const Work& work, const Outcome& outcome) {
            EXPECT_TRUE(outcomes.emplace(work.task.slot, outcome).second)
                << "slot " << work.task.slot << " was recorded before";
        };
    }

    //! Expects the outcomes of all work, and no others.
    void expect_all(const std::vector<Work>& work) const {
        ASSERT_EQ(outcomes.size(), work.size());
        for (const Work& item : work)
            expect_same_outcome(item, outcomes.at(item.task.slot));
    }

    std::map<std::uint32_t, Outcome> outcomes;  //!< outcomes by slot
};

}  // namespace ideotype
