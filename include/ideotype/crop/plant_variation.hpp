// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/core/random.hpp"
#include "ideotype/crop/plant.hpp"

namespace ideotype {

//! How the plants of one line differ from each other: standard deviations of
//! normal distributions, which end at three of them.
struct PlantVariation {
    double length = 0;           //!< of each blade, relative
    double width = 0;            //!< of each blade, relative
    double insertion_angle = 0;  //!< of each leaf [deg]
    double azimuth = 0;          //!< of each leaf [deg]
    //! Of the whole plant, relative: stalk, sheaths and where leaves begin.
    double height = 0;

    //! Whether plants differ at all.
    bool is_any() const;
};

//! One plant of the line. It takes the same number of random numbers whatever
//! the variation, so that a change of one deviation keeps the others. A leaf
//! that would lean to the other side of the stalk leans as far to its own.
Plant deviating(Plant plant, const PlantVariation& variation,
                RandomStream& random);

}  // namespace ideotype
