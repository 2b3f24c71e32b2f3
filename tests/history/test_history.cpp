// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "sample_history.hpp"

namespace ideotype {
namespace {

TEST_F(HistoryTest, HeaderIsReadBack) {
    reopen();
    const HistoryHeader was = sample_header();
    const HistoryHeader& is = history->header();
    for (const auto& [name, text] : was.text) EXPECT_EQ(is.text.at(name), text);
    EXPECT_EQ(is.text.at("format"), "ideotype-history");
    EXPECT_EQ(is.text.at("format_version"), "2.0");
    EXPECT_EQ(is.numbers, was.numbers);
    EXPECT_EQ(is.campaign_source, was.campaign_source);
    EXPECT_EQ(is.campaign_resolved, was.campaign_resolved);
    EXPECT_EQ(is.seed, was.seed);
    EXPECT_EQ(is.population, was.population);
    EXPECT_EQ(is.generations, was.generations);
    EXPECT_EQ(is.finalists, was.finalists);
    ASSERT_EQ(is.genes.size(), was.genes.size());
    for (std::size_t i = 0; i < was.genes.size(); ++i) {
        EXPECT_EQ(is.genes[i].name, was.genes[i].name);
        EXPECT_EQ(is.genes[i].unit, was.genes[i].unit);
        EXPECT_EQ(is.genes[i].lower, was.genes[i].lower);
        EXPECT_EQ(is.genes[i].upper, was.genes[i].upper);
        EXPECT_EQ(is.genes[i].is_circular, was.genes[i].is_circular);
        EXPECT_EQ(is.genes[i].is_free, was.genes[i].is_free);
    }
    EXPECT_EQ(is.genes[1].trait, "insertion_angle");
    EXPECT_EQ(is.genes[1].leaf, 1);
    const auto& [axes, quantities] = is.schema.measured;
    ASSERT_EQ(quantities.size(), 2U);
    EXPECT_EQ(quantities[0].name, "lai");
    EXPECT_EQ(quantities[0].certainty, Certainty::exact);
    EXPECT_EQ(quantities[1].unit, "MJ m-2 day-1");
    EXPECT_EQ(quantities[1].axes, std::vector<std::string>{"leaf"});
    EXPECT_EQ(quantities[1].certainty, Certainty::estimated);
    ASSERT_EQ(axes.size(), 1U);
    EXPECT_EQ(std::get<1>(axes[0].coordinates),
              (std::vector<std::int64_t>{1, 2}));
    EXPECT_EQ(is.schema.randomisations, 2U);
    EXPECT_EQ(is.final_randomisations, 3U);
    EXPECT_EQ(is.schema.objectives[0].unit, "MJ m-2 day-1");
    EXPECT_EQ(is.schema.objectives[0].sense, Sense::maximise);
}

TEST_F(HistoryTest, RowsAreReadBackBitForBit) {
    propose(*history, 0, sample_candidates(0));
    record_pending(*history, 0);
    reopen();
    for (std::uint32_t slot = 0; slot < 4; ++slot) {
        const Row row = history->row(0, slot);
        const Candidate candidate = sample_candidate(0, slot);
        const Outcome outcome = sample_outcome(0, slot);
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_EQ(std::bit_cast<std::uint64_t>(row.candidate.genome[i]),
                      std::bit_cast<std::uint64_t>(candidate.genome[i]));
        EXPECT_EQ(row.candidate.origin, candidate.origin);
        EXPECT_EQ(row.candidate.parents, candidate.parents);
        EXPECT_EQ(row.outcome.status, Status::done);
        EXPECT_EQ(row.outcome.objectives[0].mean, outcome.objectives[0].mean);
        EXPECT_EQ(row.outcome.objectives[0].standard_error,
                  outcome.objectives[0].standard_error);
        EXPECT_EQ(row.outcome.randomisations, outcome.randomisations);
        EXPECT_EQ(row.outcome.violation, outcome.violation);
        EXPECT_EQ(row.outcome.quantities[1].mean, 1e-300);
        EXPECT_EQ(row.outcome.quantities[2].standard_error, 0.04);
        EXPECT_EQ(row.outcome.seconds, 0.5);
        EXPECT_EQ(row.outcome.worker, slot);
        EXPECT_EQ(row.outcome.message, "");
        EXPECT_EQ(row.attempt, 1U);
    }
}

TEST_F(HistoryTest, UnknownNumbersAreNaN) {
    propose(*history, 0, sample_candidates(0));
    const Row proposed = history->row(0, 2);
    EXPECT_EQ(proposed.outcome.status, Status::proposed);
    EXPECT_EQ(proposed.candidate.genome, sample_candidate(0, 2).genome);
    EXPECT_TRUE(std::isnan(proposed.outcome.violation));
    EXPECT_TRUE(std::isnan(proposed.outcome.objectives[0].mean));
    EXPECT_TRUE(std::isnan(proposed.outcome.quantities[1].standard_error));
    EXPECT_EQ(proposed.candidate.parents[0], no_parent);
    EXPECT_TRUE(std::isnan(proposed.outcome.seconds));
    EXPECT_EQ(history->size(4), 0U);
    EXPECT_THROW(history->row(4, 0), Error);
}

TEST_F(HistoryTest, FailedRowKeepsItsReasonAndNoNumbers) {
    propose(*history, 0, sample_candidates(0));
    Outcome outcome = sample_outcome(0, 1);
    outcome.status = Status::failed;
    // The message consists of 159 bytes and a character of two bytes, which no
    // longer fits in the field.
    outcome.message = std::string(159, 'x') + "\u00e9";
    history->record(0, 1, outcome, 3);
    reopen();
    const Row row = history->row(0, 1);
    EXPECT_EQ(row.outcome.status, Status::failed);
    EXPECT_EQ(row.outcome.message, std::string(159, 'x'));
    EXPECT_TRUE(std::isnan(row.outcome.objectives[0].mean));
    EXPECT_TRUE(std::isnan(row.outcome.quantities[2].standard_error));
    EXPECT_TRUE(std::isnan(row.outcome.randomisations[1]));
    EXPECT_EQ(row.attempt, 3U);
}

TEST_F(HistoryTest, SummaryIsReadBack) {
    const GenerationSummary was{3, 1.5, 0.25, 1.25, 0.125, 0.5, 2, 4, 60.5};
    propose(*history, 0, sample_candidates(0));
    record_pending(*history, 0);
    history->commit(0, was);
    reopen();
    const GenerationSummary is = history->summaries().at(0);
    EXPECT_EQ(is.best_slot, was.best_slot);
    EXPECT_EQ(is.best, was.best);
    EXPECT_EQ(is.best_standard_error, was.best_standard_error);
    EXPECT_EQ(is.mean, was.mean);
    EXPECT_EQ(is.spread, was.spread);
    EXPECT_EQ(is.diversity, was.diversity);
    EXPECT_EQ(is.failures, was.failures);
    EXPECT_EQ(is.evaluations, was.evaluations);
    EXPECT_EQ(is.wall_time, was.wall_time);
}

TEST_F(HistoryTest, RecordedRowNeverChanges) {
    propose(*history, 0, sample_candidates(0));
    history->record(0, 0, sample_outcome(0, 0), 1);
    const auto again = [&] { history->record(0, 0, sample_outcome(0, 1), 2); };
    EXPECT_NE(
        catch_refusal(again).find("generation 0 slot 0 is recorded already"),
        std::string::npos);
    EXPECT_EQ(history->row(0, 0).outcome.worker, 0U);
    EXPECT_THROW(history->record(1, 0, sample_outcome(1, 0), 1), Error);
    EXPECT_THROW(history->record(0, 4, sample_outcome(0, 0), 1), Error);
}

TEST_F(HistoryTest, WrongShapesAreRejectedWithoutDamage) {
    EXPECT_THROW(propose(*history, 0, sample_candidates(0, 21)), Error);
    auto candidates = sample_candidates(0);
    candidates[0].genome.pop_back();
    EXPECT_THROW(propose(*history, 0, candidates), Error);
    EXPECT_THROW(propose(*history, 5, sample_candidates(5)), Error);
    complete(*history, 0);
    propose(*history, 1, sample_candidates(1));
    Outcome outcome = sample_outcome(1, 0);
    outcome.quantities.pop_back();
    EXPECT_THROW(history->record(1, 0, outcome, 1), Error);
    outcome = sample_outcome(1, 0);
    outcome.status = Status::proposed;
    EXPECT_THROW(history->record(1, 0, outcome, 1), Error);
    record_pending(*history, 1);
    history->commit(1, {});
    EXPECT_EQ(history->next_generation(), 2U);
}

TEST_F(HistoryTest, FinalistsAreStoredSeparately) {
    history->propose_final(sample_candidates(7, 2));
    history->record_final(1, sample_outcome(7, 1, 3));
    reopen();
    history->propose_final(sample_candidates(7, 2));
    EXPECT_EQ(history->pending_final(), (std::vector<std::uint32_t>{0}));
    history->record_final(0, sample_outcome(7, 0, 3));
    const auto rows = history->finalists();
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[1].outcome.randomisations.size(), 3U);
    EXPECT_EQ(rows[1].candidate.genome, sample_candidate(7, 1).genome);
    EXPECT_EQ(history->size(0), 0U);
    EXPECT_THROW(history->propose_final(sample_candidates(6, 2)), Error);
    EXPECT_THROW(history->propose_final(sample_candidates(7, 1)), Error);
    EXPECT_THROW(history->propose_final(sample_candidates(7, 4)), Error);
}

TEST_F(HistoryTest, StateSurvivesReopening) {
    EXPECT_EQ(history->finished(), std::nullopt);
    EXPECT_EQ(history->wall_time(), 0);
    history->begin_session({"2025-08-07T12:00:00Z", "node1", "run", 4});
    history->set_wall_time(1.5);
    history->message("slow");
    reopen();
    history->begin_session({"2025-08-08T12:00:00Z", "node2", "run", 8});
    history->set_wall_time(2.25);
    EXPECT_EQ(history->wall_time(), 2.25);
    history->finish("generations");
    reopen();
    EXPECT_EQ(history->wall_time(), 2.25);
    EXPECT_EQ(history->finished(), "generations");
}

TEST_F(HistoryTest, ReaderDoesNotWrite) {
    propose(*history, 0, sample_candidates(0));
    close();
    History reader = History::read(path);
    EXPECT_THROW(reader.record(0, 0, sample_outcome(0, 0), 1), Error);
    EXPECT_THROW(reader.finish("generations"), Error);
    EXPECT_EQ(list_pending(reader, 0).size(), 4U);
}

TEST_F(HistoryTest, JumpingClockDoesNoDamage) {
    std::uint32_t g = 0;
    for (const char* started :
         {"2025-08-07T12:00:00Z", "1970-01-01T00:00:00Z",
          "2125-08-07T12:00:00Z", "2025-08-07T12:00:01Z"}) {
        history->begin_session({started, "node", "run", 1});
        // A decreasing wall time is accepted too.
        history->set_wall_time(100.0 - g);
        complete(*history, g++);
        reopen();
    }
    EXPECT_EQ(history->next_generation(), 4U);
    EXPECT_EQ(history->row(0, 1).outcome.status, Status::done);
    EXPECT_EQ(history->wall_time(), 97.0);
}

TEST_F(HistoryTest, FileSizeNeverChanges) {
    // The file must not grow: HDF5 would have to modify its own structures, and
    // a kill at that moment could make them unreadable.
    const auto size = std::filesystem::file_size(path);
    history->begin_session({"2025-08-07T12:00:00Z", "node1", "run", 4});
    for (std::uint32_t g = 0; g < 5; ++g) complete(*history, g);
    history->message("slow");
    history->propose_final(sample_candidates(7, 3));
    history->finish("generations");
    EXPECT_EQ(std::filesystem::file_size(path), size);
    reopen();
    close();
    EXPECT_EQ(std::filesystem::file_size(path), size);
}

TEST(History, QuantitiesAndFinalistsAreOptional) {
    const Folder folder;
    HistoryHeader header = sample_header();
    header.schema.measured = {};
    header.finalists = 0;
    History history = History::create(folder / "bare.h5", header);
    propose(history, 0, sample_candidates(0));
    Outcome outcome = sample_outcome(0, 0);
    outcome.quantities.clear();
    history.record(0, 0, outcome, 1);
    EXPECT_EQ(history.row(0, 0).outcome.status, Status::done);
    EXPECT_TRUE(history.finalists().empty());
    EXPECT_TRUE(history.pending_final().empty());
}

}  // namespace
}  // namespace ideotype
