// SPDX-License-Identifier: Apache-2.0
#include "progress.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <unistd.h>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "ideotype/canopy/quantities.hpp"
#include "ideotype/core/text.hpp"
#include "parallel/rank_clock.hpp"
#include "summary.hpp"

namespace ideotype {

double now() {
    return machine_clock.now();
}

std::string with_unit(const std::string& number, const std::string& unit) {
    return unit == "1" ? number : number + ' ' + unit;
}

std::string format(Estimate x) {
    if (!std::isfinite(x.mean)) return "unknown";
    const double error = normal_95 * std::abs(x.standard_error);
    const double mean = std::abs(x.mean);
    if (!std::isfinite(error)) return fmt::format("{:.6g}", x.mean);
    // Limits below which numbers are zero up to rounding, and relative errors
    // are negligible.
    constexpr double nothing = 1e-12, exact = 1e-9, small = 1e-4;
    if (mean < nothing && error < nothing) return "0";
    if (error <= exact * mean)
        return fmt::format("{:.{}g}", x.mean, mean < small ? 3 : 9);
    const int digits = 1 - static_cast<int>(std::floor(std::log10(error)));
    if (mean < small && error < small)
        return fmt::format("{:.1e} ± {:.1e}", x.mean, error);
    std::string text = fmt::format("{:.{}f}", x.mean, std::max(digits, 0));
    if (text.find_first_of("123456789") == text.npos && text[0] == '-')
        text.erase(0, 1);
    return fmt::format("{} ± {:.{}f}", text, error, std::max(digits, 0));
}

std::string format_duration(double seconds) {
    const auto s = static_cast<long long>(std::llround(seconds));
    if (s >= 3600)
        return fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
    return fmt::format("{}:{:02}", s / 60, s % 60);
}

std::string line_with_bar(double done, const std::vector<std::string>& parts,
                          std::size_t width) {
    constexpr std::size_t least = 12, most = 42;  // bar with brackets [columns]
    std::string words;
    for (const std::string& part : parts)
        if (words.empty() ||
            count_columns(words) + count_columns(part) + least + 2 <= width)
            words += (words.empty() ? "" : ", ") + part;
    const std::size_t columns = count_columns(words);
    if (columns + least > width) return fmt::format("{:.{}}", words, width);
    const std::size_t bar = std::min(width - columns, most) - 3;
    const auto full = static_cast<std::size_t>(std::clamp(done, 0., 1.) *
                                               static_cast<double>(bar));
    return fmt::format("[{:.<{}}] {}", std::string(full, '#'), bar, words);
}

std::string utc_now() {
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                       fmt::gmtime(std::time(nullptr)));
}

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

    void on_generation(std::uint32_t generation, std::uint32_t plants,
                       const GenerationSummary& summary) override {
        entry_.generation = generation;
        entry_.plants += plants;
        // In a sensitivity study, the largest objective is not a result.
        const bool is_study = log_.campaign_.search.design.has_value();
        if (!is_study) entry_.best = summary.expected_best;
        if (!std::isnan(summary.hypervolume))
            entry_.hypervolume = {summary.hypervolume,
                                  summary.hypervolume_standard_error};
        to_evaluate_ = log_.most_plants() - entry_.plants;
        std::string line = fmt::format(
            "{}  generation {}, {} of {} plants, time left {}, {:.1f} "
            "evaluations per second",
            entry_.name, generation, entry_.plants, log_.most_plants(),
            log_.time_left(), log_.evaluations_per_second());
        if (!is_study)
            line += fmt::format(", {} {}", log_.best_of(entry_),
                                certainty(false, summary.violation));
        if (summary.failures > 0)
            line += fmt::format("  {} failed", summary.failures);
        if (log_.columns_ == 0) log_.print(line);
        log_.show_live();
    }

    void on_final(const std::string& reason) override {
        to_evaluate_ = 0;
        // With several cases, the live line already shows this.
        if (log_.columns_ > 0 && log_.cases_ > 1) return;
        log_.print(log_.campaign_.search.design
                       ? fmt::format("{}  all rows of the design are "
                                     "evaluated; evaluating the baseline",
                                     entry_.name)
                       : fmt::format("{}  reached {}; re-evaluating finalists "
                                     "with independent random numbers",
                                     entry_.name, in_words(reason)));
    }

  private:
    ProgressLog& log_;
    Entry& entry_;
    long long& to_evaluate_;
};

std::string certainty(bool is_evaluated_again, double violation) {
    return fmt::format(
        "({}re-evaluated{})", is_evaluated_again ? "" : "not ",
        violation > 0
            ? fmt::format("; violates its constraints by {:.3g}", violation)
            : "");
}

ProgressLog::ProgressLog(const Campaign& campaign, const Cases& chosen,
                         LogLevel level)
    : campaign_(campaign),
      level_(level),
      columns_(columns_of(STDOUT_FILENO)),
      started_(now()),
      cases_(static_cast<int>(chosen.size())) {
    for (std::size_t i = 0; i < chosen.size(); ++i)
        to_evaluate_[chosen.index(i)] = most_plants();
}

ProgressLog::~ProgressLog() {
    if (is_live_) std::puts("");
}

std::unique_ptr<Watcher> ProgressLog::watch(const Case& chosen,
                                            std::uint32_t generation,
                                            long long plants) {
    in_flight_[chosen.index] = {chosen.name, generation, plants, {}, {}};
    to_evaluate_[chosen.index] = most_plants() - plants;
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

double ProgressLog::evaluations_per_second() const {
    return evaluations_ / std::max(now() - started_, 1e-3);
}

long long ProgressLog::left() const {
    long long left = 0;
    for (const auto& [index, count] : to_evaluate_) left += count;
    return left;
}

//! Returns an upper limit of the remaining time, or "?" shortly after the
//! start.
std::string ProgressLog::time_left() const {
    constexpr double first = 2;  // time before rates are meaningful [s]
    return evaluations_ > 0 && now() - started_ > first
               ? format_duration(static_cast<double>(left()) /
                                 evaluations_per_second())
               : "?";
}

std::string ProgressLog::best_of(const Entry& entry) const {
    return fmt::format(
        "best about {}{}",
        with_unit(format(entry.best.value()),
                  unit_of(campaign_, objectives_of(campaign_).front())),
        entry.hypervolume ? ", hypervolume " + format(*entry.hypervolume) : "");
}

//! Shows the live line, with data of the first case in flight. On a narrow
//! terminal, less important parts are left out: a line that wraps could not be
//! overwritten.
void ProgressLog::show_live() {
    constexpr double calm = 0.1;  // shortest time between updates [s]
    if (columns_ == 0 || level_ < LogLevel::info || in_flight_.empty() ||
        now() - shown_ < calm)
        return;
    const Entry& entry = in_flight_.begin()->second;
    std::vector<std::string> parts;
    if (cases_ > 1)
        parts.push_back(fmt::format("{} of {} cases done", ended_, cases_));
    parts.push_back("time left " + time_left());
    if (entry.best) parts.push_back(best_of(entry));
    parts.push_back(
        fmt::format("{} of {} plants", entry.plants, most_plants()));
    parts.push_back(
        fmt::format("{:.1f} evaluations per second", evaluations_per_second()));
    parts.push_back(entry.name);
    const double done = evaluations_;
    fmt::print(
        "\r\x1b[K{}",
        line_with_bar(done / std::max(done + static_cast<double>(left()), 1.),
                      parts, static_cast<std::size_t>(columns_ - 1)));
    std::fflush(stdout);
    shown_ = now();
    is_live_ = true;
}

}  // namespace ideotype
