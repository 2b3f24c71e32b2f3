// SPDX-License-Identifier: Apache-2.0
#include "progress.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fcntl.h>
#include <unistd.h>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/ioctl.h>

#include "ideotype/canopy/quantities.hpp"

namespace ideotype {

namespace {

//! Between two live lines [s].
constexpr double calm = 0.1;

}  // namespace

double now() {
    using SteadyClock = std::chrono::steady_clock;
    return std::chrono::duration<double>(SteadyClock::now().time_since_epoch())
        .count();
}

std::string format(Estimate x) {
    if (!std::isfinite(x.mean)) return "unknown";
    const double error = std::abs(x.standard_error);
    const double mean = std::abs(x.mean);
    if (!std::isfinite(error)) return fmt::format("{:.6g}", x.mean);
    // Less than this is what rounding leaves of zero, and of an error.
    constexpr double nothing = 1e-12, exact = 1e-9, small = 1e-4;
    if (mean < nothing && error < nothing) return "0";
    if (error <= exact * mean)
        return fmt::format("{:.{}g}", x.mean, mean < small ? 3 : 9);
    const int digits = 1 - static_cast<int>(std::floor(std::log10(error)));
    if (mean < small && error < small)
        return fmt::format("{:.1e} +- {:.1e}", x.mean, error);
    std::string text = fmt::format("{:.{}f}", x.mean, std::max(digits, 0));
    if (text.find_first_of("123456789") == text.npos && text[0] == '-')
        text.erase(0, 1);
    return fmt::format("{} +- {:.{}f}", text, error, std::max(digits, 0));
}

std::string format_duration(double seconds) {
    const auto s = static_cast<long long>(std::llround(seconds));
    if (s >= 3600)
        return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
    return fmt::format("{}:{:02}", s / 60, s % 60);
}

std::string progress_line(const JobProgress& progress, std::size_t columns) {
    // In the order of the line; the higher the rank, the sooner it is left
    // out.
    struct Part {
        std::string text;
        int rank;
    };
    std::vector<Part> parts;
    const auto add = [&](int rank, std::string text) {
        parts.push_back({std::move(text), rank});
    };
    if (progress.cases > 1)
        add(0,
            fmt::format("{} of {} cases done", progress.ended, progress.cases));
    if (progress.in_flight > 1)
        add(8, fmt::format(", {} in flight", progress.in_flight));
    if (progress.left)
        add(1, fmt::format(", {} left", format_duration(*progress.left)));
    add(6,
        fmt::format(", {:.1f} evaluations/s", progress.evaluations_per_second));
    add(5, ", " + progress.name);
    add(3, fmt::format(", {} of {} generations", progress.complete,
                       progress.generations));
    if (progress.best) {
        const std::string best = format(*progress.best);
        const std::size_t end = std::min(best.find(" +- "), best.size());
        add(0, ", best " + best.substr(0, end));
        add(4, best.substr(end));
        add(2, " " + progress.unit);
    }
    if (progress.hypervolume)
        add(7, ", hypervolume " + format(*progress.hypervolume));
    const auto line = [&] {
        std::string all;
        for (const Part& each : parts) all += each.text;
        return all.starts_with(", ") ? all.substr(2) : all;
    };
    while (line().size() > columns && parts.size() > 1)
        parts.erase(std::ranges::max_element(parts, {}, &Part::rank));
    return line().substr(0, columns);
}

std::string utc_now() {
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                       fmt::gmtime(std::time(nullptr)));
}

LiveLine::LiveLine(LogLevel level)
    : is_terminal_(level >= LogLevel::info && isatty(STDERR_FILENO) == 1) {}

LiveLine::~LiveLine() {
    if (shown_ > 0) fmt::print(stderr, "\r\x1b[K");
}

void LiveLine::show(const std::string& text) {
    if (!is_terminal_ || now() - shown_ < calm) return;
    fmt::print(stderr, "\r\x1b[K{}", text);
    shown_ = now();
}

namespace {

//! Width of this terminal, 0 if it is none.
int columns_of(int file) {
    if (isatty(file) != 1) return 0;
    struct winsize size {};
    const bool is_known =
        ioctl(file, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return is_known ? size.ws_col : 80;
}

//! Width of the terminal on which somebody watches standard output, 0 if there
//! is none. Open MPI gives its ranks a terminal whatever its own output is, so
//! there mpirun's is what counts.
int watched_columns() {
    const int columns = columns_of(STDOUT_FILENO);
    if (columns == 0 || std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr)
        return columns;
    const int starter = open(fmt::format("/proc/{}/fd/1", getppid()).c_str(),
                             O_WRONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (starter < 0) return 0;
    const int width = columns_of(starter);
    close(starter);
    return width;
}

}  // namespace

//! Sees one case.
class ProgressLog::CaseWatcher : public Watcher {
  public:
    CaseWatcher(ProgressLog& log, int index)
        : log_(log),
          entry_(log.in_flight_.at(index)),
          to_evaluate_(log.to_evaluate_.at(index)) {}

    void on_evaluation(const Task& task, const Outcome& outcome) override {
        log_.print(
            fmt::format("{}  {} slot {}: worker {}, {:.4f} s, {}", entry_.name,
                        task.is_final
                            ? "final"
                            : fmt::format("generation {}", task.generation),
                        task.slot, outcome.worker, outcome.seconds,
                        outcome.status == Status::done
                            ? format(outcome.objectives.front())
                            : "failed: " + outcome.message),
            LogLevel::debug);
        if (task.is_final) return;
        entry_.generation = task.generation;
        ++log_.evaluations_;
        to_evaluate_ = std::max(0LL, to_evaluate_ - 1);
        log_.show_live();
    }

    void on_generation(std::uint32_t generation,
                       const GenerationSummary& summary) override {
        entry_.generation = generation;
        ++entry_.complete;
        entry_.best = {summary.best, summary.best_standard_error};
        entry_.violation = summary.violation;
        if (!std::isnan(summary.hypervolume))
            entry_.hypervolume = {summary.hypervolume,
                                  summary.hypervolume_standard_error};
        to_evaluate_ = log_.all_after(generation + 1);
        std::string line = log_.text(entry_);
        if (summary.failures > 0)
            line += fmt::format("  {} failed", summary.failures);
        if (log_.columns_ == 0) log_.print(line);
        log_.show_live();
    }

    void on_final(const std::string& reason) override {
        to_evaluate_ = 0;
        log_.print(fmt::format(
            "{}  ended by {}; evaluating finalists with fresh random numbers",
            entry_.name, reason));
    }

  private:
    ProgressLog& log_;
    Entry& entry_;
    long long& to_evaluate_;
};

std::string certainty(bool is_evaluated_again, double violation) {
    return fmt::format(
        "({}evaluated again{})", is_evaluated_again ? "" : "not ",
        violation > 0
            ? fmt::format("; fails its constraints by {:.3g}", violation)
            : "");
}

ProgressLog::ProgressLog(const Campaign& campaign,
                         const std::vector<Case>& chosen, LogLevel level)
    : campaign_(campaign),
      level_(level),
      columns_(watched_columns()),
      started_(now()),
      cases_(static_cast<int>(chosen.size())) {
    for (const Case& each : chosen) to_evaluate_[each.index] = all_after(0);
}

ProgressLog::~ProgressLog() {
    if (is_live_) std::puts("");
}

std::unique_ptr<Watcher> ProgressLog::watch(const Case& chosen,
                                            std::uint32_t generation) {
    in_flight_[chosen.index] = {chosen.name, generation, generation, {}, {}};
    to_evaluate_[chosen.index] = all_after(generation);
    return std::make_unique<CaseWatcher>(*this, chosen.index);
}

void ProgressLog::end(const Case& chosen) {
    ++ended_;
    in_flight_.erase(chosen.index);
    to_evaluate_[chosen.index] = 0;
}

void ProgressLog::print(const std::string& text, LogLevel level) {
    if (level > level_) return;
    if (level_ >= LogLevel::info) return print_result(text);
    Log(level_).write(level, text);
}

void ProgressLog::print_result(const std::string& text) {
    const std::string before = columns_ > 0 ? "" : utc_now() + "  ";
    fmt::print("{}{}{}\n", is_live_ ? "\r\x1b[K" : "", before, text);
    std::fflush(stdout);
    is_live_ = false;
}

long long ProgressLog::all_after(std::uint32_t generation) const {
    return (campaign_.stop.generations - static_cast<long long>(generation)) *
           campaign_.search.population;
}

JobProgress ProgressLog::progress_of(const Entry& entry) const {
    const double seconds = std::max(now() - started_, 1e-3);
    long long left = 0;
    for (const auto& [index, count] : to_evaluate_) left += count;
    JobProgress progress{cases_,
                         ended_,
                         static_cast<int>(in_flight_.size()),
                         entry.name,
                         entry.complete,
                         static_cast<std::uint32_t>(campaign_.stop.generations),
                         entry.best,
                         unit_of(aims(campaign_).front().quantity),
                         entry.hypervolume,
                         evaluations_ / seconds,
                         {}};
    if (evaluations_ > 0)
        progress.left = static_cast<double>(left) * seconds / evaluations_;
    return progress;
}

//! A line of a log file.
std::string ProgressLog::text(const Entry& entry) const {
    const JobProgress progress = progress_of(entry);
    std::string line = fmt::format(
        "{}  generation {}, {} of {} complete, {} left, {:.1f} evaluations/s, "
        "best {} {} {}",
        entry.name, entry.generation, entry.complete, progress.generations,
        progress.left ? format_duration(*progress.left) : "?",
        progress.evaluations_per_second, format(entry.best.value()),
        progress.unit, certainty(false, entry.violation));
    if (entry.hypervolume)
        line += fmt::format(", hypervolume {}", format(*entry.hypervolume));
    return line;
}

//! The case that comes first stands for those in flight.
void ProgressLog::show_live() {
    if (columns_ == 0 || level_ < LogLevel::info || in_flight_.empty() ||
        now() - shown_ < calm)
        return;
    // A line that wraps could not be written over.
    fmt::print("\r\x1b[K{}",
               progress_line(progress_of(in_flight_.begin()->second),
                             static_cast<std::size_t>(columns_ - 1)));
    std::fflush(stdout);
    shown_ = now();
    is_live_ = true;
}

}  // namespace ideotype
