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

//! Tells how the cases of a job evolve: one live line on a terminal for all
//! that are in flight, one line per generation and case in a log file.
class ProgressLog {
  public:
    //! All must outlive it.
    //! @param level the least urgent that is told
    ProgressLog(const Campaign& campaign, const std::vector<Case>& chosen,
                LogLevel level = LogLevel::info);
    ~ProgressLog();
    ProgressLog(const ProgressLog&) = delete;
    ProgressLog& operator=(const ProgressLog&) = delete;

    //! Begins a case at a generation. The log must outlive the watcher.
    std::unique_ptr<Watcher> watch(const Case& chosen,
                                   std::uint32_t generation);

    //! A case has ended, also if nobody watched it.
    void end(const Case& chosen);

    bool is_on_terminal() const { return columns_ > 0; }

    //! Lines that stay, above the live one; in a log file with the time.
    //! Warnings and errors go to the standard error if nothing else is told.
    void print(const std::string& text, LogLevel level = LogLevel::info);

    //! Prints a result, which is told at any level.
    void print_result(const std::string& text);

  private:
    class CaseWatcher;

    //! A case in flight.
    struct Entry {
        std::string name;
        std::uint32_t generation = 0;  //!< from 0, as in the history
        std::uint32_t complete = 0;    //!< generations
        std::optional<Estimate> best, hypervolume;
    };

    //! Evaluations of a case from this generation on, if no rule ends it.
    long long all_after(std::uint32_t generation) const;
    double evaluations_per_second() const;
    //! Returns how many evaluations are left, at most.
    long long left() const;
    std::string time_left() const;
    std::string best_of(const Entry& entry) const;
    void show_live();

    const Campaign& campaign_;
    LogLevel level_;
    int columns_;           //!< columns of the terminal; 0: a log file
    bool is_live_ = false;  //!< the live line is on the terminal
    double started_;
    double shown_ = 0;
    int evaluations_ = 0;                   //!< evaluations of this session
    int cases_;                             //!< cases of this session
    int ended_ = 0;                         //!< cases
    std::map<int, Entry> in_flight_;        //!< by index of the case
    std::map<int, long long> to_evaluate_;  //!< at most, by index of the case
};

//! Tells how sure the figure of a best plant is: one that was chosen by the
//! same figure, and not evaluated again, is too high on average.
//! @param violation of its constraints
std::string certainty(bool is_evaluated_again, double violation);

//! Returns "12.345 +- 0.006": as many digits as the standard error allows; "0"
//! of what differs from zero by rounding alone.
std::string format(Estimate x);

//! Returns a number with its unit behind it; "1" is none.
std::string with_unit(const std::string& number, const std::string& unit);

//! Returns the title of a column, "lai [m2 m-2]"; the unit "1" is left out.
std::string title_of(const std::string& name, const std::string& unit);

//! Returns "1:02:03" or "2:03".
std::string format_duration(double seconds);

//! Returns a line of at most so many columns: a bar that is full as far as is
//! done (0 .. 1), and words. Parts that find no room are left out, the last
//! ones first.
std::string line_with_bar(double done, const std::vector<std::string>& parts,
                          std::size_t width);

//! Returns "2025-08-07T12:00:00Z".
std::string utc_now();

//! Seconds of a steady clock.
double now();

}  // namespace ideotype
