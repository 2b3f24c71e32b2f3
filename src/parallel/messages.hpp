// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "dispatcher.hpp"
#include "evaluator.hpp"

namespace ideotype {

//! What travels between the ranks of one job. All ranks run the same program
//! on the same kind of machine, so numbers travel as they are in memory.
using Bytes = std::vector<std::byte>;

//! The outcome of a task, on its way back.
struct Reply {
    Task task;
    Outcome outcome;
};

//! Longer reasons of failures are cut to this many bytes.
inline constexpr std::size_t reply_message_capacity = 160;

//! A header of 32 bytes and the genome.
Bytes encode_work(const Work& work);

//! @throws Error if this is not the encoding of work.
Work decode_work(std::span<const std::byte> bytes);

//! A header of fixed size, then all numbers of the outcome in their order.
Bytes encode_reply(const Reply& reply);

//! @throws Error if this is not a reply.
Task task_of_reply(std::span<const std::byte> bytes);

//! @throws Error if this is not a reply with the columns of the schema.
Reply decode_reply(std::span<const std::byte> bytes,
                   const OutcomeSchema& schema);

}  // namespace ideotype
