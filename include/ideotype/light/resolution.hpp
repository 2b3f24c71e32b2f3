// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "ideotype/core/estimate.hpp"

namespace ideotype {

//! Lower bounds on the errors of figures, set by the number of paths in one
//! randomisation. Even a figure to which no path has contributed, such as the
//! light on a small leaf, is only known to within the energy that a surface
//! absorbs from one path. A figure that the scene determines exactly, such as
//! the light scattered by black surfaces, has no error.
struct Resolution {
    //! The energy of one path of each source [J m-2 of ground].
    std::vector<double> path_energy;

    // The following members are the largest fraction of a path's energy that a
    // figure can gain when the path meets its surfaces once: their largest
    // absorptance. They are 0 if the figure does not depend on paths, because
    // all light or no light ends there.
    double leaves = 0;
    double organs = 0;
    double objects = 0;
    double soil = 0;
    double reflected = 0;
    //! The fraction of unscattered light that leaves absorb.
    double unscattered = 0;
    double scattered = 0;  //!< fraction of scattered light that leaves absorb
    std::vector<double> groups{};  //!< fractions of paths, by group of the mesh
    std::vector<double> layers{};  //!< fractions of paths, by layer of leaves

    //! Returns the largest energy of a path of any source [J m-2 of ground].
    double largest_path() const {
        return path_energy.empty() ? 0 : std::ranges::max(path_energy);
    }
};

//! Returns, member by member, the larger of the values of two resolutions.
Resolution combined(const Resolution& a, const Resolution& b);

//! Returns an estimate with its standard error raised to at least the given
//! value.
Estimate at_least(Estimate x, double standard_error);

}  // namespace ideotype
