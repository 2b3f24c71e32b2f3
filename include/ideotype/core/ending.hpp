// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ideotype {

//! Makes the process print the reason if a library ends it: Embree and TBB do
//! so without threads or memory, and HDF5 calls `exit(-1)` itself. The exit
//! code is then ExitCode::runtime; a segmentation fault still ends the process
//! by its signal. Printing needs no memory.
void watch_for_foreign_end();

//! Marks the end of the process as regular from now on: no reason is printed.
void end_in_order();

}  // namespace ideotype
