// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ideotype/core/estimate.hpp"

namespace ideotype {

//! What the paths of one randomisation can tell. A figure that no path
//! contradicts, such as a small leaf that none has met, is still only known to
//! about the energy of one path. A figure that follows from the scene, such as
//! the light that black surfaces scatter, is certain.
struct Resolution {
    //! Energy of one path of each source [J m-2 of ground].
    std::vector<double> path_energy;

    // Which figures depend on the paths: light may end there, or elsewhere.
    bool leaves = false;
    bool stalks = false;
    bool soil = false;
    bool reflected = false;
    bool unscattered = false;  //!< of leaves
    bool scattered = false;    //!< of leaves
    std::vector<bool> groups;  //!< of the mesh
    std::vector<bool> layers;  //!< of leaves

    //! The energy of the largest path of any source [J m-2 of ground].
    double largest_path() const;
};

//! Both: the larger energies, and all figures that depend on either's paths.
Resolution combined(const Resolution& a, const Resolution& b);

//! An estimate whose standard error is at least what its paths can tell.
Estimate at_least(Estimate x, double standard_error);

}  // namespace ideotype
