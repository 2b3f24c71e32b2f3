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
    //! Instead of rows: so many of the places of plants that are bred, drawn
    //! for each field. 0: none.
    int mixed = 0;
    int plants = 0;                  //!< in each of its rows; 0: as the field's
    int later = 0;                   //!< it emerges than the crop [d]
    std::optional<double> jitter{};  //!< in the place of the field's [deg]
    //! Variation of its plants, in the place of that of the field.
    std::optional<PlantVariation> variation{};
};

//! A kind of plant that stands in the field beside that of the campaign's crop.
struct ComponentEntry {
    std::string name;
    Standing standing;
    Crop crop;
    std::vector<Range> bounds;  //!< bounds of trait_numbers(crop)
    TraitSet free;              //!< its bred traits; none: it stays as it is
    ByBand<PlantOptics> optics;
    std::optional<Photosynthesis> photosynthesis{};  //!< if leaves assimilate
    Stomata stomata{};                               //!< if they exchange water
};

}  // namespace ideotype
