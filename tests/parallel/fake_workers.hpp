// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "fake_director.hpp"
#include "sample_work.hpp"
#include "workers.hpp"

namespace ideotype {

//! A clock that advances only during naps of a test or of a fake worker.
class FakeClock : public RankClock {
  public:
    double now() const override { return now_; }
    void nap(double seconds) const override { now_ += seconds; }

  private:
    mutable double now_ = 100;
};

//! Workers that answer after a time chosen by a test, on a fake clock.
class FakeWorkers : public Workers {
  public:
    //! The time that a worker needs for this work [s].
    using Duration = std::function<double(int worker, const Work& work)>;

    FakeWorkers(int width, const FakeClock& clock, Duration duration)
        : clock_(clock),
          duration_(std::move(duration)),
          seats_(static_cast<std::size_t>(width)) {}

    int width() const override { return static_cast<int>(seats_.size()); }
    int number(int worker) const override { return worker; }
    const OutcomeSchema& schema(const Task& task) const override {
        return evaluator_.schema(task);
    }

    void give(int worker, const Work& work) override {
        Seat& seat = seats_.at(static_cast<std::size_t>(worker));
        EXPECT_FALSE(seat.work) << "worker " << worker << " has work";
        seat.work = work;
        seat.seconds = duration_(worker, work);
        seat.end = clock_.now() + seat.seconds;
    }

    std::optional<Answer> wait(double seconds) override {
        // Like a real clock, this clock advances between two readings.
        const double latest = clock_.now() + std::max(seconds, 1e-6);
        int first = -1;
        double end = latest;
        for (int worker = 0; worker < width(); ++worker) {
            const Seat& seat = seats_[static_cast<std::size_t>(worker)];
            if (!seat.work || seat.end > end) continue;
            if (first >= 0 && seat.end == end) continue;
            first = worker;
            end = seat.end;
        }
        if (end > clock_.now()) clock_.nap(end - clock_.now());
        if (first < 0) return std::nullopt;
        Seat& seat = seats_[static_cast<std::size_t>(first)];
        Outcome outcome =
            evaluate_guarded(evaluator_, *seat.work, number(first), clock_);
        outcome.seconds = seat.seconds;
        seat.work.reset();
        return Answer{first, outcome};
    }

    void dismiss() override {}

  private:
    struct Seat {
        std::optional<Work> work;
        double seconds = 0;
        double end = 0;  //!< end of the work on the clock [s]
    };

    const FakeClock& clock_;
    FakeEvaluator evaluator_;
    Duration duration_;
    std::vector<Seat> seats_;
};

//! Makes dispatchers of fake workers; evaluations take 10 ms by default.
class WithFakeWorkers : public testing::Test {
  protected:
    Dispatcher make(int width, const AnswerRules& rules = {}) {
        return {
            std::make_unique<FakeWorkers>(width, clock_,
                                          [this](int worker, const Work& work) {
                                              return duration_(worker, work);
                                          }),
            stop_, rules, clock_};
    }

    FakeClock clock_;
    StopFlag stop_;
    FakeWorkers::Duration duration_ = [](int, const Work&) { return 0.01; };
    FakeDirector director_;
};

//! Tests that are repeated with several numbers of workers.
class WithAnyWorkers : public WithFakeWorkers,
                       public testing::WithParamInterface<int> {};

}  // namespace ideotype
