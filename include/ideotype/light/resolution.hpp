// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ideotype/core/estimate.hpp"

namespace ideotype {

//! What the paths of one randomisation can tell. A figure that no path
//! contradicts, such as a small leaf that none has met, is still only known to
//! what a surface would have kept of one path. A figure that follows from the
//! scene, such as the light that black surfaces scatter, is certain.
struct Resolution {
    //! Energy of one path of each source [J m-2 of ground].
    std::vector<double> path_energy;

    // The part of a path that a figure gains where the path is met once: the
    // largest absorptance of its surfaces. It is 0 if the figure does not
    // depend on paths, because light can end nowhere else or cannot end there.
    double leaves = 0;
    double stalks = 0;
    double objects = 0;
    double soil = 0;
    double reflected = 0;
    double unscattered = 0;        //!< of leaves
    double scattered = 0;          //!< of leaves
    std::vector<double> groups{};  //!< of the mesh
    std::vector<double> layers{};  //!< of leaves

    //! The energy of the largest path of any source [J m-2 of ground].
    double largest_path() const;
};

//! Both: the larger energies, and the larger parts of a path.
Resolution combined(const Resolution& a, const Resolution& b);

//! An estimate whose standard error is at least what its paths can tell.
Estimate at_least(Estimate x, double standard_error);

}  // namespace ideotype
