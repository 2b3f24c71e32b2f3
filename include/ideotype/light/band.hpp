// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/light/illumination.hpp"
#include "ideotype/light/optics.hpp"

namespace ideotype {

//! A waveband: its light and the optics of surfaces. All bands of a stand share
//! their sources, with different energies.
struct Band {
    std::string name;  //!< name, such as "par"
    SeriesIllumination light;
    Optics optics;
    //! Whether the tolerance applies to the light absorbed by leaves in this
    //! band.
    bool is_bounded = true;
    //! Whether light is tallied for each piece of a leaf, as it always is in
    //! the first band.
    bool is_by_piece = false;
    //! The number of paths of scattered light relative to the number that a
    //! Workload specifies.
    double path_share = 1;
};

using Bands = std::vector<Band>;

}  // namespace ideotype
