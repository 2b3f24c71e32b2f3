// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

#include "workers.hpp"

namespace ideotype {

namespace {

class ThreadWorkers : public Workers {
  public:
    ThreadWorkers(const Session& session, const Evaluators& evaluators)
        : evaluators_(evaluators),
          first_(session.rank_in_job(session.rank()) * width()),
          clock_(session.clock()),
          seats_(evaluators.size()) {
        try {
            for (int worker = 0; worker < width(); ++worker)
                threads_.emplace_back([this, worker] { evaluate(worker); });
        } catch (...) {
            end();
            throw;
        }
    }
    ~ThreadWorkers() override { end(); }

    int width() const override { return static_cast<int>(evaluators_.size()); }
    int number(int worker) const override { return first_ + worker; }
    const OutcomeSchema& schema(const Task& task) const override {
        return evaluators_.front()->schema(task);
    }

    void give(int worker, const Work& work) override {
        Seat& seat = seats_.at(static_cast<std::size_t>(worker));
        const std::lock_guard lock(mutex_);
        seat.work = work;
        seat.called.notify_one();
    }

    std::optional<Answer> wait(double seconds) override {
        std::unique_lock lock(mutex_);
        const bool has_any =
            arrived_.wait_for(lock, std::chrono::duration<double>(seconds),
                              [&] { return !answers_.empty(); });
        if (!has_any) return std::nullopt;
        Answer answer = std::move(answers_.front());
        answers_.pop_front();
        return answer;
    }

    void dismiss() override {
        const std::lock_guard lock(mutex_);
        is_dismissed_ = true;
        for (Seat& seat : seats_) seat.called.notify_one();
    }

  private:
    //! Where a thread waits for work.
    struct Seat {
        std::optional<Work> work;
        std::condition_variable called;
    };

    void end() {
        dismiss();
        for (std::thread& each : threads_) each.join();
    }

    //! The life of a thread.
    void evaluate(int worker) {
        const auto index = static_cast<std::size_t>(worker);
        Seat& seat = seats_[index];
        std::unique_lock lock(mutex_);
        for (;;) {
            seat.called.wait(lock, [&] { return seat.work || is_dismissed_; });
            if (!seat.work) return;
            const Work work = *std::exchange(seat.work, std::nullopt);
            lock.unlock();
            Outcome outcome = evaluate_guarded(*evaluators_[index], work,
                                               number(worker), clock_);
            lock.lock();
            answers_.push_back({worker, std::move(outcome)});
            arrived_.notify_one();
        }
    }

    const Evaluators evaluators_;
    const int first_;  //!< number in the job
    const RankClock& clock_;
    std::mutex mutex_;  //!< of all that follows but the threads
    std::deque<Seat> seats_;
    std::deque<Answer> answers_;
    std::condition_variable arrived_;
    bool is_dismissed_ = false;
    std::vector<std::thread> threads_;
};

}  // namespace

std::unique_ptr<Workers> make_thread_workers(const Session& session,
                                             const Evaluators& evaluators) {
    return std::make_unique<ThreadWorkers>(session, evaluators);
}

}  // namespace ideotype
