// SPDX-License-Identifier: Apache-2.0
#include <deque>
#include <map>
#include <unistd.h>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/formats/lines.hpp"
#include "cli/ranks.hpp"
#include "genome_request.hpp"
#include "ideotype/core/routine.hpp"
#include "parallel/dispatcher.hpp"
#include "run/job/machines.hpp"
#include "run/progress.hpp"
#include "run/run.hpp"
#include "stand/stand.hpp"

namespace ideotype {

namespace {

//! Interval at which the input is polled while evaluations are in flight [s].
//! Polling more often would slow the evaluations.
constexpr double attention = 1e-3;

//! Interval at which the input is polled while no evaluation is in flight [s].
constexpr double patience = 0.25;

//! Evaluates the genomes of requests. The case must outlive the evaluator.
class RequestEvaluator : public Evaluator {
  public:
    //! @throws Error if the processor does not support the instruction set.
    RequestEvaluator(const ServedCase& served, const std::string& isa)
        : served_(served),
          stand_(served.campaign, served.chosen),
          device_(isa) {}

    const OutcomeSchema& schema(const Task&) const override {
        return served_.schema;
    }

    Outcome evaluate(const Task& task, const Genome& genome) override {
        Outcome outcome = stand_.evaluate(
            grow(served_.campaign, genome),
            sampling_of(task, served_.campaign, served_.chosen), device_);
        outcome.randomisations.clear();
        return outcome;
    }

  private:
    const ServedCase& served_;
    Stand stand_;
    Device device_;
};

//! Answers requests until the input ends. The number of requests in flight is
//! at most that of the workers.
class Service : public Director {
  public:
    Service(const ServedCase& served, const StopFlag& stop, const Log& log)
        : served_(served), stop_(stop), log_(log) {}

    //! @throws Error if the output has been closed by its reader.
    ExitCode run(Dispatcher& dispatcher) {
        dispatcher_ = &dispatcher;
        const double began = now();
        write(hello(served_, dispatcher.width()));
        dispatcher.run(*this);
        service_->result();
        const double seconds = now() - began;
        log_.write(LogLevel::info,
                   fmt::format("{} genomes evaluated in {} ({:.1f} evaluations "
                               "per second); {} lines failed",
                               done_, format_duration(seconds),
                               static_cast<double>(done_) / seconds, failed_));
        if (!stop_.requested() || reader_.has_ended()) return ExitCode::ok;
        log_.write(LogLevel::warning, "stopped before the end of the input");
        return ExitCode::stopped;
    }

    bool start_next() override {
        if (service_) return false;
        service_.emplace(answer_all());
        service_->start();
        return true;
    }

    void on_silence(const Task& task, const std::string& message) override {
        log_.write(LogLevel::warning,
                   fmt::format("line {}: {}", task.slot, message));
    }

    void on_stop(int in_flight) override {
        log_.write(LogLevel::info,
                   fmt::format("stopping after the evaluations in flight ({})",
                               in_flight));
    }

  private:
    Routine<bool> answer_all() {
        co_await dispatcher_->evaluate(
            [this] { return next(); },
            [this](const Work& work, const Outcome& outcome) {
                record(work.task, outcome);
            });
        co_return true;
    }

    //! Returns the next genome to evaluate, if there is one. It waits for input
    //! only if nothing is in flight, since waiting would delay answers.
    std::optional<Work> next() {
        while (!stop_.requested() && !reader_.has_ended()) {
            const bool is_idle = in_flight_.empty();
            const auto line = reader_.next(is_idle ? patience : 0);
            if (line)
                if (auto request = read(*line)) {
                    Work work{request->task, request->genome};
                    in_flight_.emplace(work.task.slot, *std::move(request));
                    return work;
                }
            if (!is_idle) return std::nullopt;
        }
        return std::nullopt;
    }

    //! Parses the request in a line. Returns nothing if the line is empty or
    //! the request is refused.
    std::optional<GenomeRequest> read(const Line& line) {
        if (line.text.find_first_not_of(" \t\r") == std::string::npos &&
            !line.is_cut)
            return std::nullopt;
        Json id;
        try {
            if (line.is_cut)
                throw Error(fmt::format(
                    "this line is longer than {} bytes; send shorter ones",
                    LineReader::longest));
            const Json json = parse_line(line.text);
            id = id_of(json);
            GenomeRequest request = read_request(json, served_);
            request.line = line.number;
            request.task.slot = static_cast<std::uint32_t>(line.number);
            return request;
        } catch (const Error& error) {
            ++failed_;
            write(refusal(id, line.number, error.what()));
            return std::nullopt;
        }
    }

    void record(const Task& task, const Outcome& outcome) {
        const auto entry = in_flight_.find(task.slot);
        ++(outcome.status == Status::done ? done_ : failed_);
        write(answer(entry->second, outcome, served_.schema));
        log_.write(
            LogLevel::debug,
            fmt::format("line {}: worker {}, {:.4f} s", entry->second.line,
                        outcome.worker, outcome.seconds));
        in_flight_.erase(entry);
    }

    void write(const Json& json) const { writer_.write(to_line(json)); }

    const ServedCase& served_;
    const StopFlag& stop_;
    const Log& log_;
    LineReader reader_{STDIN_FILENO};
    LineWriter writer_;
    std::map<std::uint32_t, GenomeRequest> in_flight_;  //!< requests by slot
    long long done_ = 0, failed_ = 0;
    Dispatcher* dispatcher_ = nullptr;  //!< dispatcher while running
    std::optional<Routine<bool>> service_;
};

//! Serves a campaign. Collective over all ranks.
ExitCode serve_on(const Session& session, const ServeOptions& options,
                  const StopFlag& stop, const Log& log) {
    const std::vector<Machine> machines =
        gather_machines(session, this_machine());
    const auto [isa, resolved] = agree(session, [&]() -> Start {
        require_same_program(machines);
        const Campaign read =
            read_campaign(options.campaign_path, options.settings);
        print_warnings(read, log);
        // The constructor throws if the case does not exist.
        const ServedCase served(read, options.case_index,
                                options.campaign_path);
        return {choose_isa(machines, std::nullopt, ""), read.resolved};
    });
    if (isa.empty()) return ExitCode::ok;  // rank 0 reports the reason
    const Campaign campaign = parse_campaign(resolved, options.campaign_path);
    const ServedCase served(campaign, options.case_index,
                            options.campaign_path);
    std::deque<RequestEvaluator> own_evaluators;
    Evaluators evaluators;
    for (int i = threads_per_rank(session, options.threads); i > 0; --i)
        evaluators.push_back(&own_evaluators.emplace_back(served, isa));
    AnswerRules rules = answer_rules(campaign);
    rules.attention = attention;
    return share_work(session, evaluators, stop, rules,
                      [&](Dispatcher& dispatcher) {
                          return Service(served, stop, log).run(dispatcher);
                      });
}

}  // namespace

ExitCode serve(const ServeOptions& options) {
    StopFlag stop;
    const Log log(options.level);
    const Session session = start_session();
    return on_ranks(session, log,
                    [&] { return serve_on(session, options, stop, log); });
}

}  // namespace ideotype
