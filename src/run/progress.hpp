// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "evolve_case.hpp"
#include "ideotype/core/estimate.hpp"
#include "log.hpp"

namespace ideotype {

//! Reports the progress of the cases of a job. A terminal shows one live line
//! for all cases in flight; a log file receives one line per generation and
//! case.
class ProgressLog {
  public:
    //! Makes a log; all arguments must outlive it.
    //! @param level least urgent level that is printed
    ProgressLog(const Campaign& campaign, const Cases& chosen,
                LogLevel level = LogLevel::info);
    ~ProgressLog();
    ProgressLog(const ProgressLog&) = delete;
    ProgressLog& operator=(const ProgressLog&) = delete;

    //! Begins or resumes a case. The log must outlive the watcher.
    //! @param generation first incomplete generation
    //! @param plants number of plants of complete generations
    std::unique_ptr<Watcher> watch(const Case& chosen, std::uint32_t generation,
                                   long long plants);

    //! Records the end of a case, even if it was not watched.
    void end(const Case& chosen);

    bool is_on_terminal() const { return columns_ > 0; }

    //! Prints permanent lines above the live line; in a log file, they begin
    //! with a time stamp. If only warnings and errors are printed, they go to
    //! the standard error.
    void print(const std::string& text, LogLevel level = LogLevel::info);

    //! Prints a result, regardless of the log level.
    void print_result(const std::string& text);

  private:
    class CaseWatcher;

    //! A case in flight.
    struct Entry {
        std::string name;
        std::uint32_t generation = 0;  //!< index of the generation, from 0
        long long plants = 0;          //!< plants of complete generations
        std::optional<Estimate> best, hypervolume;
    };

    //! Returns the number of plants of a case if it reaches stop.generations.
    long long most_plants() const {
        return static_cast<long long>(campaign_.stop.generations) *
               campaign_.search.population;
    }
    double evaluations_per_second() const;
    //! Returns the number of evaluations that remain at most.
    long long left() const;
    std::string time_left() const;
    std::string best_of(const Entry& entry) const;
    void show_live();

    const Campaign& campaign_;
    LogLevel level_;
    int columns_;           //!< columns of the terminal; 0 for a log file
    bool is_live_ = false;  //!< whether the live line is shown
    double started_;
    double shown_ = 0;
    int evaluations_ = 0;             //!< evaluations of this session
    int cases_;                       //!< cases of this session
    int ended_ = 0;                   //!< number of ended cases
    std::map<int, Entry> in_flight_;  //!< cases by index
    std::map<int, long long>
        to_evaluate_;  //!< largest number of remaining evaluations, by case
};

//! Returns a note on the objective of the best plant. The value by which a
//! plant was selected is too high on average (selection bias), unless it was
//! re-evaluated.
//! @param violation constraint violation of the plant
std::string certainty(bool is_evaluated_again, double violation);

//! Returns a text such as "12.345 ± 0.012": a number, and half of its 95 %
//! confidence interval, which determines the number of digits. Returns "0" if
//! the number is zero up to rounding.
std::string format(Estimate x);

//! Returns a number followed by its unit, unless the unit is "1".
std::string with_unit(const std::string& number, const std::string& unit);

//! Formats a duration [s] as "1:02:03" or "2:03".
std::string format_duration(double seconds);

//! Returns a progress bar and parts of text within a given width. Parts that
//! exceed it are left out, the last ones first.
//! @param done completed fraction, 0 to 1
std::string line_with_bar(double done, const std::vector<std::string>& parts,
                          std::size_t width);

//! Returns the current time in UTC, such as "2025-08-07T12:00:00Z".
std::string utc_now();

//! Returns the time of a steady clock [s].
double now();

}  // namespace ideotype
