// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "rank_clock.hpp"

namespace ideotype {

class Mailbox;

//! Uses MPI, with or without mpirun, during the life of this object. Create it
//! after the StopFlag, so that MPI does not replace the signal handlers of the
//! flag.
class Session {
  public:
    //! Makes a session of one rank without MPI.
    static Session alone();

    //! Starts MPI.
    //! @param clock clock for the waits of ranks
    explicit Session(const RankClock& clock = machine_clock);
    ~Session();
    Session(Session&& other) noexcept;
    Session& operator=(Session&&) = delete;

    //! Makes a session of all ranks that pass the same part. Their new numbers
    //! begin at 0 and preserve the order. Collective. This session must outlive
    //! the new one.
    Session split(int part) const;

    int rank() const;

    //! Returns the number in the whole job of a rank of this session.
    int rank_in_job(int rank) const;

    int size() const;
    const RankClock& clock() const { return clock_; }

    //! Returns the text of rank 0 on all ranks. Collective; sleeps while
    //! waiting.
    std::string broadcast(const std::string& text) const;

    //! Returns the texts of all ranks, in order, on rank 0, and nothing on
    //! other ranks. Collective; sleeps while waiting.
    std::vector<std::string> gather(const std::string& text) const;

    //! Returns the largest value that any rank passes, on all ranks.
    //! Collective.
    int largest(int value) const;

    //! Ends all ranks at once with an exit code.
    [[noreturn]] void abort(int exit_code) const;

    //! Returns the name and version of the MPI library.
    static std::string library_version();

  private:
    friend Mailbox;
    struct Ranks;
    Session(const RankClock& clock, const Ranks& ranks);
    Session(const RankClock& clock, std::nullptr_t);

    const RankClock& clock_;
    std::unique_ptr<const Ranks> ranks_;  //!< null for a session without MPI
};

}  // namespace ideotype
