// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/light/illumination.hpp"
#include "ideotype/light/optics.hpp"

namespace ideotype {

//! A waveband with the light that falls on a stand and the optics of surfaces.
//! All bands of a stand have the same sources, with different energies.
struct Band {
    std::string name;  //!< name, such as "par"
    SeriesIllumination light;
    Optics optics;
    //! Whether a tolerance bounds the error of the light that leaves
    //! absorb in this band.
    bool is_bounded = true;
    //! Whether light is counted for each piece of a leaf, as it always is
    //! in the first band.
    bool is_by_piece = false;
    //! The number of paths of scattered light over the number that a Workload
    //! asks for.
    double path_share = 1;
};

using Bands = std::vector<Band>;

}  // namespace ideotype
