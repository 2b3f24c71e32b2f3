// SPDX-License-Identifier: Apache-2.0
// Proposing and committing generations of a history.
#include <cmath>

#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "sample_history.hpp"

namespace ideotype {
namespace {

TEST_F(HistoryTest, PendingSlotsAreThoseNotRecorded) {
    EXPECT_TRUE(list_pending(*history, 0).empty());
    propose(*history, 0, sample_candidates(0));
    const Outcome outcome = sample_outcome(0, 2);
    history->record(0, 2, outcome, 1);
    EXPECT_EQ(list_pending(*history, 0), (std::vector<std::uint32_t>{0, 1, 3}));
    reopen();
    EXPECT_EQ(list_pending(*history, 0), (std::vector<std::uint32_t>{0, 1, 3}));
    EXPECT_EQ(history->next_generation(), 0U);
}

TEST_F(HistoryTest, CommitMovesToTheNextGeneration) {
    complete(*history, 0);
    complete(*history, 1);
    propose(*history, 2, sample_candidates(2));
    reopen();
    EXPECT_EQ(history->next_generation(), 2U);
    const Population population = history->generation(1);
    ASSERT_EQ(population.size(), 4U);
    EXPECT_EQ(population[3].candidate.genome, sample_candidate(1, 3).genome);
    const Estimate expected = sample_outcome(1, 3).objectives[0];
    EXPECT_EQ(population[3].objectives[0].mean, expected.mean);
    EXPECT_EQ(population[3].objectives[0].standard_error,
              expected.standard_error);
    EXPECT_EQ(population[3].violation, 0);
    ASSERT_EQ(history->summaries().size(), 2U);
    EXPECT_EQ(history->summaries()[1].best, 1.5);
    EXPECT_EQ(history->summaries()[1].best_slot, 3U);
}

TEST_F(HistoryTest, IncompleteGenerationIsNotCommitted) {
    propose(*history, 0, sample_candidates(0));
    EXPECT_THROW(history->commit(0, {}), Error);
    EXPECT_THROW(history->generation(0), Error);
    EXPECT_THROW(propose(*history, 2, sample_candidates(2)), Error);
    record_pending(*history, 0);
    EXPECT_EQ(history->generation(0).size(), 4U);
    history->commit(0, {});
    EXPECT_THROW(history->commit(0, {}), Error);
    EXPECT_EQ(history->next_generation(), 1U);
}

TEST_F(HistoryTest, NextGenerationMayBeProposedInPartsBeforeOneIsComplete) {
    propose(*history, 0, sample_candidates(0));
    const auto candidates = sample_candidates(1);
    EXPECT_EQ(history->propose(1, 4, 0, {candidates[0]}), 0U);
    EXPECT_EQ(history->propose(1, 4, 1, {candidates[1], candidates[2]}), 0U);
    EXPECT_EQ(list_pending(*history, 1), (std::vector<std::uint32_t>{0, 1, 2}));
    history->record(1, 1, sample_outcome(1, 1), 1);
    EXPECT_EQ(history->propose(1, 4, 1,
                               {candidates[1], candidates[2], candidates[3]}),
              2U);
    EXPECT_EQ(list_pending(*history, 1), (std::vector<std::uint32_t>{0, 2, 3}));
    record_pending(*history, 1);
    EXPECT_THROW(history->commit(1, {}), Error);
    record_pending(*history, 0);
    history->commit(0, {});
    history->commit(1, {});
    EXPECT_EQ(history->generation(1)[3].candidate.parents,
              candidates[3].parents);
}

TEST_F(HistoryTest, RepeatedProposalIsVerifiedAndKeepsRecordedRows) {
    propose(*history, 0, sample_candidates(0));
    history->record(0, 0, sample_outcome(0, 0), 1);
    reopen();
    propose(*history, 0, sample_candidates(0));
    EXPECT_EQ(list_pending(*history, 0), (std::vector<std::uint32_t>{1, 2, 3}));
}

TEST_F(HistoryTest, ChangedProposalIsRefusedWithItsSlot) {
    propose(*history, 0, sample_candidates(0));
    reopen();
    auto candidates = sample_candidates(0);
    candidates[2].genome[1] = std::nextafter(candidates[2].genome[1], 100);
    std::string message =
        catch_refusal([&] { propose(*history, 0, candidates); });
    EXPECT_NE(message.find("generation 0 slot 2"), std::string::npos)
        << message;
    EXPECT_NE(message.find("leaf01_insertion_angle"), std::string::npos)
        << message;

    candidates = sample_candidates(0);
    candidates[3].genome[2] = 0.0;  // -0.0 has become 0.0
    message = catch_refusal([&] { propose(*history, 0, candidates); });
    EXPECT_NE(message.find("slot 3"), std::string::npos) << message;

    candidates = sample_candidates(0);
    candidates[1].origin = Origin::child;
    message = catch_refusal([&] { propose(*history, 0, candidates); });
    EXPECT_NE(message.find("origin"), std::string::npos) << message;

    candidates = sample_candidates(0);
    candidates[1].parents[1] = 2;
    message = catch_refusal([&] { propose(*history, 0, candidates); });
    EXPECT_NE(message.find("parents"), std::string::npos) << message;
    propose(*history, 0, sample_candidates(0));
}

TEST_F(HistoryTest, GenerationsMayDifferInSize) {
    const auto commit_generation = [&](std::uint32_t generation,
                                       std::uint32_t size) {
        propose(*history, generation, sample_candidates(generation, size));
        record_pending(*history, generation);
        history->commit(generation, {.best_slot = size - 1});
    };
    commit_generation(0, 3);
    commit_generation(1, 6);
    commit_generation(2, 1);
    reopen();
    EXPECT_EQ(history->size(1), 6U);
    EXPECT_EQ(history->generation(2).size(), 1U);
    EXPECT_EQ(history->generation(1)[5].candidate.parents,
              sample_candidate(1, 5).parents);
    EXPECT_EQ(history->summaries()[1].best_slot, 5U);
    // The capacity of this history is 20 rows.
    EXPECT_THROW(propose(*history, 3, sample_candidates(3, 11)), Error);
    commit_generation(3, 10);
}

TEST_F(HistoryTest, ChangedNumberOfCandidatesIsRefused) {
    propose(*history, 0, sample_candidates(0));
    reopen();
    EXPECT_NE(catch_refusal([&] {
                  propose(*history, 0, sample_candidates(0, 3));
              }).find("generation 0 had 4 candidates before, not 3"),
              std::string::npos);
}

}  // namespace
}  // namespace ideotype
