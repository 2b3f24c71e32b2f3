// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ideotype {

//! Lets the process say why it ends if a library ends it: Embree and TBB do
//! where they get no thread or memory, and HDF5 calls `exit(-1)` itself. The
//! exit code is ExitCode::runtime then; a segmentation fault still ends the
//! process by its signal. Needs no memory.
void watch_for_foreign_end();

//! Says that the process ends in order from now on, so that nothing is told.
void end_in_order();

}  // namespace ideotype
