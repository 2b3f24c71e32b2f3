// SPDX-License-Identifier: Apache-2.0
#include "messages.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>

#include <fmt/format.h>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/text.hpp"

namespace ideotype {

namespace {

//! The first bytes of each kind of message.
enum class Mark : std::uint64_t {
    work = 0x4b524f574f454449,   // "IDEOWORK"
    reply = 0x594c50524f454449,  // "IDEORPLY"
};

struct WorkHeader {
    Mark mark;
    Task task;
    std::uint32_t gene_count;
};
static_assert(std::is_trivially_copyable_v<WorkHeader>);

struct ReplyHeader {
    Mark mark;
    Task task;
    std::uint32_t status;
    double seconds;
    std::uint32_t worker;
    std::uint32_t message_size;
    std::array<char, reply_message_capacity> message;
};
static_assert(std::is_trivially_copyable_v<ReplyHeader>);

template <class Header>
Bytes encode(const Header& header, std::span<const double> numbers) {
    Bytes bytes(sizeof(Header) + numbers.size_bytes());
    std::memcpy(bytes.data(), &header, sizeof(Header));
    std::ranges::copy(std::as_bytes(numbers), bytes.begin() + sizeof(Header));
    return bytes;
}

template <class Header>
Header read_header(std::span<const std::byte> bytes, Mark mark,
                   const char* kind) {
    Header header{};
    if (bytes.size() >= sizeof(Header))
        std::memcpy(&header, bytes.data(), sizeof(Header));
    if (header.mark != mark)
        throw Error(
            fmt::format("unexpected MPI message of {} bytes (it is not "
                        "{}); all ranks must run the same ideotype",
                        bytes.size(), kind));
    return header;
}

template <class Header>
std::vector<double> read_numbers(std::span<const std::byte> bytes,
                                 std::size_t count, const char* kind) {
    const std::size_t expected = sizeof(Header) + count * sizeof(double);
    if (bytes.size() != expected)
        throw Error(
            fmt::format("MPI message has {} bytes instead of {} (as {}); all "
                        "ranks must run the same ideotype and campaign",
                        bytes.size(), expected, kind));
    std::vector<double> numbers(count);
    std::ranges::copy(bytes.subspan(sizeof(Header)),
                      std::as_writable_bytes(std::span(numbers)).begin());
    return numbers;
}

}  // namespace

Bytes encode_work(const Work& work) {
    return encode(WorkHeader{Mark::work, work.task,
                             static_cast<std::uint32_t>(work.genome.size())},
                  work.genome);
}

Work decode_work(std::span<const std::byte> bytes) {
    const auto header = read_header<WorkHeader>(bytes, Mark::work, "work");
    return {header.task,
            read_numbers<WorkHeader>(bytes, header.gene_count, "work")};
}

Bytes encode_reply(const Reply& reply) {
    IDEOTYPE_EXPECT(reply.outcome.status != Status::empty);
    Outcome outcome = reply.outcome;
    ReplyHeader header{};
    header.mark = Mark::reply;
    header.task = reply.task;
    header.status = static_cast<std::uint32_t>(outcome.status);
    header.seconds = outcome.seconds;
    header.worker = outcome.worker;
    const std::string message =
        first_bytes(outcome.message, reply_message_capacity);
    header.message_size = static_cast<std::uint32_t>(message.size());
    std::copy(message.begin(), message.end(), header.message.begin());

    std::vector<double> numbers;
    outcome.for_each_number([&](double& x) { numbers.push_back(x); });
    return encode(header, numbers);
}

Task decode_task(std::span<const std::byte> bytes) {
    return read_header<ReplyHeader>(bytes, Mark::reply, "a reply").task;
}

Reply decode_reply(std::span<const std::byte> bytes,
                   const OutcomeSchema& schema) {
    const auto header = read_header<ReplyHeader>(bytes, Mark::reply, "a reply");
    const auto status = static_cast<Status>(header.status);
    Outcome outcome =
        status == Status::proposed ? Outcome{} : unknown_outcome(schema);
    std::size_t count = 0;
    outcome.for_each_number([&](double&) { ++count; });
    const auto numbers = read_numbers<ReplyHeader>(bytes, count, "a reply");
    outcome.status = status;
    outcome.seconds = header.seconds;
    outcome.worker = header.worker;
    outcome.message.assign(
        header.message.data(),
        std::min<std::size_t>(header.message_size, header.message.size()));
    auto next = numbers.begin();
    outcome.for_each_number([&](double& x) { x = *next++; });
    return {header.task, std::move(outcome)};
}

}  // namespace ideotype
