// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/light/illumination.hpp"
#include "ideotype/light/optics.hpp"

namespace ideotype {

//! A waveband: the light that falls on a stand in it, and what surfaces do with
//! that light. The bands of a stand have the same sources of light, each with
//! an energy of its own.
struct Band {
    std::string name;  //!< such as "par"
    SeriesIllumination light;
    Optics optics;
    //! Tells whether a tolerance bounds the error of the light that leaves
    //! absorb in this band.
    bool is_bounded = true;
    //! Tells whether the light of pieces of leaves is counted for each of them,
    //! as it always is in the first band.
    bool is_by_piece = false;
    //! Paths of scattered light over those that a Workload asks for.
    double path_share = 1;
};

using Bands = std::vector<Band>;

}  // namespace ideotype
