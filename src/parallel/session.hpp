// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "rank_clock.hpp"

namespace ideotype {

class Mailbox;

//! MPI for as long as this lives, with and without mpirun. Create it after the
//! StopFlag, so that MPI does not replace its handlers.
class Session {
  public:
    //! One rank without MPI, which nobody has launched.
    static Session alone();

    //! @param clock what ranks wait by
    explicit Session(const RankClock& clock = machine_clock);
    ~Session();
    Session(Session&& other) noexcept;
    Session& operator=(Session&&) = delete;

    //! The ranks that name the same part, numbered from 0 in their order here.
    //! Collective. This one must outlive it.
    Session split(int part) const;

    int rank() const;

    //! The number of a rank of this session in the whole job.
    int rank_in_job(int rank) const;

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
    friend Mailbox;
    struct Ranks;
    Session(const RankClock& clock, const Ranks& ranks);
    Session(const RankClock& clock, std::nullptr_t);

    const RankClock& clock_;
    std::unique_ptr<const Ranks> ranks_;  //!< none: alone
};

}  // namespace ideotype
