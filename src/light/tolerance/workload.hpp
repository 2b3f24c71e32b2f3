// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "allocation.hpp"
#include "ideotype/light/transport.hpp"

namespace ideotype {

LightOrigin origin_of(const Source& source);

//! Returns the amounts that correspond to a workload of one band.
Amounts amounts_of(const Workload& work, const Illumination& light);

//! Returns the workload that corresponds to amounts in one band: first hits in
//! proportion to energy times effort of sources, and paths of scattered light
//! with equal energy.
Workload work_of(const Amounts& amounts, const Illumination& light);

//! Selects a number of suns, evenly over the day, and omits all other suns.
void leave_suns_out(Workload& work, const Illumination& light,
                    std::size_t kept);

}  // namespace ideotype
