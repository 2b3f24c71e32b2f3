// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "ideotype/core/random.hpp"
#include "ideotype/crop/plant.hpp"

namespace ideotype {

//! Standard deviations of an angle of the leaves of a plant [deg], one for each
//! of equal parts of the leaves, lowest first: three numbers are for the lower,
//! middle and upper third. One number holds for all leaves.
using LeafSpread = std::vector<double>;

//! All lengths of plants that emerged late over those of the others: E, 0.5 to
//! 0.9.
inline constexpr double late_size = 0.7;

//! The differences between plants of one line in a field, as standard
//! deviations of distributions that are cut at three standard deviations.
struct PlantVariation {
    double length = 0;              //!< length of each blade, relative, normal
    double width = 0;               //!< width of each blade, relative, normal
    LeafSpread insertion_angle{0};  //!< normal
    LeafSpread azimuth{0};          //!< normal
    //! Relative deviation of the whole plant, normal: of the stalk, the sheaths
    //! and the insertion heights of leaves.
    double height = 0;
    LeafSpread curvature{0};  //!< normal
    LeafSpread roll{0};       //!< normal
    //! Deviation of a Laplace distribution, in which most blades are hardly
    //! twisted and some are twisted a lot.
    LeafSpread twist{0};
    double missing = 0;  //!< fraction of plants that are missing
    double late = 0;     //!< fraction of plants that emerged late
    //! Fraction of plants whose leaves point across the row, within 45 deg;
    //! none: plants have only the random turn of the field.
    std::optional<double> across_row{};
    double position = 0;         //!< place along the row [m], normal
    double position_across = 0;  //!< place across the row [m], normal

    //! Returns whether plants differ in more than their direction.
    bool is_any() const;
};

//! Deviations of normal distributions are cut at this many standard deviations.
inline constexpr double most_deviations = 3;

//! Returns a deviation, in standard deviations, that is cut on both sides.
double cut_deviation(double deviation);

//! Returns one plant of a line. The number of random numbers that are drawn
//! does not depend on the variation, so that a change of one deviation keeps
//! the others. A leaf that would lean to the opposite side of the stalk leans
//! as far to its own side.
//! @param side 1, or -1: with equal random numbers all deviations are then
//! opposite, so that the mean of two such plants is nearer to the line
Plant deviating(Plant plant, const PlantVariation& variation,
                RandomStream& random, double side = 1);

//! Returns the height that a leaf of a plant would reach if it stood upright,
//! on the largest plant of its line [m].
double furthest(const Plant& plant, const Leaf& leaf,
                const PlantVariation& variation = {});

//! Returns a plant all of whose lengths are `size` times as large.
Plant scaled(Plant plant, double size);

}  // namespace ideotype
