// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "ideotype/canopy/pieces.hpp"
#include "ideotype/canopy/scene.hpp"
#include "ideotype/core/random.hpp"
#include "ideotype/crop/measured_lines.hpp"
#include "ideotype/light/accuracy.hpp"
#include "ideotype/light/layers.hpp"

namespace ideotype {

//! The results that are wanted of a canopy besides the absorbed light. None
//! changes any fitness: histories go without.
struct Details {
    //! The sunlit leaf area, which costs more rays, and, where leaves
    //! assimilate, leaf area by the light that it absorbs.
    bool sunlit = false;
    //! The light on each face: groups are then faces, not organs.
    bool faces = false;
    //! Pieces of a blade, over each of which diffuse light is taken as even.
    std::size_t pieces = pieces_of_blade;
    //! True to use assimilate_exactly(), which is slow and for checks.
    bool exact = false;
    //! The form of the plant of the first component.
    bool form = false;
    //! Lines that exist, to tell how far the plant of the first component is
    //! from them.
    std::optional<MeasuredLines> lines{};
};

//! An evaluation of a canopy: all that its result is a function of.
struct CanopyRequest {
    Scene scene;
    //! Layers of height in which the light that leaves absorb is counted. With
    //! no thickness they are equal parts of the height of the scene.
    Layers layers;
    Accuracy accuracy;
    Randomness randomness;
    Details details{};
};

}  // namespace ideotype
