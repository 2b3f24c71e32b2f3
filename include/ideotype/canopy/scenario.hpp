// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/canopy/field.hpp"
#include "ideotype/light/illumination.hpp"
#include "ideotype/light/optics.hpp"

namespace ideotype {

//! What plants are evaluated under: how they stand, what lights them, and how
//! surfaces scatter light.
struct Scenario {
    FieldForm field;
    SeriesIllumination light;  //!< in the axes of the field
    Optics optics;
};

}  // namespace ideotype
