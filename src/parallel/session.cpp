// SPDX-License-Identifier: Apache-2.0
#include "session.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <list>
#include <numeric>
#include <utility>

#include <fmt/format.h>
#include <mpi.h>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/ending.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/host.hpp"
#include "messages.hpp"

namespace ideotype {

struct Session::Ranks {
    MPI_Comm communicator;
    enum class End { finalize, free } end;
};

namespace {

void wait_for(MPI_Request request, const RankClock& clock) {
    Backoff backoff;
    for (;;) {
        int finished = 0;
        MPI_Test(&request, &finished, MPI_STATUS_IGNORE);
        if (finished) return;
        clock.nap(backoff.next());
    }
}

//! Reports that MPI has failed and ends the job. It does not rely on MPI's own
//! message, which may be lost.
void end_job(MPI_Comm* /*ranks*/, int* failure, ...) {
    std::array<char, MPI_MAX_ERROR_STRING> reason{};
    int length = 0;
    MPI_Error_string(*failure, reason.data(), &length);
    fmt::print(stderr,
               "ideotype: MPI failed on {}: {}; recorded rows are kept, "
               "continue with --resume\n",
               host_name(), reason.data());
    std::fflush(nullptr);
    end_in_order();
    MPI_Abort(MPI_COMM_WORLD, static_cast<int>(ExitCode::runtime));
}

void report_failures(MPI_Comm ranks) {
    MPI_Errhandler handler = MPI_ERRHANDLER_NULL;
    MPI_Comm_create_errhandler(end_job, &handler);
    MPI_Comm_set_errhandler(ranks, handler);
    MPI_Errhandler_free(&handler);
}

}  // namespace

Session::Session(const RankClock& clock)
    : Session(clock, {MPI_COMM_WORLD, Ranks::End::finalize}) {
    // Only this thread calls MPI; the ray tracer may use other threads.
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    report_failures(MPI_COMM_WORLD);
}

Session::Session(const RankClock& clock, const Ranks& ranks)
    : clock_(clock), ranks_(std::make_unique<Ranks>(ranks)) {}

Session::Session(const RankClock& clock, std::nullptr_t) : clock_(clock) {}

Session::Session(Session&& other) noexcept = default;

Session Session::alone() {
    return {machine_clock, nullptr};
}

Session::~Session() {
    if (!ranks_) return;
    if (ranks_->end == Ranks::End::finalize) {
        MPI_Finalize();
        return;
    }
    MPI_Comm communicator = ranks_->communicator;
    MPI_Comm_free(&communicator);
}

Session Session::split(int part) const {
    IDEOTYPE_EXPECT(part >= 0);
    if (!ranks_) return alone();
    MPI_Comm communicator = MPI_COMM_NULL;
    MPI_Comm_split(ranks_->communicator, part, rank(), &communicator);
    report_failures(communicator);
    return {clock_, {communicator, Ranks::End::free}};
}

int Session::rank() const {
    int rank = 0;
    if (!ranks_) return rank;
    MPI_Comm_rank(ranks_->communicator, &rank);
    return rank;
}

int Session::rank_in_job(int rank) const {
    IDEOTYPE_EXPECT(rank >= 0 && rank < size());
    if (!ranks_) return rank;
    MPI_Group session_group = MPI_GROUP_NULL;
    MPI_Group job_group = MPI_GROUP_NULL;
    MPI_Comm_group(ranks_->communicator, &session_group);
    MPI_Comm_group(MPI_COMM_WORLD, &job_group);
    int result = 0;
    MPI_Group_translate_ranks(session_group, 1, &rank, job_group, &result);
    MPI_Group_free(&session_group);
    MPI_Group_free(&job_group);
    return result;
}

int Session::size() const {
    int size = 1;
    if (!ranks_) return size;
    MPI_Comm_size(ranks_->communicator, &size);
    return size;
}

std::string Session::broadcast(const std::string& text) const {
    if (!ranks_) return text;
    std::uint64_t length = text.size();
    MPI_Request request;
    MPI_Ibcast(&length, 1, MPI_UINT64_T, 0, ranks_->communicator, &request);
    wait_for(request, clock_);
    IDEOTYPE_EXPECT(std::in_range<int>(length));
    std::string copy = text;
    copy.resize(length);
    MPI_Ibcast(copy.data(), static_cast<int>(length), MPI_CHAR, 0,
               ranks_->communicator, &request);
    wait_for(request, clock_);
    return copy;
}

std::vector<std::string> Session::gather(const std::string& text) const {
    if (!ranks_) return {text};
    IDEOTYPE_EXPECT(std::in_range<int>(text.size()));
    const auto ranks = static_cast<std::size_t>(size());
    const auto length = static_cast<int>(text.size());
    std::vector<int> lengths(ranks), starts(ranks);
    MPI_Request request;
    MPI_Igather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, 0,
                ranks_->communicator, &request);
    wait_for(request, clock_);
    std::exclusive_scan(lengths.begin(), lengths.end(), starts.begin(), 0);
    std::string joined(static_cast<std::size_t>(starts.back() + lengths.back()),
                       '\0');
    MPI_Igatherv(text.data(), length, MPI_CHAR, joined.data(), lengths.data(),
                 starts.data(), MPI_CHAR, 0, ranks_->communicator, &request);
    wait_for(request, clock_);
    std::vector<std::string> texts;
    for (std::size_t i = 0; rank() == 0 && i < ranks; ++i)
        texts.push_back(joined.substr(static_cast<std::size_t>(starts[i]),
                                      static_cast<std::size_t>(lengths[i])));
    return texts;
}

int Session::largest(int value) const {
    int result = value;
    if (!ranks_) return result;
    MPI_Request request;
    MPI_Iallreduce(&value, &result, 1, MPI_INT, MPI_MAX, ranks_->communicator,
                   &request);
    wait_for(request, clock_);
    return result;
}

void Session::abort(int exit_code) const {
    std::cout.flush();
    std::cerr.flush();
    std::fflush(nullptr);
    end_in_order();
    if (ranks_) MPI_Abort(MPI_COMM_WORLD, exit_code);
    std::_Exit(exit_code);
}

std::string Session::library_version() {
    std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> text{};
    int length = 0;
    MPI_Get_library_version(text.data(), &length);
    // The version is a text such as "Open MPI v4.1.4, package: ..., ident: ..."
    // or "MPICH Version:\t4.0.2 ...".
    std::string version(text.data());
    version.resize(std::min(version.find_first_of(",\n"), version.size()));
    const std::string label = "Version:";
    if (const auto at = version.find(label); at != std::string::npos)
        version.erase(at,
                      version.find_first_not_of(" \t", at + label.size()) - at);
    return version;
}

struct Mailbox::Posted {
    struct Sending {
        Bytes bytes;
        MPI_Request request = MPI_REQUEST_NULL;
    };
    // A list does not move its elements: the addresses that MPI uses stay
    // valid.
    std::list<Sending> sendings;

    void remove_sent() {
        sendings.remove_if([](Sending& sending) {
            int finished = 0;
            MPI_Test(&sending.request, &finished, MPI_STATUS_IGNORE);
            return finished != 0;
        });
    }
};

Mailbox::Mailbox(const Session& session)
    : session_(session), posted_(std::make_unique<Posted>()) {
    IDEOTYPE_EXPECT(session.ranks_ != nullptr);
}

Mailbox::~Mailbox() {
    Backoff backoff;
    for (posted_->remove_sent(); !posted_->sendings.empty();
         posted_->remove_sent())
        session_.clock().nap(backoff.next());
}

void Mailbox::post(int rank, Tag tag, Bytes bytes) {
    IDEOTYPE_EXPECT(rank >= 0 && rank < session_.size());
    IDEOTYPE_EXPECT((tag == Tag::stop) == bytes.empty());
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
    IDEOTYPE_EXPECT(seconds >= 0);
    const double end = session_.clock().now() + seconds;
    Backoff backoff;
    MPI_Status status;
    for (;;) {
        posted_->remove_sent();
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
