// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <csignal>
#include <map>
#include <set>

#include <mpi.h>

#include "command_fixture.hpp"
#include "fake_director.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/host.hpp"

namespace ideotype {

using std::chrono::milliseconds;

class DispatcherOnAllRanks : public Commanded {
  protected:
    void evaluations_take(milliseconds duration) {
        evaluator_ = FakeEvaluator(duration);
    }

    //! For evaluate(): keeps what arrives, and notices what arrives twice.
    Record keep() {
        return [this](const Work& work, const Outcome& outcome) {
            EXPECT_TRUE(outcomes_.emplace(work.task.slot, outcome).second)
                << "slot " << work.task.slot << " was recorded before";
        };
    }

    std::map<std::uint32_t, Outcome> outcomes_;  //!< by slot
};

namespace {

std::vector<Work> sample_work(std::uint32_t count, std::size_t genes = 40) {
    std::vector<Work> work;
    for (std::uint32_t slot = 0; slot < count; ++slot) {
        Genome genome(genes);
        for (std::size_t i = 0; i < genes; ++i)
            genome[i] = 0.1 * slot + static_cast<double>(i) / 3;
        work.push_back({{2, 7, slot, 1, slot % 5 == 0}, genome});
    }
    return work;
}

//! What it would be on any number of ranks, bit for bit.
void expect_right_numbers(const Work& work, const Outcome& outcome) {
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

}  // namespace

TEST_F(DispatcherOnAllRanks, HasOneSeatPerWorker) {
    command([&](Dispatcher& dispatcher) {
        EXPECT_EQ(dispatcher.width(),
                  session().size() == 1 ? 1 : session().size() - 1);
    });
}

TEST_F(DispatcherOnAllRanks, RecordsEveryTaskOnceWithTheSameNumbers) {
    command([&](Dispatcher& dispatcher) {
        const std::vector<Work> work = sample_work(203);
        evaluate(dispatcher, work, keep());
        ASSERT_EQ(outcomes_.size(), work.size());
        for (const Work& item : work)
            expect_right_numbers(item, outcomes_.at(item.task.slot));
    });
}

TEST_F(DispatcherOnAllRanks, CarriesGenomesOfAnyLength) {
    command([&](Dispatcher& dispatcher) {
        for (const std::size_t genes : {0u, 1u, 20'000u}) {
            const std::vector<Work> work = sample_work(12, genes);
            outcomes_.clear();
            evaluate(dispatcher, work, keep());
            ASSERT_EQ(outcomes_.size(), work.size());
            for (const Work& item : work)
                expect_right_numbers(item, outcomes_.at(item.task.slot));
        }
    });
}

TEST_F(DispatcherOnAllRanks, ManagesWithLessWorkThanRanks) {
    command([&](Dispatcher& dispatcher) {
        evaluate(dispatcher, {}, keep());
        EXPECT_TRUE(outcomes_.empty());
        evaluate(dispatcher, sample_work(1), keep());
        EXPECT_EQ(outcomes_.size(), 1u);
    });
}

TEST_F(DispatcherOnAllRanks, GivesWorkToAllWorkers) {
    evaluations_take(milliseconds(5));
    command([&](Dispatcher& dispatcher) {
        evaluate(dispatcher, sample_work(20), keep());
        std::set<std::uint32_t> workers;
        for (const auto& [slot, outcome] : outcomes_) {
            workers.insert(outcome.worker);
            EXPECT_GE(outcome.seconds, 0.005);
        }
        EXPECT_EQ(static_cast<int>(workers.size()), dispatcher.width());
        EXPECT_EQ(*workers.begin(), session().size() == 1 ? 0u : 1u);
    });
}

TEST_F(DispatcherOnAllRanks, PassesFailuresOnWithTheirReasons) {
    command([&](Dispatcher& dispatcher) {
        std::vector<Work> work = sample_work(10);
        work[2].task.slot = FakeEvaluator::throwing_slot;
        work[8].task.slot = FakeEvaluator::not_a_number_slot;
        evaluate(dispatcher, work, keep());
        ASSERT_EQ(outcomes_.size(), 10u);
        for (const auto& [slot, outcome] : outcomes_)
            EXPECT_EQ(outcome.status,
                      slot < 10 ? Status::done : Status::failed);
        EXPECT_EQ(outcomes_.at(FakeEvaluator::throwing_slot).message,
                  "leaf 3 is longer than the row");
        EXPECT_NE(outcomes_.at(FakeEvaluator::not_a_number_slot)
                      .message.find("height"),
                  std::string::npos);
    });
}

TEST_F(DispatcherOnAllRanks, EndsWithoutARowWhereTheMachineFails) {
    evaluations_take(milliseconds(2));
    command([&](Dispatcher& dispatcher) {
        std::vector<Work> work = sample_work(100);
        work[20].task.slot = FakeEvaluator::starved_slot;
        try {
            evaluate(dispatcher, work, keep());
            ADD_FAILURE() << "nothing was said";
        } catch (const Error& error) {
            EXPECT_NE(
                std::string(error.what())
                    .find(" could not evaluate finalist 1006 on " +
                          host_name() + ": not enough memory; that is not"),
                std::string::npos)
                << error.what();
        }
        EXPECT_FALSE(outcomes_.contains(FakeEvaluator::starved_slot));
        // Work that was in flight is recorded, and nothing was begun later.
        EXPECT_GE(outcomes_.size(), 20u);
        EXPECT_LE(static_cast<int>(outcomes_.size()),
                  20 + 2 * dispatcher.width());
        for (const auto& [slot, outcome] : outcomes_)
            expect_right_numbers(work[slot], outcome);
        EXPECT_TRUE(dispatcher.dismiss());
    });
}

TEST_F(DispatcherOnAllRanks, FinishesOnlyWhatIsInFlightWhenToldToStop) {
    evaluations_take(milliseconds(2));
    command([&](Dispatcher& dispatcher) {
        const std::vector<Work> work = sample_work(100);
        const Record keep_outcome = keep();
        evaluate(dispatcher, work,
                 [&](const Work& item, const Outcome& outcome) {
                     keep_outcome(item, outcome);
                     if (outcomes_.size() == 3) std::raise(SIGUSR1);
                 });
        // When the third arrives, at most the other workers are busy.
        EXPECT_EQ(static_cast<int>(outcomes_.size()),
                  3 + dispatcher.width() - 1);
        for (const auto& [slot, outcome] : outcomes_)
            expect_right_numbers(work[slot], outcome);

        evaluate(dispatcher, sample_work(5), [](const Work&, const Outcome&) {
            ADD_FAILURE() << "new work after a stop was requested";
        });
    });
}

TEST_F(DispatcherOnAllRanks, SurvivesARecordThatThrows) {
    evaluations_take(milliseconds(2));
    command([&](Dispatcher& dispatcher) {
        const auto disk_full = [](const Work&, const Outcome&) {
            throw Error("no space left on device");
        };
        EXPECT_THROW(evaluate(dispatcher, sample_work(50), disk_full), Error);
        // No late reply of the work above may turn up here.
        const std::vector<Work> work = sample_work(20, 3);
        evaluate(dispatcher, work, keep());
        ASSERT_EQ(outcomes_.size(), work.size());
        for (const Work& item : work)
            expect_right_numbers(item, outcomes_.at(item.task.slot));
        EXPECT_THROW(evaluate(dispatcher, sample_work(50), disk_full), Error);
    });
}

TEST_F(DispatcherOnAllRanks, SleepsWhileItWaits) {
    evaluations_take(milliseconds(1000));
    const double before = cpu_seconds();
    command([&](Dispatcher& dispatcher) {
        evaluate(dispatcher, sample_work(1), keep());
    });
    EXPECT_LT(cpu_seconds() - before, 0.25);
}

TEST_F(DispatcherOnAllRanks, WorkersRefuseWhatTheyDoNotKnow) {
    if (!is_master()) {
        EXPECT_THROW(serve(session(), evaluator_), Error);
        EXPECT_THROW(serve(session(), evaluator_), Error);
        return;
    }
    const int number = 5;
    for (int rank = 1; rank < session().size(); ++rank)
        for (const int tag : {1, 99})
            MPI_Send(&number, 1, MPI_INT, rank, tag, MPI_COMM_WORLD);
}

}  // namespace ideotype
