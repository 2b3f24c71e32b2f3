// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "messages.hpp"
#include "session.hpp"

namespace ideotype {

//! What a message is about.
enum class Tag : int { work = 1, reply = 2, stop = 3 };

//! A message that arrived.
struct Envelope {
    int source = 0;  //!< rank that sent it
    Tag tag = Tag::stop;
    Bytes bytes;
};

//! Messages between ranks. Posting never blocks, waiting sleeps.
class Mailbox {
  public:
    explicit Mailbox(const Session& session);
    //! Waits until all that was posted has left.
    ~Mailbox();

    void post(int rank, Tag tag, Bytes bytes);

    //! The next message of any rank; sleeps until there is one.
    //! @throws Error if its tag is unknown.
    Envelope wait();

    //! The same, but none if there is none after this time [s].
    std::optional<Envelope> wait(double seconds);

  private:
    //! Messages under way; MPI reads their bytes until they have left.
    struct Posted;
    const Session& session_;
    std::unique_ptr<Posted> posted_;
};

}  // namespace ideotype
