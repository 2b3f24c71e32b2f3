// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ideotype {

//! Makes the process print a reason if a library ends it. Embree and TBB end
//! the process when threads or memory run out, and HDF5 calls `exit(-1)`. The
//! exit code is then ExitCode::runtime; a segmentation fault still ends the
//! process by its signal. Printing needs no memory.
void watch_for_foreign_end();

//! Declares that the process ends normally from here on: no reason is printed.
void end_in_order();

}  // namespace ideotype
