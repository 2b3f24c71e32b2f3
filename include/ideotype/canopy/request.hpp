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
#include "ideotype/light/ray_scene.hpp"
#include "ideotype/light/tolerance.hpp"

namespace ideotype {

//! The results that are requested in addition to the absorbed light. None of
//! them changes an objective, and histories do not contain them.
struct Details {
    //! Whether to compute the sunlit leaf area, which takes more rays, and, if
    //! leaves assimilate, leaf area by absorbed light.
    bool sunlit = false;
    //! Whether to compute the light on each face: each face is then a group.
    bool faces = false;
    //! Number of pieces per blade; diffuse light is taken as uniform over a
    //! piece.
    std::size_t pieces = pieces_of_blade;
    //! Whether to use assimilate_exactly(), a slow check.
    bool exact = false;
    //! Whether to compute the form of the first component's plant.
    bool form = false;
    //! Whether the soil of the season dries, and whether grain fills. Growth of
    //! each date is then reported.
    bool soil = false, grain = false;
    //! Whether the season has prices, so that its margin is computed.
    bool prices = false;
    //! Measured lines; their distance from the first component's plant is
    //! computed.
    std::optional<MeasuredLines> lines{};
};

//! The work with which light is traced in each field of an evaluation.
struct LightWork {
    Demand demand;
    BoxTree tree{};  //!< tree of boxes for this work
};

//! An evaluation of a canopy, with all inputs that its result depends on.
struct CanopyRequest {
    Scene scene;
    //! Layers in which the light absorbed by leaves is counted. A thickness of
    //! 0 divides the height of the scene into equal layers.
    Layers layers;
    Accuracy accuracy;
    Randomness randomness;
    Details details{};
    //! Work with which the light in each field is traced; if there is none,
    //! trials in the first field determine what the tolerance requires.
    std::optional<LightWork> work{};
};

}  // namespace ideotype
