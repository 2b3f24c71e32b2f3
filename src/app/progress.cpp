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

ProgressLine::ProgressLine(const Campaign& campaign, const Case& chosen)
    : campaign_(campaign),
      name_(chosen.name),
      is_terminal_(is_watched()),
      started_(now()) {}

ProgressLine::~ProgressLine() {
    if (is_terminal_ && shown_ > 0) std::puts("");
}

std::string ProgressLine::text(std::uint32_t generation) const {
    const double seconds = std::max(now() - started_, 1e-3);
    const double rate = evaluations_ / seconds;
    const int generations = campaign_.stop.generations;
    const double left = (generations - static_cast<double>(generation)) *
                            campaign_.optimizer.population -
                        evaluations_generation_;
    return fmt::format(
        "{}  generation {}/{}  best {}  {:.1f} evaluations/s  {} left", name_,
        generation + 1, generations, best_, rate,
        rate > 0 ? format_duration(std::max(0.0, left) / rate) : "?");
}

void ProgressLine::show(const std::string& line) {
    if (is_terminal_)
        fmt::print("\r\x1b[K{}", line);
    else
        fmt::print("{}\n", line);
    std::fflush(stdout);
    shown_ = now();
}

void ProgressLine::on_evaluation(std::uint32_t generation) {
    ++evaluations_;
    ++evaluations_generation_;
    if (is_terminal_ && now() - shown_ > 0.1) show(text(generation));
}

void ProgressLine::on_generation(std::uint32_t generation,
                                 const GenerationSummary& summary) {
    evaluations_generation_ = campaign_.optimizer.population;
    best_ =
        format({summary.best, summary.best_standard_error}) + " MJ m-2 day-1";
    std::string line = text(generation);
    if (summary.failures > 0)
        line += fmt::format("  {} failed", summary.failures);
    show(line);
    evaluations_generation_ = 0;
}

void ProgressLine::on_final(const std::string& reason) {
    show(
        fmt::format("{}  ended by {}; evaluating the best anew with fresh "
                    "random numbers",
                    name_, reason));
}

}  // namespace ideotype
