#pragma once

#include <string>
#include <vector>

#include "ideotype/parallel/rank_clock.hpp"

namespace ideotype {

//! MPI for as long as this lives. Works with and without mpirun. Create it
//! after the StopFlag, so that MPI does not replace its handlers.
class Session {
  public:
    //! @param clock what ranks wait by
    explicit Session(const RankClock& clock = machine_clock());
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    int rank() const;
    int size() const;
    const RankClock& clock() const { return clock_; }

    //! Rank 0's text on all ranks. Collective. Sleeps while it waits.
    std::string broadcast(const std::string& text) const;

    //! The texts of all ranks, in their order, on rank 0; nothing on the
    //! others. Collective. Sleeps while it waits.
    std::vector<std::string> gather(const std::string& text) const;

    //! The worst value of all ranks on all ranks. Collective.
    int largest(int value) const;

    //! Ends all ranks at once with this exit code.
    [[noreturn]] void abort(int exit_code) const;

    //! Name and version of the MPI library.
    static std::string library_version();

  private:
    const RankClock& clock_;
};

}  // namespace ideotype
