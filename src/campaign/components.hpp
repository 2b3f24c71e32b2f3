// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "constraints.hpp"
#include "ideotype/canopy/field.hpp"
#include "ideotype/canopy/scene.hpp"
#include "ideotype/core/range.hpp"
#include "ideotype/crop/crop.hpp"
#include "ideotype/physiology/photosynthesis.hpp"

namespace ideotype {

//! The places of the plants of a component in the field.
struct Standing {
    std::vector<int> rows{};  //!< rows of the field, from 0
    //! Number of places of bred plants that the component takes instead of
    //! rows, drawn for each field. 0: none.
    int mixed = 0;
    int plants = 0;                  //!< plants per row; 0: as in the field
    int later = 0;                   //!< delay of emergence after the crop [d]
    std::optional<double> jitter{};  //!< jitter instead of the field's [deg]
    //! Variation of the plants instead of that of the field.
    std::optional<PlantVariation> variation{};
};

//! A kind of plant that stands in the field beside that of the campaign's crop.
struct ComponentEntry {
    std::string name;
    Standing standing;
    Crop crop;
    std::vector<Range> bounds;  //!< bounds of trait_numbers(crop)
    TraitSet free;              //!< bred traits; none: not bred
    ByBand<PlantOptics> optics;
    //! Model of assimilation, if leaves assimilate.
    std::optional<Photosynthesis> photosynthesis{};
    Stomata stomata{};  //!< stomata, if leaves exchange water
};

}  // namespace ideotype
