// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mpi.h>

#include "session.hpp"

namespace ideotype {

//! The ranks of a session, as MPI knows them.
struct Session::Ranks {
    MPI_Comm communicator;
    //! What to do when the session ends.
    enum class End { finalize, free } end;
};

}  // namespace ideotype
