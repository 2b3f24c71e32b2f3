// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "allocation.hpp"
#include "ideotype/light/transport.hpp"

namespace ideotype {

LightOrigin origin_of(const Source& source);

//! Returns the amounts of a workload of one band.
Amounts amounts_of(const Workload& work, const Illumination& light);

//! Returns the workload of amounts in one band: first hits in proportion to the
//! energy and effort of sources, and paths of scattered light of equal energy.
Workload work_of(const Amounts& amounts, const Illumination& light);

//! Keeps a number of suns, evenly over the day, and leaves out all other suns.
void leave_suns_out(Workload& work, const Illumination& light,
                    std::size_t kept);

}  // namespace ideotype
