// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "ideotype/core/random.hpp"
#include "ideotype/crop/plant.hpp"

namespace ideotype {

//! Standard deviations of an angle of the leaves of a plant [deg], one for
//! each of equal parts of the leaves, lowest first: three numbers are those of
//! the lower, middle and upper third. One number holds for all leaves.
using LeafSpread = std::vector<double>;

//! The differences of plants of one line in a field: standard deviations of
//! distributions that end at three of them.
struct PlantVariation {
    double length = 0;              //!< length of each blade, relative, normal
    double width = 0;               //!< width of each blade, relative, normal
    LeafSpread insertion_angle{0};  //!< normal
    LeafSpread azimuth{0};          //!< normal
    //! Relative deviation of the whole plant, normal: stalk, sheaths and where
    //! leaves begin.
    double height = 0;
    LeafSpread curvature{0};  //!< normal
    LeafSpread roll{0};       //!< normal
    //! Deviation of a Laplace distribution, in which most blades are hardly
    //! twisted and some are twisted a lot.
    LeafSpread twist{0};
    double missing = 0;  //!< fraction of plants that there are not
    double late = 0;     //!< fraction of plants that emerged late
    double late_size =
        0.7;  //!< of late plants: all lengths over those of others
    //! Fraction of plants whose leaves point across the row, within 45 deg;
    //! none: all plants do, but for the turn that the field gives them.
    std::optional<double> across_row{};

    //! Returns whether plants differ by more than their direction.
    bool is_any() const;
};

//! One plant of the line. It takes the same number of random numbers whatever
//! the variation, so that a change of one deviation keeps the others. A leaf
//! that would lean to the other side of the stalk leans as far to its own.
//! @param side 1, or -1: with the same random numbers all deviations are then
//!             opposite, so that two such plants together are nearer to the
//!             line
Plant deviating(Plant plant, const PlantVariation& variation,
                RandomStream& random, double side = 1);

//! Returns how high a leaf of a plant would reach if it stood upright, on the
//! largest plant of its line [m].
double furthest(const Plant& plant, const Leaf& leaf,
                const PlantVariation& variation = {});

//! Returns a plant all of whose lengths are `size` times as large.
Plant scaled(Plant plant, double size);

}  // namespace ideotype
