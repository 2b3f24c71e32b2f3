// SPDX-License-Identifier: Apache-2.0
#include <deque>
#include <filesystem>
#include <optional>
#include <unistd.h>

#include <fmt/format.h>

#include "comparison.hpp"
#include "ideotype/core/routine.hpp"
#include "parallel/dispatcher.hpp"
#include "ranks.hpp"
#include "run/machines.hpp"
#include "run/progress.hpp"
#include "run/run.hpp"
#include "verbs.hpp"

namespace ideotype {

namespace {

//! A task's generation is the case, its slot the plant.
class CompareEvaluator : public Evaluator {
  public:
    CompareEvaluator(const Comparison& comparison, const std::string& isa)
        : comparison_(comparison), device_(isa) {}

    const OutcomeSchema& schema(const Task& task) const override {
        return comparison_.plants.at(task.slot).schema;
    }

    //! All ranks have the plants: no genome is needed.
    Outcome evaluate(const Task& task, const Genome&) override {
        return ideotype::evaluate(comparison_, task.slot, task.generation,
                                  device_);
    }

  private:
    const Comparison& comparison_;
    Device device_;
};

//! Fills a comparison.
class Comparer : public Director {
  public:
    explicit Comparer(Comparison& comparison) : all_(comparison) {}
    ~Comparer() override {
        if (is_watched_) fmt::print(stderr, "\r\x1b[K");
    }

    //! @throws Error if one cannot be evaluated, or a stop is requested.
    void fill(Dispatcher& dispatcher) {
        dispatcher_ = &dispatcher;
        dispatcher.run(*this);
        routine_->result();
        if (done_ < all_.size())
            throw Error(fmt::format("stopped; {} of {} evaluations were done",
                                    done_, all_.size()));
    }

    bool start_next() override {
        if (routine_) return false;
        routine_.emplace(fill_all());
        routine_->start();
        return true;
    }
    void on_silence(const Task&, const std::string& what) override {
        fmt::print(stderr, "{}\n", what);
    }
    void on_stop(int) override {}

  private:
    Routine<bool> fill_all() {
        std::vector<Work> work;
        for (std::size_t c = 0; c < all_.cases.size(); ++c)
            for (std::size_t p = 0; p < all_.plants.size(); ++p) {
                Task task;
                task.generation = static_cast<std::uint32_t>(c);
                task.slot = static_cast<std::uint32_t>(p);
                task.is_final = true;
                work.push_back({task, {}});
            }
        co_await dispatcher_->evaluate(
            std::move(work), [this](const Work& done, const Outcome& outcome) {
                record(done.task, outcome);
            });
        co_return true;
    }

    void record(const Task& task, const Outcome& outcome) {
        if (outcome.status != Status::done)
            throw Error(fmt::format("{} in {}: {}", all_.plants[task.slot].name,
                                    all_.cases[task.generation].name,
                                    outcome.message));
        all_.outcomes[task.slot][task.generation] = outcome;
        ++done_;
        if (is_watched_)
            fmt::print(stderr, "\r\x1b[K{} of {} evaluated", done_,
                       all_.size());
    }

    Comparison& all_;
    std::size_t done_ = 0;
    const bool is_watched_ = columns_of(STDERR_FILENO) > 0;
    Dispatcher* dispatcher_ = nullptr;  //!< while filling
    std::optional<Routine<bool>> routine_;
};

ExitCode compare_and_tell(Comparison& comparison, Dispatcher& dispatcher,
                          const CompareOptions& options) {
    Comparer(comparison).fill(dispatcher);
    if (!options.csv_path.empty()) write_csv(options.csv_path, comparison);
    if (options.is_json)
        fmt::print("{}\n", to_text(to_json(comparison)));
    else
        print(comparison);
    return ExitCode::ok;
}

Comparison read(const CompareOptions& options) {
    if (!options.csv_path.empty() && std::filesystem::exists(options.csv_path))
        throw Error(fmt::format("{}: exists already and is not overwritten",
                                options.csv_path),
                    ExitCode::refused);
    return read_comparison(options);
}

//! Returns what this rank has read, if all could read theirs.
//! @throws Error of what could not be read, on rank 0 if it could not.
std::optional<Comparison> read_on_all(const Session& session,
                                      const CompareOptions& options) {
    std::optional<Comparison> comparison;
    std::exception_ptr failure;
    try {
        comparison = read(options);
        if (comparison->size() == 1 && session.size() > 1)
            throw Error(
                fmt::format("compare: one plant in one case is one "
                            "evaluation, which {} ranks cannot share; start "
                            "it without mpirun or srun",
                            session.size()),
                ExitCode::usage);
    } catch (...) {
        failure = std::current_exception();
    }
    const bool has_any_failed = session.largest(failure ? 1 : 0) != 0;
    const bool has_first_failed =
        !session.broadcast(failure ? "failed" : "").empty();
    if (failure && (session.rank() == 0 || !has_first_failed))
        std::rethrow_exception(failure);
    if (has_any_failed) return std::nullopt;
    return comparison;
}

//! Collective over all ranks, which share plants and cases.
ExitCode share(const CompareOptions& options, const Session& session,
               const StopFlag& stop) {
    auto comparison = read_on_all(session, options);
    if (!comparison) return ExitCode::ok;
    const std::string isa = session.broadcast(Device::supported_isas().back());
    std::deque<CompareEvaluator> own_evaluators;
    Evaluators evaluators;
    for (int i = threads_per_rank(session, options.threads); i > 0; --i)
        evaluators.push_back(&own_evaluators.emplace_back(*comparison, isa));
    return share_work(
        session, evaluators, stop, answer_rules(comparison->under),
        [&](Dispatcher& dispatcher) {
            return compare_and_tell(*comparison, dispatcher, options);
        });
}

}  // namespace

ExitCode compare(const CompareOptions& options) {
    const StopFlag stop;
    return share(options, start_session(), stop);
}

}  // namespace ideotype
