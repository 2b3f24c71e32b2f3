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

//! A task, with the genome to evaluate.
struct Work {
    Task task;
    Genome genome;

    bool operator==(const Work&) const = default;
};

//! Returns the next work of a batch, if any is ready. It is called again after
//! each outcome. Generations must not decrease from call to call.
using NextWork = std::function<std::optional<Work>()>;

//! Records an outcome durably. It is called on rank 0 for each outcome that
//! arrives. The task contains the number of the attempt that was answered.
using Record = std::function<void(const Work&, const Outcome&)>;

//! The number of late attempts after which an evaluation counts as failed,
//! unless no worker is left.
inline constexpr std::uint32_t most_attempts = 3;

//! Rules that limit the time to wait for an answer.
struct AnswerRules {
    //! Time after which an evaluation is late [s]. The actual limit is at least
    //! 20 times the longest evaluation so far.
    double deadline = 60;
    //! Duration of final evaluations, relative to others.
    double final_effort = 1;
    //! Largest delay with which a stop request, a passed deadline or new work
    //! of a source is noticed while evaluations are in flight [s].
    double attention = 0.25;

    double effort(const Task& task) const {
        return task.is_final ? final_effort : 1;
    }
};

//! Starts coroutines, and is notified of all events except outcomes.
class Director {
  public:
    virtual ~Director() = default;

    //! Called when workers are idle: starts another coroutine that will await
    //! evaluations. Returns false if there is none.
    virtual bool start_next() = 0;

    //! Called when a worker is late, with a message for the user.
    virtual void on_silence(const Task& task, const std::string& message) = 0;

    //! Called once after a stop request, with the number of evaluations in
    //! flight.
    virtual void on_stop(int in_flight) = 0;
};

class Batch;
class Workers;

//! Distributes the work of several coroutines to evaluators on demand. Work of
//! the case with the lowest generation comes first. Cases thus use workers that
//! are idle at the end of another case's generation, and cases that start
//! together end together.
class Dispatcher {
  public:
    Dispatcher(std::unique_ptr<Workers> workers, const StopFlag& stop,
               const AnswerRules& rules = {},
               const RankClock& clock = machine_clock);
    //! Dismisses the workers, and waits for late workers without a time limit.
    ~Dispatcher();
    Dispatcher(const Dispatcher&) = delete;
    Dispatcher& operator=(const Dispatcher&) = delete;

    //! Evaluates work of one case in any order, until nothing is in flight and
    //! the source is empty. Coroutines within run() co_await the batch. After a
    //! stop request no work is handed out, and the coroutine resumes when all
    //! work in flight has arrived or is late. An exception of source or record
    //! is rethrown; work in flight is then lost.
    Batch evaluate(NextWork source, Record record);

    //! Evaluates a list of work.
    Batch evaluate(std::vector<Work> work, Record record);

    //! Runs coroutines until all have ended. A late evaluation is given to
    //! another worker, and the first answer counts. A late worker gets no work
    //! until it answers. Coroutines that are still paused must be destroyed
    //! before the dispatcher.
    //! @throws Error if no worker responds any more or a machine failed to
    //! evaluate. Coroutines first resume as after a stop.
    void run(Director& director);

    //! Returns the number of evaluations that can run concurrently.
    int width() const;

    //! Waits for work in flight until its deadline, discards the answers and
    //! dismisses the workers. Returns false if a worker does not answer; then
    //! only Session::abort() can end the job.
    [[nodiscard]] bool dismiss();

  private:
    friend Batch;
    struct Assignment;
    //! Order in which batches get workers: lowest generation first, then lowest
    //! case, then oldest.
    using Precedence = std::tuple<std::uint32_t, std::uint32_t, std::uint64_t>;

    void add(Batch& batch);
    void close(Batch& batch);
    void remove(Batch& batch);
    bool fetch(Batch& batch);
    int busy_in_time() const { return static_cast<int>(deadlines_.size()); }
    bool has_late() const;
    double now();
    void give(int worker, const Assignment& assignment, const Work& work);
    Assignment take(int worker, const Outcome& outcome);
    std::optional<int> next_late();
    bool hand_out();
    void resume_complete();
    bool is_ending() const { return stop_.requested() || !obstacle_.empty(); }
    void note_obstacle(int worker, const Task& task, const std::string& reason);
    void release_all();
    void receive(Director& director);
    void settle(const Assignment& assignment, const Outcome& outcome);
    void give_up(int worker, Director& director);
    double seconds_to_wait() const;
    void drop_next();

    std::unique_ptr<Workers> workers_;
    const StopFlag& stop_;
    AnswerRules rules_;
    const RankClock& clock_;
    std::vector<std::optional<Assignment>> assignments_;  //!< by worker
    // Idle workers. No loop runs over all workers, of which there may be
    // thousands.
    std::set<int> idle_;
    //! Deadlines of the workers that are not late, as times of now() [s].
    std::set<std::pair<double, int>> deadlines_;
    std::map<Precedence, Batch*> open_;
    std::map<std::uint64_t, Batch*> by_number_;  //!< open batches by number
    std::vector<Batch*> complete_;  //!< batches to be resumed, in order
    std::uint64_t batches_ = 0;     //!< number of batches so far
    //! Longest evaluation that was not late, scaled to the usual effort [s].
    double longest_ = 0;
    double last_time_;      //!< clock time of the last call of now() [s]
    double running_ = 0;    //!< result of the last call of now() [s]
    std::string obstacle_;  //!< reason why a machine failed to evaluate
    bool has_reported_stop_ = false;
    bool is_dismissed_ = false;
};

//! Work that a coroutine awaits; see Dispatcher::evaluate().
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

    // The following functions allow coroutines to co_await a batch.
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
    //! Work with its latest attempt.
    std::map<std::uint64_t, Work> unanswered_;
    //! Not assigned; may be answered already.
    std::vector<std::uint64_t> waiting_;
    //! Precedence of the work fetched last.
    Dispatcher::Precedence precedence_;
    std::coroutine_handle<> awaiting_;
    std::exception_ptr failure_;
};

//! Makes the dispatcher of a job. A single rank evaluates with its threads.
//! With several ranks, rank 0 sends work to idle workers and sleeps in between.
//! Its threads evaluate only if each rank has several; otherwise its evaluator
//! provides only the schema. All references must outlive the dispatcher.
//! @param evaluators one for each thread, equally many on all ranks
std::unique_ptr<Dispatcher> make_dispatcher(const Session& session,
                                            const Evaluators& evaluators,
                                            const StopFlag& stop,
                                            const AnswerRules& rules = {});

//! Runs a worker rank: it receives work, evaluates it and replies, until rank 0
//! dismisses it. An Error in an evaluation becomes a failed outcome with the
//! error's message, cut to 160 bytes.
//! @throws Error if a message is neither work nor dismissal
void serve(const Session& session, const Evaluators& evaluators);

}  // namespace ideotype
