// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <coroutine>
#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "evaluator.hpp"
#include "ideotype/core/stop_flag.hpp"
#include "rank_clock.hpp"
#include "session.hpp"

namespace ideotype {

//! A task and the genome to evaluate.
struct Work {
    Task task;
    Genome genome;

    bool operator==(const Work&) const = default;
};

//! Returns the next work of a batch that can be handed out, if there is any
//! now; called again after each outcome. Work of later generations comes later.
using NextWork = std::function<std::optional<Work>()>;

//! Records an outcome. Called on rank 0 for each as it arrives, and must make
//! it durable before it returns. The task says which attempt was answered.
using Record = std::function<void(const Work&, const Outcome&)>;

//! The rules that tell how long to wait for an answer, and how often to try.
struct AnswerRules {
    //! The time after which an evaluation is late [s], unless 20 times what the
    //! longest took so far is longer.
    double deadline = 60;
    //! The number of late attempts after which an evaluation has failed, unless
    //! no worker is left.
    int attempts = 3;
    //! The time that a final evaluation takes over that of another.
    double final_effort = 1;
    //! The time within which a stop request, a passed deadline or new work of a
    //! source is noticed while evaluations are in flight [s].
    double attention = 0.25;

    double effort(const Task& task) const {
        return task.is_final ? final_effort : 1;
    }
};

//! Decides what begins, and hears of all that is not an outcome.
class Director {
  public:
    virtual ~Director() = default;

    //! Called when workers have nothing to do: starts another routine that will
    //! await evaluations, or returns false if there is none.
    virtual bool start_next() = 0;

    //! Called when a worker did not answer in time; `what` says so for the
    //! user.
    virtual void on_silence(const Task& task, const std::string& what) = 0;

    //! Called once when a stop is requested and so many evaluations are in
    //! flight.
    virtual void on_stop(int in_flight) = 0;
};

class Batch;
class Workers;

//! Hands the work of several routines to evaluators on demand. Work of the case
//! that is furthest behind comes first, so that each fills the gaps at the ends
//! of the others' generations and cases that were begun together end together.
class Dispatcher {
  public:
    Dispatcher(std::unique_ptr<Workers> workers, const StopFlag& stop,
               const AnswerRules& rules = {},
               const RankClock& clock = machine_clock);
    //! Dismisses the workers, and waits for ever for those that are late.
    ~Dispatcher();
    Dispatcher(const Dispatcher&) = delete;
    Dispatcher& operator=(const Dispatcher&) = delete;

    //! Evaluates work of one case in any order, until nothing is in flight and
    //! the source has nothing more; for routines within run(), which co_await
    //! it. If a stop is requested, hands out nothing more and goes on when what
    //! is in flight has arrived or is late. Rethrows an exception of source or
    //! record; what was in flight is then lost.
    Batch evaluate(NextWork source, Record record);

    //! Evaluates work that is known, as a source would give it piece by piece.
    Batch evaluate(std::vector<Work> work, Record record);

    //! Runs routines until all have ended. A late evaluation is given to
    //! another worker, and the first answer counts. A late worker gets no
    //! work until it answers.
    //! @throws Error if no worker answers any more, or, after the routines have
    //! gone on as after a stop, if a machine could not evaluate. Routines that
    //! still pause must be destroyed before the dispatcher.
    void run(Director& director);

    //! Returns how many evaluations can run at the same time.
    int width() const;

    //! Waits for what is in flight, but not beyond its deadline, drops it and
    //! tells the workers that there is no more. False if one does not answer;
    //! then only Session::abort() can end the job.
    [[nodiscard]] bool dismiss();

  private:
    friend Batch;
    //! The work that a worker was given, and when.
    struct Assignment;
    //! Orders batches: lowest generation first, then lowest case, then oldest.
    using Precedence = std::tuple<std::uint32_t, std::uint32_t, std::uint64_t>;

    void add(Batch& batch);
    void close(Batch& batch);
    void remove(Batch& batch);
    bool fetch(Batch& batch);
    int busy_in_time() const;
    bool has_late() const;
    double now();
    void give(int worker, const Assignment& given, const Work& work);
    Assignment take(int worker, const Outcome& outcome);
    std::optional<int> next_late();
    bool hand_out();
    void resume_complete();
    bool is_ending() const;
    void note_obstacle(int worker, const Task& task, const std::string& reason);
    void release_all();
    void receive(Director& director);
    void settle(const Assignment& given, const Outcome& outcome);
    void give_up(int worker, Director& director);
    double seconds_to_wait() const;
    void drop_next();

    std::unique_ptr<Workers> workers_;
    const StopFlag& stop_;
    AnswerRules rules_;
    const RankClock& clock_;
    std::vector<std::optional<Assignment>> given_;  //!< assignments by worker
    // Work is never done for each of all workers, since there may be thousands.
    std::set<int> idle_;
    //! The times at which workers that are in time become late, as now() tells
    //! [s].
    std::set<std::pair<double, int>> deadlines_;
    std::map<Precedence, Batch*> open_;
    std::map<std::uint64_t, Batch*> by_number_;  //!< open batches by number
    std::vector<Batch*> complete_;  //!< batches to be resumed, in this order
    std::uint64_t batches_ = 0;     //!< number of batches so far
    //! The longest time that an evaluation of usual effort took [s]; late ones
    //! do not count.
    double longest_ = 0;
    double looked_;         //!< when now() was asked last, on the clock [s]
    double running_ = 0;    //!< result of now() at that time [s]
    std::string obstacle_;  //!< why a machine could not evaluate
    bool has_told_of_stop_ = false;
    bool is_dismissed_ = false;
};

//! Work that a routine awaits; see Dispatcher::evaluate().
class [[nodiscard]] Batch {
  public:
    Batch(Dispatcher& dispatcher, NextWork source, Record record)
        : dispatcher_(dispatcher),
          source_(std::move(source)),
          record_(std::move(record)),
          number_(dispatcher.batches_++) {}
    ~Batch() { dispatcher_.remove(*this); }
    Batch(const Batch&) = delete;
    Batch& operator=(const Batch&) = delete;

    // These functions make a batch something that routines co_await.
    bool await_ready() {
        return dispatcher_.stop_.requested() || !dispatcher_.fetch(*this);
    }
    void await_suspend(std::coroutine_handle<> awaiting) {
        awaiting_ = awaiting;
        dispatcher_.add(*this);
    }
    void await_resume() const {
        if (failure_) std::rethrow_exception(failure_);
    }

  private:
    friend Dispatcher;

    Dispatcher& dispatcher_;
    NextWork source_;
    Record record_;
    std::uint64_t number_;
    std::uint64_t fetched_ = 0;
    std::map<std::uint64_t, Work> unanswered_;  //!< with the latest attempt
    std::vector<std::uint64_t> waiting_;  //!< for a worker; may be answered
    //! Precedence of the work that was fetched last.
    Dispatcher::Precedence precedence_;
    std::coroutine_handle<> awaiting_;
    std::exception_ptr failure_;
};

//! Makes the dispatcher of a job. Without other ranks, threads of this process
//! evaluate. With them, rank 0 sends work to idle workers, sleeps in between,
//! and asks its evaluators for their schema only, unless each rank has several;
//! then its own threads take part. All references must outlive the dispatcher.
//! @param evaluators one for each thread, as many on all ranks
std::unique_ptr<Dispatcher> make_dispatcher(const Session& session,
                                            const Evaluators& evaluators,
                                            const StopFlag& stop,
                                            const AnswerRules& rules = {});

//! Runs a worker rank: receives work, evaluates, replies, until rank 0 says
//! that there is no more. An Error in an evaluation becomes a failed outcome
//! with its message, cut to 160 bytes.
//! @throws Error if a message arrives that is neither.
void serve(const Session& session, const Evaluators& evaluators);

}  // namespace ideotype
