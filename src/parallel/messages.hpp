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

//! The bytes of a message between the ranks of a job. Numbers are sent as they
//! are in memory, since all ranks run the same program on the same kind of
//! machine.
using Bytes = std::vector<std::byte>;

//! The outcome of a task, as it is sent to rank 0.
struct Reply {
    Task task;
    Outcome outcome;
};

//! Largest number of bytes in the reason of a failure; longer reasons are cut.
inline constexpr std::size_t reply_message_capacity = 160;

//! Encodes work as a header of fixed size and the genome.
Bytes encode_work(const Work& work);

//! Decodes work.
//! @throws Error if the bytes do not encode work.
Work decode_work(std::span<const std::byte> bytes);

//! Encodes a reply as a header of fixed size, followed by all numbers of the
//! outcome in order.
Bytes encode_reply(const Reply& reply);

//! Decodes the task of a reply.
//! @throws Error if the bytes do not encode a reply.
Task decode_task(std::span<const std::byte> bytes);

//! Decodes a reply.
//! @throws Error if the bytes do not encode a reply of this schema.
Reply decode_reply(std::span<const std::byte> bytes,
                   const OutcomeSchema& schema);

//! The kind of a message.
enum class Tag : int { work = 1, reply = 2, stop = 3 };

//! A received message.
struct Envelope {
    int source = 0;  //!< rank of the sender
    Tag tag = Tag::stop;
    Bytes bytes;
};

//! Exchanges messages between ranks. Posting never blocks; waiting sleeps.
class Mailbox {
  public:
    explicit Mailbox(const Session& session);
    //! Waits until all posted messages have been sent.
    ~Mailbox();

    void post(int rank, Tag tag, Bytes bytes);

    //! Sleeps until a message from any rank arrives, and returns it.
    //! @throws Error if the tag is unknown.
    Envelope wait();

    //! Returns the next message from any rank, or nothing if none arrives
    //! within a number of seconds.
    std::optional<Envelope> wait(double seconds);

  private:
    //! Messages being sent. MPI reads their bytes until the transfer is
    //! complete.
    struct Posted;
    const Session& session_;
    std::unique_ptr<Posted> posted_;
};

}  // namespace ideotype
