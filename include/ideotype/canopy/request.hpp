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

//! The results that are wanted of a canopy in addition to the absorbed light.
//! None of them changes an objective, and histories do not contain them.
struct Details {
    //! Whether to find the sunlit leaf area, which costs more rays, and, if
    //! leaves assimilate, leaf area by the light that it absorbs.
    bool sunlit = false;
    //! Whether to find the light on each face: each face is then a group.
    bool faces = false;
    //! Number of pieces of a blade; diffuse light is taken as even over each.
    std::size_t pieces = pieces_of_blade;
    //! True to use assimilate_exactly(), which is slow and for checks.
    bool exact = false;
    //! Whether to find the form of the plant of the first component.
    bool form = false;
    //! Lines of which the distance from the first component's plant is wanted.
    std::optional<MeasuredLines> lines{};
};

//! An evaluation of a canopy, with all inputs that its result depends on.
struct CanopyRequest {
    Scene scene;
    //! Layers in which the light that leaves absorb is counted. If their
    //! thickness is 0, they are equal parts of the height of the scene.
    Layers layers;
    Accuracy accuracy;
    Randomness randomness;
    Details details{};
};

}  // namespace ideotype
