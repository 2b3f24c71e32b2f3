// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "ideotype/core/estimate.hpp"

namespace ideotype {

//! The least error of figures, which follows from the number of paths of one
//! randomisation. Even a figure that no path has changed, such as that of a
//! small leaf, is only known to the energy that a surface keeps of one path. A
//! figure that follows from the scene, such as the light that black surfaces
//! scatter, is certain.
struct Resolution {
    //! The energy of one path from each source [J m-2 of ground].
    std::vector<double> path_energy;

    // The following members are parts of a path that a figure gains when the
    // path meets its surfaces once: their largest absorptance. A part is 0 if
    // the figure does not depend on paths, since all light or no light ends in
    // it.
    double leaves = 0;
    double organs = 0;
    double objects = 0;
    double soil = 0;
    double reflected = 0;
    //! The fraction of unscattered light that is absorbed by leaves.
    double unscattered = 0;
    double scattered = 0;  //!< part of scattered light that leaves absorb
    std::vector<double> groups{};  //!< parts of paths for groups of the mesh
    std::vector<double> layers{};  //!< parts of paths for layers of leaves

    //! Returns the energy of the largest path of any source [J m-2 of ground].
    double largest_path() const {
        return path_energy.empty() ? 0 : std::ranges::max(path_energy);
    }
};

//! Returns the larger energies, and the larger parts of a path, of two
//! resolutions.
Resolution combined(const Resolution& a, const Resolution& b);

//! Returns an estimate with a standard error not below the least error that
//! its paths allow.
Estimate at_least(Estimate x, double standard_error);

}  // namespace ideotype
