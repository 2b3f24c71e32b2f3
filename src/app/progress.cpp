#include "ideotype/app/progress.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>

namespace ideotype {

namespace {

//! Between two live lines [s].
constexpr double calm = 0.1;

}  // namespace

double now() {
    using Clock = std::chrono::steady_clock;
    return std::chrono::duration<double>(Clock::now().time_since_epoch())
        .count();
}

std::string format(Estimate x) {
    const double error = std::abs(x.standard_error);
    if (!std::isfinite(error)) return fmt::format("{:.6g}", x.mean);
    if (error == 0) return fmt::format("{:.9g}", x.mean);
    const int digits =
        std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 12);
    return fmt::format("{:.{}f} +- {:.{}f}", x.mean, digits, error, digits);
}

std::string format_duration(double seconds) {
    const auto s = static_cast<long long>(std::llround(seconds));
    if (s >= 3600)
        return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
    return fmt::format("{}:{:02}", s / 60, s % 60);
}

LiveLine::LiveLine() : is_terminal_(isatty(STDERR_FILENO) == 1) {}

LiveLine::~LiveLine() {
    if (shown_ > 0) fmt::print(stderr, "\r\x1b[K");
}

void LiveLine::show(const std::string& text) {
    if (!is_terminal_ || now() - shown_ < calm) return;
    fmt::print(stderr, "\r\x1b[K{}", text);
    shown_ = now();
}

namespace {

//! Whether somebody watches standard output. Open MPI gives its ranks a
//! terminal whatever its own output is, so there mpirun's is what counts.
bool is_watched() {
    if (isatty(STDOUT_FILENO) != 1) return false;
    if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr) return true;
    const int starter = open(fmt::format("/proc/{}/fd/1", getppid()).c_str(),
                             O_WRONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (starter < 0) return false;
    const bool is_terminal = isatty(starter) == 1;
    close(starter);
    return is_terminal;
}

}  // namespace

//! Sees one case.
class ProgressLog::CaseWatcher : public Watcher {
  public:
    CaseWatcher(ProgressLog& log, int index)
        : log_(log),
          entry_(log.in_flight_.at(index)),
          to_evaluate_(log.to_evaluate_.at(index)) {}

    void on_evaluation(std::uint32_t generation) override {
        entry_.generation = generation;
        ++log_.evaluations_;
        to_evaluate_ = std::max(0LL, to_evaluate_ - 1);
        log_.show_live();
    }

    void on_generation(std::uint32_t generation,
                       const GenerationSummary& summary) override {
        entry_.generation = generation;
        entry_.best = format({summary.best, summary.best_standard_error}) +
                      " MJ m-2 day-1";
        to_evaluate_ = log_.all_after(generation + 1);
        std::string line = log_.text(entry_);
        if (summary.failures > 0)
            line += fmt::format("  {} failed", summary.failures);
        if (!log_.is_terminal_) log_.print(line);
        log_.show_live();
    }

    void on_final(const std::string& reason) override {
        to_evaluate_ = 0;
        log_.print(fmt::format(
            "{}  ended by {}; evaluating the best anew with fresh random "
            "numbers",
            entry_.name, reason));
    }

  private:
    ProgressLog& log_;
    Entry& entry_;
    long long& to_evaluate_;
};

ProgressLog::ProgressLog(const Campaign& campaign,
                         const std::vector<Case>& chosen)
    : campaign_(campaign),
      is_terminal_(is_watched()),
      started_(now()),
      cases_(static_cast<int>(chosen.size())) {
    for (const Case& each : chosen) to_evaluate_[each.index] = all_after(0);
}

ProgressLog::~ProgressLog() {
    if (is_live_) std::puts("");
}

std::unique_ptr<Watcher> ProgressLog::watch(const Case& chosen,
                                            std::uint32_t generation) {
    in_flight_[chosen.index] = {chosen.name, generation, "-"};
    to_evaluate_[chosen.index] = all_after(generation);
    return std::make_unique<CaseWatcher>(*this, chosen.index);
}

void ProgressLog::end(const Case& chosen) {
    ++ended_;
    in_flight_.erase(chosen.index);
    to_evaluate_[chosen.index] = 0;
}

void ProgressLog::print(const std::string& text) {
    fmt::print("{}{}\n", is_live_ ? "\r\x1b[K" : "", text);
    std::fflush(stdout);
    is_live_ = false;
}

long long ProgressLog::all_after(std::uint32_t generation) const {
    return (campaign_.stop.generations - static_cast<long long>(generation)) *
           campaign_.optimizer.population;
}

std::string ProgressLog::text(const Entry& entry) const {
    const double seconds = std::max(now() - started_, 1e-3);
    const double rate = evaluations_ / seconds;
    long long left = 0;
    for (const auto& [index, count] : to_evaluate_) left += count;
    return fmt::format(
        "{}  generation {}/{}  best {}  {:.1f} evaluations/s  {} left",
        entry.name, entry.generation + 1, campaign_.stop.generations,
        entry.best, rate,
        rate > 0 ? format_duration(static_cast<double>(left) / rate) : "?");
}

//! The case that comes first stands for those in flight.
void ProgressLog::show_live() {
    if (!is_terminal_ || in_flight_.empty() || now() - shown_ < calm) return;
    const std::string cases =
        cases_ == 1 ? ""
                    : fmt::format("{} of {} cases done, {} in flight  ", ended_,
                                  cases_, in_flight_.size());
    fmt::print("\r\x1b[K{}{}", cases, text(in_flight_.begin()->second));
    std::fflush(stdout);
    shown_ = now();
    is_live_ = true;
}

}  // namespace ideotype
