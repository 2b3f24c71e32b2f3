// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "contracts.hpp"
#include "fake_workers.hpp"
#include "messages.hpp"

namespace ideotype {

namespace {

//! A worker whose first answer a test decides; later answers are correct.
class LyingWorkers : public Workers {
  public:
    explicit LyingWorkers(Answer lie) : lie_(std::move(lie)) {}

    int width() const override { return 1; }
    int number(int worker) const override { return worker; }
    const OutcomeSchema& schema(const Task& task) const override {
        return evaluator_.schema(task);
    }
    void give(int, const Work& work) override { work_ = work; }
    std::optional<Answer> wait(double) override {
        if (lie_) return *std::exchange(lie_, std::nullopt);
        const Work work = *std::exchange(work_, std::nullopt);
        return Answer{0, evaluator_.evaluate(work.task, work.genome)};
    }
    void dismiss() override {}

  private:
    std::optional<Answer> lie_;
    std::optional<Work> work_;
    FakeEvaluator evaluator_;
};

void evaluate_by(std::unique_ptr<Workers> workers,
                 const AnswerRules& rules = {}) {
    const StopFlag stop;
    const FakeClock clock;
    Dispatcher dispatcher(std::move(workers), stop, rules, clock);
    evaluate(dispatcher, sample_work(1), [](const Work&, const Outcome&) {});
}

void hear(const Answer& lie) {
    evaluate_by(std::make_unique<LyingWorkers>(lie));
}

void follow(const AnswerRules& rules) {
    evaluate_by(std::make_unique<LyingWorkers>(Answer{}), rules);
}

std::unique_ptr<Workers> no_workers(const FakeClock& clock) {
    return std::make_unique<FakeWorkers>(0, clock,
                                         [](int, const Work&) { return 1.; });
}

//! A clock that runs back each time that it is read.
class BackwardClock : public RankClock {
  public:
    double now() const override { return --now_; }
    void nap(double) const override {}

  private:
    mutable double now_ = 0;
};

void evaluate_in_the_past() {
    const StopFlag stop;
    const BackwardClock clock;
    Dispatcher dispatcher(std::make_unique<LyingWorkers>(Answer{}), stop, {},
                          clock);
    evaluate(dispatcher, sample_work(1), [](const Work&, const Outcome&) {});
}

void run_after_dismissal() {
    const StopFlag stop;
    const FakeClock clock;
    Dispatcher dispatcher(std::make_unique<LyingWorkers>(Answer{}), stop, {},
                          clock);
    static_cast<void>(dispatcher.dismiss());
    evaluate(dispatcher, sample_work(1), [](const Work&, const Outcome&) {});
}

}  // namespace

TEST(Contracts, OfDispatchersAreNoticed) {
    const FakeClock clock;
    Outcome empty;
    empty.status = Status::empty;
    expect_noticed({
        {"workers_->width() > 0", [&] { evaluate_by(no_workers(clock)); }},
        {"rules.deadline > 0 && rules.attempts > 0",
         [] { follow({.deadline = 0}); }},
        {"rules.deadline > 0 && rules.attempts > 0",
         [] { follow({.attempts = 0}); }},
        {"rules.final_effort > 0 && rules.attention > 0",
         [] { follow({.final_effort = 0}); }},
        {"!is_dismissed_", run_after_dismissal},
        {"looked >= looked_", evaluate_in_the_past},
        {"worker >= 0 && worker < width()",
         [] {
             hear({1, {}});
         }},
        {"outcome.status == Status::done || outcome.status == Status::failed",
         [=] {
             hear({0, empty});
         }},
    });
}

TEST(Contracts, OfWorkersAreNoticed) {
    FakeEvaluator evaluator;
    const Session session = Session::alone();
    expect_noticed({
        {"!evaluators.empty()", [&] { make_thread_workers(session, {}); }},
        {"!evaluators.empty()", [&] { serve(session, {}); }},
        {"worker >= 0 && worker < width()",
         [&] { make_thread_workers(session, {&evaluator})->give(1, {}); }},
    });
}

TEST(Contracts, OfMessagesAreNoticed) {
    Outcome empty;
    empty.status = Status::empty;
    const Session session = Session::alone();
    expect_noticed({
        {"reply.outcome.status != Status::empty",
         [=] {
             encode_reply({{}, empty});
         }},
        {"session.ranks_ != nullptr", [&] { const Mailbox none(session); }},
        {"part >= 0", [&] { session.split(-1); }},
        {"rank >= 0 && rank < size()", [&] { session.rank_in_job(1); }},
    });
}

}  // namespace ideotype
