// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "dispatcher.hpp"
#include "evaluator.hpp"
#include "session.hpp"

namespace ideotype {

//! The bytes of a message between the ranks of one job. All ranks run the same
//! program on the same kind of machine, so numbers travel as they are in
//! memory.
using Bytes = std::vector<std::byte>;

//! The outcome of a task, on its way back.
struct Reply {
    Task task;
    Outcome outcome;
};

//! The bytes to which longer reasons of failures are cut.
inline constexpr std::size_t reply_message_capacity = 160;

//! Encodes work as a header of 32 bytes and the genome.
Bytes encode_work(const Work& work);

//! Decodes work. @throws Error if this is not the encoding of work.
Work decode_work(std::span<const std::byte> bytes);

//! Encodes a reply as a header of fixed size, then all numbers of the outcome
//! in their order.
Bytes encode_reply(const Reply& reply);

//! Returns the task of a reply. @throws Error if this is not a reply.
Task task_of_reply(std::span<const std::byte> bytes);

//! Decodes a reply. @throws Error if this is not a reply with the columns of
//! the schema.
Reply decode_reply(std::span<const std::byte> bytes,
                   const OutcomeSchema& schema);

//! Tells the kind of a message.
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

    //! Returns the next message of any rank; sleeps until there is one. @throws
    //! Error if its tag is unknown.
    Envelope wait();

    //! Returns the next message of any rank, or none if there is none after
    //! this time [s].
    std::optional<Envelope> wait(double seconds);

  private:
    //! The messages under way; MPI reads their bytes until they have left.
    struct Posted;
    const Session& session_;
    std::unique_ptr<Posted> posted_;
};

}  // namespace ideotype
