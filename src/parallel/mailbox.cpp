// SPDX-License-Identifier: Apache-2.0
#include "mailbox.hpp"

#include <list>

#include <fmt/format.h>

#include "backoff.hpp"
#include "ideotype/core/error.hpp"
#include "ranks.hpp"

namespace ideotype {

struct Mailbox::Posted {
    struct Sending {
        Bytes bytes;
        MPI_Request request = MPI_REQUEST_NULL;
    };
    // A list, because MPI keeps the address of the request's bytes.
    std::list<Sending> sendings;

    void forget_finished() {
        sendings.remove_if([](Sending& sending) {
            int finished = 0;
            MPI_Test(&sending.request, &finished, MPI_STATUS_IGNORE);
            return finished != 0;
        });
    }
};

Mailbox::Mailbox(const Session& session)
    : session_(session), posted_(std::make_unique<Posted>()) {}

Mailbox::~Mailbox() {
    Backoff backoff;
    for (posted_->forget_finished(); !posted_->sendings.empty();
         posted_->forget_finished())
        session_.clock().nap(backoff.next());
}

void Mailbox::post(int rank, Tag tag, Bytes bytes) {
    auto& sending = posted_->sendings.emplace_back();
    sending.bytes = std::move(bytes);
    MPI_Isend(sending.bytes.data(), static_cast<int>(sending.bytes.size()),
              MPI_BYTE, rank, static_cast<int>(tag),
              session_.ranks_->communicator, &sending.request);
}

Envelope Mailbox::wait() {
    constexpr double long_enough = 3600;
    for (;;)
        if (auto letter = wait(long_enough)) return *std::move(letter);
}

std::optional<Envelope> Mailbox::wait(double seconds) {
    const double end = session_.clock().now() + seconds;
    Backoff backoff;
    MPI_Status status;
    for (;;) {
        posted_->forget_finished();
        int arrived = 0;
        MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, session_.ranks_->communicator,
                   &arrived, &status);
        if (arrived) break;
        if (session_.clock().now() >= end) return std::nullopt;
        session_.clock().nap(backoff.next());
    }
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    Bytes bytes(static_cast<std::size_t>(size));
    MPI_Recv(bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, status.MPI_TAG,
             session_.ranks_->communicator, MPI_STATUS_IGNORE);
    if (status.MPI_TAG < static_cast<int>(Tag::work) ||
        status.MPI_TAG > static_cast<int>(Tag::stop))
        throw Error(fmt::format(
            "unexpected MPI message with tag {} from rank {}; all ranks must "
            "run the same ideotype",
            status.MPI_TAG, status.MPI_SOURCE));
    return Envelope{status.MPI_SOURCE, static_cast<Tag>(status.MPI_TAG),
                    std::move(bytes)};
}

}  // namespace ideotype
