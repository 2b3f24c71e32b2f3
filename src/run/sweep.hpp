// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <list>
#include <string>
#include <vector>

#include "evolve_case.hpp"
#include "progress.hpp"
#include "run.hpp"
#include "summary.hpp"

namespace ideotype {

//! Evolves several cases in one job, during one start of the program. If one
//! case fails, the others continue; if the disk fails, they are drained. All
//! constructor arguments must outlive the sweep.
class Sweep : public Director {
  public:
    Sweep(const RunOptions& options, const Campaign& campaign,
          const Cases& chosen, const std::string& isa, int ranks,
          StopFlag& stop);

    //! Evolves all cases until they end or a stop is requested; returns false
    //! if any are unfinished.
    //! @throws Error that names each failed case, or Error (refused) if other
    //! jobs are working on all cases.
    bool evolve(Dispatcher& dispatcher);

    //! Returns how often traits of the best plants of ended searches are at a
    //! bound.
    const BoundCount& bounds() const { return bounds_; }

    bool start_next() override;
    void on_silence(const Task& task, const std::string& what) override;
    void on_stop(int in_flight) override;

  private:
    struct Failure {
        std::string name, reason;
        std::exception_ptr cause;
    };

    Routine<Ending> evolve_guarded(Case chosen);
    Routine<Ending> evolve_one(const Case& chosen);
    void tell(const CaseResult& result, const std::string& name,
              bool was_finished);
    void tell_together();
    History open_history(const Case& chosen) const;
    History resume_history(const Case& chosen, const std::string& path) const;
    void note_in_use(const Case& chosen, const InUseError& error);
    void report_in_use();
    void note_failure(const Case& chosen, const std::exception& error);
    void report_failures() const;

    const RunOptions& options_;
    const Campaign& campaign_;
    Cases chosen_;
    const std::string& isa_;
    int ranks_;
    StopFlag& stop_;
    Dispatcher* dispatcher_ = nullptr;  //!< dispatcher while evolving
    ProgressLog progress_;
    BoundCount bounds_;
    std::size_t next_ = 0;      //!< index of the next case to start
    std::size_t finished_ = 0;  //!< number of finished cases
    std::size_t before_ = 0;    //!< number of cases that had finished before
    std::size_t doubts_ = 0;  //!< number of cases with an unrealistic leaf area
    std::string doubt_;       //!< first warning about leaf area
    bool has_said_how_to_go_on_ = false;
    //! Cases on which other programs are working.
    std::vector<std::string> in_use_;
    std::vector<Failure> failures_;
    std::list<Routine<Ending>> running_;
};

}  // namespace ideotype
