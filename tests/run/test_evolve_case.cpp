// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <filesystem>
#include <fstream>
#include <unistd.h>

#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "once.hpp"
#include "run/evolve_case.hpp"
#include "run/provenance.hpp"
#include "run/summary.hpp"
#include "stand/stand.hpp"

namespace ideotype {
namespace {

//! An evaluator that returns the sum of the genes, fails or requests a stop in
//! some slots, and counts its evaluations.
class SumEvaluator : public Evaluator {
  public:
    SumEvaluator(const OutcomeSchema& schema, StopFlag& stop)
        : schema_(schema), stop_(stop) {}

    const OutcomeSchema& schema(const Task&) const override { return schema_; }

    Outcome evaluate(const Task& task, const Genome& genome) override {
        if (++count == stop_at) stop_.request();
        if (task.slot < failing_slots && !task.is_final)
            return failed_outcome(schema_, "the sun went out");
        Outcome outcome = unknown_outcome(this->schema(task));
        outcome.for_each_number([](double& x) { x = 0; });
        outcome.status = Status::done;
        double sum = 0;
        for (const double gene : genome) sum += gene;
        outcome.objectives.assign(schema_.objectives.size(), {sum, 0.1});
        // The sum of all genes also serves as the feature of a plant.
        outcome.quantities[schema_.measured.offset("lai")].mean = sum;
        return outcome;
    }

    int count = 0;
    int stop_at = -1;
    std::uint32_t failing_slots = 0;

  private:
    const OutcomeSchema& schema_;
    StopFlag& stop_;
};

class NoWatcher : public Watcher {
  public:
    void on_evaluation(const Task&, const Outcome&) override {}
    void on_generation(std::uint32_t, std::uint32_t,
                       const GenerationSummary&) override {}
    void on_final(const std::string&) override {}
};

class EvolveCase : public ::testing::Test {
  protected:
    EvolveCase() {
        folder = std::filesystem::temp_directory_path() /
                 ("ideotype_evolve_" + std::to_string(getpid()));
        std::filesystem::create_directories(folder);
        campaign =
            read_campaign(std::string(IDEOTYPE_CAMPAIGNS) + "/ames_quick.toml");
        campaign.search.population = 10;
        campaign.stop.generations = 6;
        chosen = cases(campaign)[0];
    }
    ~EvolveCase() override { std::filesystem::remove_all(folder); }

    std::string path(const std::string& name) const {
        return (folder / name).string();
    }
    HistoryHeader header() const { return header_of(campaign, chosen, "sse2"); }
    Ending evolve(History& history, SumEvaluator& evaluator) {
        const auto dispatcher =
            make_dispatcher(Session::alone(), {&evaluator}, stop);
        const auto optimizer = make_optimizer(
            campaign.search, search_space(campaign, chosen), chosen.seed);
        Once once(evolve_case({campaign, chosen, *optimizer, *dispatcher,
                               watcher, [] { return 1.0; }},
                              history));
        dispatcher->run(once);
        return once.result();
    }

    //! Expects that stopped and resumed searches make the same history as
    //! uninterrupted ones.
    //! @param stops evaluations after which searches stop
    void expect_same_after_stops(const std::vector<int>& stops = {1, 7, 10,
                                                                  31}) {
        const HistoryHeader h = header();
        History whole = History::create(path("whole.h5"), h);
        SumEvaluator evaluator(h.schema, stop);
        evolve(whole, evaluator);
        for (const int stop_at : stops) {
            const std::string name = path("cut" + std::to_string(stop_at));
            {
                History cut = History::create(name, h);
                SumEvaluator interrupted(h.schema, stop);
                interrupted.stop_at = stop_at;
                EXPECT_EQ(evolve(cut, interrupted), Ending::drained);
            }
            // Only a new start clears a stop.
            stop.~StopFlag();
            new (&stop) StopFlag;
            History resumed = History::resume(name);
            SumEvaluator rest(h.schema, stop);
            EXPECT_EQ(evolve(resumed, rest), Ending::finished);
            EXPECT_EQ(resumed.next_generation(), whole.next_generation());
            for (std::uint32_t g = 0; g < whole.next_generation(); ++g)
                for (std::uint32_t s = 0; s < whole.size(g); ++s) {
                    EXPECT_EQ(resumed.row(g, s).candidate.genome,
                              whole.row(g, s).candidate.genome);
                    EXPECT_EQ(resumed.row(g, s).outcome.objectives[0].mean,
                              whole.row(g, s).outcome.objectives[0].mean);
                }
        }
    }

    std::filesystem::path folder;
    Campaign campaign;
    Case chosen;
    StopFlag stop;
    NoWatcher watcher;
};

TEST_F(EvolveCase, EndsWithEvaluatedFinalistsAndAReason) {
    const HistoryHeader h = header();
    History history = History::create(path("a.h5"), h);
    SumEvaluator evaluator(h.schema, stop);
    EXPECT_EQ(evolve(history, evaluator), Ending::finished);
    EXPECT_EQ(history.finished(), "generations");
    const auto finalists = history.finalists();
    ASSERT_GE(finalists.size(), 2u);
    EXPECT_EQ(finalists[0].candidate.origin, Origin::baseline);
    EXPECT_EQ(finalists[0].candidate.parents,
              (std::array{no_parent, no_parent}));
    EXPECT_GT(finalists[1].outcome.objectives[0].mean,
              finalists[0].outcome.objectives[0].mean);
}

//! Each generation proposes one more plant than the previous one, further from
//! the baseline.
class GrowingOptimizer : public GenerationalOptimizer {
  public:
    explicit GrowingOptimizer(Genome baseline)
        : baseline_(std::move(baseline)) {}

    std::size_t next_size() const override { return told_.size() + 1; }

    Candidate candidate(std::uint32_t slot) override { return plant(slot); }

    std::vector<Candidate> best(std::size_t) const override {
        return {{baseline_, Origin::elite, {parents_row(), no_parent}},
                {plant(told_.size()).genome, Origin::elite, {15, no_parent}}};
    }

    const std::vector<std::size_t>& told() const { return told_; }

  private:
    void take(Population rows) override { told_.push_back(rows.size()); }

    Candidate plant(std::size_t slot) const {
        Candidate plant{baseline_, Origin::random};
        plant.genome[0] += 1e-3 * static_cast<double>(slot);
        return plant;
    }

    Genome baseline_;
    std::vector<std::size_t> told_;
};

TEST_F(EvolveCase, GenerationsMayDifferInSize) {
    campaign.final_rule.candidates = 2;
    const HistoryHeader h = header();
    GrowingOptimizer optimizer(baseline_genome(campaign));
    {
        History written = History::create(path("a.h5"), h);
        SumEvaluator evaluator(h.schema, stop);
        const auto dispatcher =
            make_dispatcher(Session::alone(), {&evaluator}, stop);
        Once once(evolve_case({campaign, chosen, optimizer, *dispatcher,
                               watcher, [] { return 1.0; }},
                              written));
        dispatcher->run(once);
        EXPECT_EQ(once.result(), Ending::finished);
    }
    EXPECT_EQ(optimizer.told(), (std::vector<std::size_t>{1, 2, 3, 4, 5, 6}));
    const History history = History::read(path("a.h5"));
    EXPECT_EQ(history.size(5), 6u);
    EXPECT_EQ(history.summaries()[5].best_slot, 5u);
    EXPECT_EQ(history.finished(), "generations");
}

//! Returns the number of bytes that this process has read so far.
long long bytes_read() {
    std::ifstream io("/proc/self/io");
    std::string name;
    long long bytes = 0;
    io >> name >> bytes;
    EXPECT_EQ(name, "rchar:");
    return bytes;
}

//! Counts the bytes read in each generation.
class ReadingWatcher : public NoWatcher {
  public:
    void on_generation(std::uint32_t, std::uint32_t,
                       const GenerationSummary&) override {
        const long long now = bytes_read();
        bytes.push_back(now - before_);
        before_ = now;
    }

    std::vector<long long> bytes;

  private:
    long long before_ = bytes_read();
};

TEST_F(EvolveCase, LateGenerationsReadNoMoreThanEarlyOnes) {
    campaign.stop.generations = 400;
    const HistoryHeader h = header();
    History history = History::create(path("long.h5"), h);
    SumEvaluator evaluator(h.schema, stop);
    const auto dispatcher =
        make_dispatcher(Session::alone(), {&evaluator}, stop);
    ReadingWatcher reading;
    const auto optimizer = make_optimizer(
        campaign.search, search_space(campaign, chosen), chosen.seed);
    Once once(evolve_case({campaign, chosen, *optimizer, *dispatcher, reading,
                           [] { return 1.0; }},
                          history));
    dispatcher->run(once);
    ASSERT_EQ(reading.bytes.size(), 400U);
    const long long early = reading.bytes[2];
    EXPECT_GT(early, 0);
    // Texts in /proc/self/io become longer with time. Reading all 400 summaries
    // again would add 24 kB.
    EXPECT_LE(reading.bytes.back(), early + 1000);
}

TEST_F(EvolveCase, StopAndResumeGiveTheSameAsAnUninterruptedRun) {
    expect_same_after_stops();
}

TEST_F(EvolveCase, StopAndResumeGiveTheSameWithStreams) {
    campaign.search.streams = 3;
    expect_same_after_stops();
}

TEST_F(EvolveCase, StopAndResumeGiveTheSameByRandomSearch) {
    campaign.search.optimizer = OptimizerKind::random;
    expect_same_after_stops();
}

TEST_F(EvolveCase, StopAndResumeGiveTheSameByAutoWithStreams) {
    campaign.search.optimizer = OptimizerKind::automatic;
    campaign.search.streams = 2;
    expect_same_after_stops();
}

// The surfaces of auto take ten generations of 7 or 8 plants.
TEST_F(EvolveCase, StopAndResumeGiveTheSameAcrossTheHandOverOfAuto) {
    campaign.search.optimizer = OptimizerKind::automatic;
    campaign.stop.generations = 12;
    expect_same_after_stops({1, 40, 78, 79, 80, 95});
}

TEST_F(EvolveCase, StopAndResumeGiveTheSameByAtlas) {
    campaign = read_campaign(
        std::string(IDEOTYPE_CAMPAIGNS) + "/ames_quick.toml",
        {"search.optimizer=atlas", "search.population=10",
         "search.axes=[{quantity=\"lai\", range=[0, 4000], cells=40}]",
         "stop.generations=6"});
    chosen = cases(campaign)[0];
    const HistoryHeader h = header();
    History history = History::create(path("atlas.h5"), h);
    SumEvaluator evaluator(h.schema, stop);
    EXPECT_EQ(evolve(history, evaluator), Ending::finished);
    const std::vector<Row> leaders = history.finalists();
    ASSERT_GE(leaders.size(), 4u) << "plants of several kinds lead";
    EXPECT_NE(result_of(history).gain.find("confirmed"), std::string::npos)
        << result_of(history).gain;
    expect_same_after_stops();
}

// The rule that ends streams also depends only on the rows that streams need.
TEST_F(EvolveCase, AStopRuleEndsStreamsAtTheSameRow) {
    campaign.search.streams = 2;
    campaign.stop.evaluations = 20;
    const HistoryHeader h = header();
    History history = History::create(path("streams.h5"), h);
    SumEvaluator evaluator(h.schema, stop);
    EXPECT_EQ(evolve(history, evaluator), Ending::finished);
    EXPECT_EQ(history.finished(), "evaluations");
    // Generation 2 needs only rows 0 to 9, generation 3 rows up to 19.
    EXPECT_EQ(history.next_generation(), 3U);
    EXPECT_EQ(history.size(3), 0U);
}

// All proposed rows are complete at the stop, and the rule is met, but another
// stream is further ahead.
TEST_F(EvolveCase, AStopBeforeTheEndOfStreamsLeavesTheCaseUnfinished) {
    campaign.search.streams = 2;
    campaign.stop.evaluations = 20;
    const HistoryHeader h = header();
    {
        History cut = History::create(path("cut.h5"), h);
        SumEvaluator interrupted(h.schema, stop);
        interrupted.stop_at = 10;
        EXPECT_EQ(evolve(cut, interrupted), Ending::drained);
        EXPECT_EQ(cut.next_generation(), 1U);
        EXPECT_TRUE(cut.finalists().empty());
    }
    // Only a new start clears a stop.
    stop.~StopFlag();
    new (&stop) StopFlag;
    History resumed = History::resume(path("cut.h5"));
    SumEvaluator rest(h.schema, stop);
    EXPECT_EQ(evolve(resumed, rest), Ending::finished);
    EXPECT_EQ(resumed.finished(), "evaluations");
    EXPECT_EQ(resumed.next_generation(), 3U);
}

TEST_F(EvolveCase, ASearchEndsWhenItsHistoryIsFull) {
    campaign.search.optimizer = OptimizerKind::automatic;
    // With constraints auto begins with a large generation.
    campaign.spec.constraints.lai.upper = 100;
    const HistoryHeader h = header();
    History history = History::create(path("room.h5"), h);
    SumEvaluator evaluator(h.schema, stop);
    EXPECT_EQ(evolve(history, evaluator), Ending::finished);
    EXPECT_EQ(history.finished(), "room");
    EXPECT_EQ(history.size(0), 30U);
    EXPECT_EQ(history.size(1), 10U);
}

TEST_F(EvolveCase, EqualGenomesAreEvaluatedOnce) {
    campaign.search.ga.mutations_per_child = 0;
    campaign.search.ga.crossover_probability = 0;
    const HistoryHeader h = header();
    History history = History::create(path("duplicates.h5"), h);
    SumEvaluator evaluator(h.schema, stop);
    evolve(history, evaluator);
    const auto summaries = history.summaries();
    std::uint32_t evaluations = 0;
    for (const auto& s : summaries) evaluations += s.evaluations;
    EXPECT_LT(summaries.back().evaluations, 10u);
    EXPECT_EQ(evaluations + history.finalists().size(),
              static_cast<std::size_t>(evaluator.count));
    for (std::uint32_t s = 0; s < 10; ++s)
        EXPECT_EQ(history.row(5, s).outcome.status, Status::done);
}

TEST_F(EvolveCase, AFewFailuresAreStoredAsRowsWithAReason) {
    const HistoryHeader h = header();
    History history = History::create(path("few.h5"), h);
    SumEvaluator evaluator(h.schema, stop);
    evaluator.failing_slots = 2;
    EXPECT_EQ(evolve(history, evaluator), Ending::finished);
    const Row row = history.row(3, 1);
    EXPECT_EQ(row.outcome.status, Status::failed);
    EXPECT_EQ(row.outcome.message, "the sun went out");
    EXPECT_EQ(history.summaries()[3].failures, 2u);
}

TEST_F(EvolveCase, TooManyFailuresEndTheRunWithTheReason) {
    const HistoryHeader h = header();
    History history = History::create(path("many.h5"), h);
    SumEvaluator evaluator(h.schema, stop);
    evaluator.failing_slots = 6;
    try {
        evolve(history, evaluator);
        FAIL() << "continued";
    } catch (const CaseError& error) {
        EXPECT_NE(std::string(error.what()).find("the sun went out"),
                  std::string::npos);
    }
}

}  // namespace
}  // namespace ideotype
