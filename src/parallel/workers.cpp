// SPDX-License-Identifier: Apache-2.0
#include "workers.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"
#include "messages.hpp"

namespace ideotype {

namespace {

//! The threads of this process as workers.
class ThreadWorkers : public Workers {
  public:
    ThreadWorkers(const Session& session, const Evaluators& evaluators)
        : evaluators_(evaluators),
          first_(session.rank_in_job(session.rank()) * width()),
          clock_(session.clock()),
          seats_(evaluators.size()) {
        IDEOTYPE_EXPECT(!evaluators.empty());
        try {
            for (int worker = 0; worker < width(); ++worker)
                threads_.emplace_back([this, worker] { evaluate(worker); });
        } catch (const std::exception& error) {
            end();
            throw std::runtime_error(fmt::format(
                "{} threads cannot be started ({}); give the program more "
                "memory, or start fewer by --threads",
                width(), describe_exception(error)));
        }
    }
    ~ThreadWorkers() override { end(); }

    int width() const override { return static_cast<int>(evaluators_.size()); }
    int number(int worker) const override { return first_ + worker; }
    const OutcomeSchema& schema(const Task& task) const override {
        return evaluators_.front()->schema(task);
    }

    void give(int worker, const Work& work) override {
        IDEOTYPE_EXPECT(worker >= 0 && worker < width());
        Seat& seat = seats_[static_cast<std::size_t>(worker)];
        const std::lock_guard lock(mutex_);
        IDEOTYPE_EXPECT(!seat.work);
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
    //! A place where one thread waits for work.
    struct Seat {
        std::optional<Work> work;
        std::condition_variable called;
    };

    void end() {
        dismiss();
        for (std::thread& thread : threads_) thread.join();
    }

    //! The function of a thread: waits for work and evaluates it, until
    //! dismissal.
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
    const int first_;  //!< number of the first worker in the job
    const RankClock& clock_;
    std::mutex mutex_;  //!< protects all members below except the threads
    std::deque<Seat> seats_;
    std::deque<Answer> answers_;
    std::condition_variable arrived_;
    bool is_dismissed_ = false;
    std::vector<std::thread> threads_;
};

//! The workers of all ranks: first those of this rank, then those of other
//! ranks. Each rank assigns work to its threads itself.
class RankWorkers : public Workers {
  public:
    RankWorkers(const Session& session, const Evaluators& evaluators)
        : session_(session),
          evaluators_(evaluators),
          local_(evaluators.size() > 1
                     ? make_thread_workers(session, evaluators)
                     : nullptr),
          mailbox_(session),
          tasks_(per_rank() * static_cast<std::size_t>(session.size() - 1)) {
        IDEOTYPE_EXPECT(session.rank() == 0 && session.size() > 1);
    }

    int width() const override {
        return local_width() + static_cast<int>(tasks_.size());
    }
    int number(int worker) const override {
        if (worker < local_width()) return local_->number(worker);
        const auto threads = static_cast<int>(per_rank());
        return session_.rank_in_job(find_rank(worker)) * threads +
               (worker - local_width()) % threads;
    }
    const OutcomeSchema& schema(const Task& task) const override {
        return evaluators_.front()->schema(task);
    }

    void give(int worker, const Work& work) override {
        IDEOTYPE_EXPECT(worker >= 0 && worker < width());
        if (worker < local_width()) return local_->give(worker, work);
        auto& task_slot =
            tasks_[static_cast<std::size_t>(worker - local_width())];
        IDEOTYPE_EXPECT(!task_slot);
        task_slot = work.task;
        mailbox_.post(find_rank(worker), Tag::work, encode_work(work));
    }

    std::optional<Answer> wait(double seconds) override {
        const RankClock& clock = session_.clock();
        const double end = clock.now() + seconds;
        Backoff backoff;
        for (;;) {
            if (const auto letter = mailbox_.wait(local_ ? 0 : seconds))
                return read_answer(*letter);
            if (!local_) return std::nullopt;
            if (auto answer = local_->wait(backoff.next())) return answer;
            if (clock.now() >= end) return std::nullopt;
        }
    }

    void dismiss() override {
        if (local_) local_->dismiss();
        for (int rank = 1; rank < session_.size(); ++rank)
            mailbox_.post(rank, Tag::stop, {});
    }

  private:
    std::size_t per_rank() const { return evaluators_.size(); }
    int local_width() const { return local_ ? local_->width() : 0; }
    int find_rank(int worker) const {
        return 1 + (worker - local_width()) / static_cast<int>(per_rank());
    }

    Answer read_answer(const Envelope& letter) {
        const int rank = session_.rank_in_job(letter.source);
        if (letter.tag != Tag::reply) refuse(rank);
        const Task task = decode_task(letter.bytes);
        const auto first =
            tasks_.begin() +
            static_cast<std::ptrdiff_t>(per_rank()) * (letter.source - 1);
        const auto last = first + static_cast<std::ptrdiff_t>(per_rank());
        const auto assigned = std::find(first, last, std::optional(task));
        if (assigned == last) refuse(rank);
        assigned->reset();
        return {local_width() + static_cast<int>(assigned - tasks_.begin()),
                decode_reply(letter.bytes, schema(task)).outcome};
    }

    [[noreturn]] static void refuse(int rank) {
        throw Error(
            fmt::format("rank {} replied without having that work; all ranks "
                        "must run the same ideotype",
                        rank));
    }

    const Session& session_;
    const Evaluators evaluators_;
    std::unique_ptr<Workers> local_;  //!< threads of this rank, if any
    Mailbox mailbox_;
    //! Tasks of the workers on other ranks.
    std::vector<std::optional<Task>> tasks_;
};

}  // namespace

std::unique_ptr<Workers> make_thread_workers(const Session& session,
                                             const Evaluators& evaluators) {
    return std::make_unique<ThreadWorkers>(session, evaluators);
}

std::unique_ptr<Workers> make_rank_workers(const Session& session,
                                           const Evaluators& evaluators) {
    return std::make_unique<RankWorkers>(session, evaluators);
}

}  // namespace ideotype
