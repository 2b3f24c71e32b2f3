// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ideotype/core/estimate.hpp"

namespace ideotype {

//! The least error of figures: the amount that the paths of one randomisation
//! can tell. A figure that no path contradicts, such as a small leaf that none
//! has met, is still only known to the energy that a surface would have kept of
//! one path. A figure that follows from the scene, such as the light that black
//! surfaces scatter, is certain.
struct Resolution {
    //! The energy of one path of each source [J m-2 of ground].
    std::vector<double> path_energy;

    // The following are parts of a path that a figure gains where the path is
    // met once: the largest absorptance of its surfaces. They are 0 if the
    // figure does not depend on paths, because light can end nowhere else or
    // cannot end there.
    double leaves = 0;
    double organs = 0;
    double objects = 0;
    double soil = 0;
    double reflected = 0;
    //! Part of light that leaves get straight from a source.
    double unscattered = 0;
    double scattered = 0;          //!< part of scattered light that leaves get
    std::vector<double> groups{};  //!< parts of groups of the mesh
    std::vector<double> layers{};  //!< parts of layers of leaves

    //! Returns the energy of the largest path of any source [J m-2 of ground].
    double largest_path() const;
};

//! Returns the larger energies, and the larger parts of a path, of two
//! resolutions.
Resolution combined(const Resolution& a, const Resolution& b);

//! Returns an estimate whose standard error is at least that which its paths
//! can tell.
Estimate at_least(Estimate x, double standard_error);

}  // namespace ideotype
