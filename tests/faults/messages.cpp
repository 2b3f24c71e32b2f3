// SPDX-License-Identifier: Apache-2.0
// Replaces the MPI calls that send and receive. They fail as in MPI: through
// the error handler of the communicator.
#include <chrono>
#include <dlfcn.h>
#include <thread>

#include <mpi.h>

#include "plan.hpp"

using faults::Kind;

namespace {

template <typename Function, typename... Words>
int passed_on(Kind kind, Function* /*own*/, const char* name, MPI_Comm ranks,
              Words... words) {
    const faults::Fault fault = faults::next(kind);
    if (fault.error != 0) {
        auto* const handle =
            reinterpret_cast<decltype(MPI_Comm_call_errhandler)*>(
                dlsym(RTLD_NEXT, "MPI_Comm_call_errhandler"));
        handle(ranks, MPI_ERR_OTHER);
        return MPI_ERR_OTHER;
    }
    if (fault.is_delayed)
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name))(words...);
}

}  // namespace

extern "C" {

int MPI_Isend(const void* bytes, int count, MPI_Datatype type, int rank,
              int tag, MPI_Comm ranks, MPI_Request* request) {
    return passed_on(Kind::send, MPI_Isend, "MPI_Isend", ranks, bytes, count,
                     type, rank, tag, ranks, request);
}

int MPI_Recv(void* bytes, int count, MPI_Datatype type, int rank, int tag,
             MPI_Comm ranks, MPI_Status* status) {
    return passed_on(Kind::receive, MPI_Recv, "MPI_Recv", ranks, bytes, count,
                     type, rank, tag, ranks, status);
}

int MPI_Iprobe(int rank, int tag, MPI_Comm ranks, int* flag,
               MPI_Status* status) {
    return passed_on(Kind::receive, MPI_Iprobe, "MPI_Iprobe", ranks, rank, tag,
                     ranks, flag, status);
}

int MPI_Ibcast(void* bytes, int count, MPI_Datatype type, int root,
               MPI_Comm ranks, MPI_Request* request) {
    return passed_on(Kind::send, MPI_Ibcast, "MPI_Ibcast", ranks, bytes, count,
                     type, root, ranks, request);
}

int MPI_Igather(const void* bytes, int count, MPI_Datatype type, void* received,
                int all_count, MPI_Datatype all_type, int root, MPI_Comm ranks,
                MPI_Request* request) {
    return passed_on(Kind::send, MPI_Igather, "MPI_Igather", ranks, bytes,
                     count, type, received, all_count, all_type, root, ranks,
                     request);
}

int MPI_Igatherv(const void* bytes, int count, MPI_Datatype type,
                 void* received, const int* counts, const int* starts,
                 MPI_Datatype all_type, int root, MPI_Comm ranks,
                 MPI_Request* request) {
    return passed_on(Kind::send, MPI_Igatherv, "MPI_Igatherv", ranks, bytes,
                     count, type, received, counts, starts, all_type, root,
                     ranks, request);
}

int MPI_Iallreduce(const void* sent, void* received, int count,
                   MPI_Datatype type, MPI_Op operation, MPI_Comm ranks,
                   MPI_Request* request) {
    return passed_on(Kind::send, MPI_Iallreduce, "MPI_Iallreduce", ranks, sent,
                     received, count, type, operation, ranks, request);
}

}  // extern "C"
