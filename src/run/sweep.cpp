// SPDX-License-Identifier: Apache-2.0
#include "sweep.hpp"

#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "provenance.hpp"
#include "run/job/masters.hpp"
#include "run/job/way_on.hpp"

namespace ideotype {

namespace fs = std::filesystem;

std::string path_of(const std::string& out, const Campaign& campaign,
                    const CaseName& chosen) {
    if (out.empty())
        throw Error("--out is empty; name a folder, or . for this one",
                    ExitCode::usage);
    return (fs::path(out) / campaign.spec.name / (chosen.name + ".h5"))
        .string();
}

Sweep::Sweep(const RunOptions& options, const Campaign& campaign,
             const Cases& chosen, const std::string& isa, int ranks,
             StopFlag& stop)
    : options_(options),
      campaign_(campaign),
      chosen_(chosen),
      isa_(isa),
      ranks_(ranks),
      stop_(stop),
      progress_(campaign, chosen, options.level) {}

bool Sweep::evolve(Dispatcher& dispatcher) {
    dispatcher_ = &dispatcher;
    if (const auto advice =
            advice_for(campaign_, chosen_.size(), dispatcher.width()))
        progress_.print(*advice, LogLevel::warning);
    try {
        dispatcher.run(*this);
    } catch (const Error& error) {
        throw Error(
            fmt::format("{}\nresume with\n  {}", error.what(),
                        way_on(options_.command, ranks_, options_.launcher)),
            error.exit_code());
    }
    tell_together();
    report_failures();
    report_in_use();
    if (finished_ + in_use_.size() == chosen_.size()) return true;
    progress_.print(
        fmt::format("stopped before the end: {} of {} cases are "
                    "finished",
                    finished_, chosen_.size()));
    if (!has_said_how_to_go_on_) on_stop(0);
    return false;
}

bool Sweep::start_next() {
    running_.remove_if([](const auto& each) { return each.has_ended(); });
    if (next_ == chosen_.size()) return false;
    running_.push_back(evolve_guarded(chosen_[next_++]));
    running_.back().start();
    return true;
}

void Sweep::on_silence(const Task& task, const std::string& message) {
    progress_.print(
        cases(campaign_).name(task.case_index).name + "  " + message,
        LogLevel::warning);
}

void Sweep::on_stop(int in_flight) {
    has_said_how_to_go_on_ = true;
    const std::string pending =
        in_flight > 0
            ? fmt::format("stopping after the evaluations in flight ({}){}; ",
                          in_flight,
                          progress_.is_on_terminal()
                              ? ", Ctrl-C again stops at once"
                              : "")
            : "";
    progress_.print(
        fmt::format("{}resume with\n  {}", pending,
                    way_on(options_.command, ranks_, options_.launcher)));
}

//! Evolves a case, and records its failure. The parameter is a copy, which
//! exists as long as this coroutine.
Routine<Ending> Sweep::evolve_guarded(Case chosen) {
    try {
        const Ending ending = co_await evolve_one(chosen);
        if (ending == Ending::finished) ++finished_;
    } catch (const InUseError& error) {
        note_in_use(chosen, error);
    } catch (const std::exception& error) {
        note_failure(chosen, error);
    }
    co_return Ending::drained;
}

Routine<Ending> Sweep::evolve_one(const Case& chosen) {
    History history = open_history(chosen);
    const bool was_finished = history.finished().has_value();
    if (!was_finished) {
        history.begin_session(session_record(options_.command, ranks_));
        const double began = now();
        const auto watcher =
            progress_.watch(chosen, history.next_generation(),
                            static_cast<long long>(history.plants()));
        const auto optimizer = make_optimizer(
            campaign_.search, search_space(campaign_, chosen), chosen.seed);
        const Evolution evolution{
            campaign_,    chosen,   *optimizer,
            *dispatcher_, *watcher, [began] { return now() - began; }};
        const Ending ending = co_await evolve_case(evolution, history);
        if (ending == Ending::drained) {
            // Report an error if the file was deleted after its last write.
            history.require_in_place();
            history.close();
            co_return ending;
        }
    }
    progress_.end(chosen);
    const std::string path = path_of(options_.out, campaign_, chosen);
    const CaseResult result = result_of(history);
    bounds_.add(result.bounds);
    if (result.failed_finalists == result.finalists)
        throw CaseError(fmt::format(
            "{}: {} of {} finalists failed; the first reason: {}", path,
            result.failed_finalists, result.finalists, result.failure));
    if (chosen_.size() > 1)
        tell(result, chosen.name, was_finished);
    else
        progress_.print_result(was_finished
                                   ? to_text(result, path, "finished before")
                                   : to_text(result, path, "finished") +
                                         left_to_gain(history, campaign_));
    history.close();
    co_return Ending::finished;
}

//! Prints a line about a case that has ended. Cases that were finished before,
//! and cases too many for a terminal, are only counted.
void Sweep::tell(const CaseResult& result, const std::string& name,
                 bool was_finished) {
    before_ += was_finished ? 1 : 0;
    if (!result.doubt.empty() && doubts_++ == 0)
        doubt_ = fmt::format("{}: {}", name, result.doubt);
    const bool has_room =
        chosen_.size() <= lines_on_screen || !progress_.is_on_terminal();
    if (!was_finished && has_room)
        progress_.print_result(in_short(result, name));
}

void Sweep::tell_together() {
    if (doubts_ > 0)
        progress_.print(
            doubt_ + (doubts_ == 1
                          ? std::string()
                          : fmt::format(
                                "; likewise the best plants of {} other cases",
                                doubts_ - 1)),
            LogLevel::warning);
    if (before_ > 0)
        progress_.print(fmt::format("{} of {} cases were finished before",
                                    before_, chosen_.size()));
}

History Sweep::open_history(const Case& chosen) const {
    const std::string path = path_of(options_.out, campaign_, chosen);
    if (history_exists(path)) return resume_history(chosen, path);
    const fs::path folder = fs::path(path).parent_path();
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure)
        throw Error(fmt::format(
            "{}: this folder cannot be created: {}; choose another with --out",
            folder.string(), failure.message()));
    return History::create(path, header_of(campaign_, chosen, isa_));
}

//! Opens the history of a case to resume it. The history is checked again,
//! since another job may have begun the case after the first check.
History Sweep::resume_history(const Case& chosen,
                              const std::string& path) const {
    History history = History::resume(path);
    if (history.finished()) {
        require_same_campaign(history.header(), campaign_, chosen, path);
        return history;
    }
    require_resumable(history.header(), campaign_, chosen, path);
    const std::string& isa = history.header().text.at("isa");
    if (isa != isa_)
        throw Error(
            fmt::format("{}: this history was begun with instruction set {}, "
                        "but this job uses {}; resume it alone with --case {}",
                        path, isa, isa_, chosen.index),
            ExitCode::refused);
    return history;
}

//! Records that another job is working on a case. This is a failure only if
//! there is no other case.
void Sweep::note_in_use(const Case& chosen, const InUseError& error) {
    if (chosen_.size() == 1) return note_failure(chosen, error);
    in_use_.push_back(chosen.name);
    progress_.end(chosen);
    progress_.print(fmt::format("{}  skipped: {}", chosen.name, error.what()),
                    LogLevel::warning);
}

//! Stores the exception being handled. If its cause is outside the case, such
//! as a full disk, all other cases are stopped too.
void Sweep::note_failure(const Case& chosen, const std::exception& error) {
    failures_.push_back(
        {chosen.name, describe_exception(error), std::current_exception()});
    progress_.end(chosen);
    if (chosen_.size() > 1)
        progress_.print(fmt::format("{}  failed: {}", chosen.name,
                                    describe_exception(error)),
                        LogLevel::error);
    const auto* known = dynamic_cast<const Error*>(&error);
    const bool is_of_case =
        dynamic_cast<const CaseError*>(&error) != nullptr ||
        (known != nullptr && known->exit_code() == ExitCode::refused);
    if (!is_of_case) stop_.request();
}

//! Prints the cases on which other programs are working.
//! @throws Error (refused) if other programs are working on all cases.
void Sweep::report_in_use() {
    if (in_use_.empty()) return;
    const std::string message =
        fmt::format("other programs work on {} of {} cases: {}", in_use_.size(),
                    chosen_.size(), fmt::join(in_use_, ", "));
    if (in_use_.size() == chosen_.size())
        throw Error(message + "; see ideotype status " + options_.out,
                    ExitCode::refused);
    progress_.print(message, LogLevel::warning);
}

void Sweep::report_failures() const {
    if (failures_.empty()) return;
    if (chosen_.size() == 1) std::rethrow_exception(failures_.front().cause);
    std::string message =
        fmt::format("{} of {} cases failed, {} finished:", failures_.size(),
                    chosen_.size(), finished_);
    for (const Failure& each : failures_)
        message += fmt::format("\n{}: {}", each.name, each.reason);
    throw Error(
        fmt::format("{}\nwhen the causes are fixed, resume with\n  {}", message,
                    way_on(options_.command, ranks_, options_.launcher)));
}

}  // namespace ideotype
