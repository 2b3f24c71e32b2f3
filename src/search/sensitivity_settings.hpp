// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ideotype {

enum class SensitivityMethod {
    sobol,  //!< indices of variance
    morris  //!< elementary effects
};

//! What is one factor of a sensitivity study.
enum class Grouping {
    trait,  //!< all free genes of a trait together
    gene,
};

//! How the rows of a sensitivity study are chosen.
struct SensitivitySettings {
    SensitivityMethod method = SensitivityMethod::sobol;
    int samples = 1024;  //!< base samples, or trajectories of Morris
    int levels = 4;      //!< of Morris: values of each factor
    Grouping groups = Grouping::trait;
};

}  // namespace ideotype
