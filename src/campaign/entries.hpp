// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ideotype/canopy/field.hpp"
#include "ideotype/canopy/scene.hpp"
#include "ideotype/core/range.hpp"
#include "ideotype/crop/crop.hpp"
#include "ideotype/physiology/photosynthesis.hpp"
#include "spec/spec.hpp"

namespace ideotype {

//! Returns the constraint violation of a plant: the sum over all limits of the
//! excess relative to the limit; 0 if all constraints are met.
//! @param traits traits of the plant's crop
//! @param lai leaf area index of the plant in its stand
double violation(const Constraints& constraints,
                 const std::vector<Trait>& traits, const Plant& plant,
                 double lai);

//! The positions of the plants of a component in the field.
struct Standing {
    std::vector<int> rows{};  //!< indices of its rows in the field, from 0
    //! Number of positions of the main crop that the component takes, instead
    //! of whole rows. The positions are drawn at random for each field. 0:
    //! none.
    int mixed = 0;
    int plants = 0;  //!< plants per row; 0: as in the field
    int later = 0;   //!< delay of emergence after the main crop [d]
    std::optional<double> jitter{};  //!< jitter instead of the field's [deg]
    std::optional<PlantVariation>
        variation{};  //!< within-line variation instead of the field's
};

//! A parameter of a leaf model.
struct LeafNumber {
    std::string name;
    std::vector<double> values;  //!< one value, or one per leaf; empty: see
                                 //!< docs/campaign_files.md
    std::string file;            //!< file that states it; "": default
    bool is_capacity = false;    //!< whether it is a photosynthetic capacity
};

//! The photosynthesis parameters of a component, with the files that state
//! them.
struct StatedLeaves {
    std::string crop, model;
    std::string file;  //!< file that states the model; "": default
    std::vector<LeafNumber> numbers;
};

//! A kind of plant that stands in the field in addition to the main crop.
struct ComponentEntry {
    std::string name;
    Standing standing;
    Crop crop;
    std::vector<Range> bounds;  //!< bounds of trait_numbers(crop)
    TraitSet free;              //!< optimised traits; empty: not optimised
    ByBand<PlantOptics> optics;
    //! Mesh of each plant, which replaces a crop, and the materials of its
    //! groups.
    std::optional<Mesh> mesh{};
    std::vector<MaterialSpec> materials{};
    //! Photosynthesis model, if assimilation is computed.
    std::optional<Photosynthesis> photosynthesis{};
    Stomata stomata{};  //!< stomata, if water fluxes are computed
};

}  // namespace ideotype
