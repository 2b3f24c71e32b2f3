// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "ideotype/canopy/pieces.hpp"
#include "ideotype/canopy/scenario.hpp"
#include "ideotype/core/random.hpp"
#include "ideotype/crop/measured_lines.hpp"
#include "ideotype/crop/plant.hpp"
#include "ideotype/light/accuracy.hpp"
#include "ideotype/light/layers.hpp"
#include "ideotype/physiology/photosynthesis.hpp"

namespace ideotype {

//! What is to be found out about a canopy besides where light goes. None
//! changes any fitness: histories go without.
struct Details {
    //! The sunlit leaf area, which costs more rays, and, where leaves
    //! assimilate, leaf area by the light that it absorbs.
    bool sunlit = false;
    //! The light on each face: groups are then faces, not organs.
    bool faces = false;
    //! What leaves make of the light.
    std::optional<Photosynthesis> photosynthesis{};
    //! Of a blade, over each of which diffuse light is taken as even.
    std::size_t pieces = pieces_of_blade;
    bool exact = false;  //!< that by assimilate_exactly(), for checks: slow
    //! Lines that exist, to tell how far the plant is from them.
    std::optional<MeasuredLines> lines{};
};

//! One evaluation of a canopy: all that its result is a function of.
struct CanopyRequest {
    //! Plants alike, in fields of the scenario that are drawn at random; or a
    //! field that is ready.
    std::variant<Plant, Field> stand;
    Scenario scenario;
    //! In which the light that leaves absorb is counted. With no thickness they
    //! are equal parts of the height of the canopy.
    Layers layers;
    Accuracy accuracy;
    Randomness randomness;
    Details details;
    Tessellation tessellation{};  //!< of plants
};

}  // namespace ideotype
