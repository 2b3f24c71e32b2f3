// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "ideotype/core/random.hpp"
#include "ideotype/crop/plant.hpp"

namespace ideotype {

//! Standard deviations of a leaf angle [deg]. The leaves are divided into as
//! many equal parts as there are values, lowest first: three values apply to
//! the lower, middle and upper third. A single value applies to all leaves.
using LeafSpread = std::vector<double>;

//! Size of late-emerging plants relative to the others (evidence E, from 0.5 to
//! 0.9).
inline constexpr double late_size = 0.7;

//! Variation between plants of one line in a field. Standard deviations refer
//! to distributions that are then truncated at three standard deviations.
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
    //! Standard deviation of a Laplace distribution: most blades are hardly
    //! twisted, and a few are twisted strongly.
    LeafSpread twist{0};
    double missing = 0;  //!< fraction of plants that are missing
    double late = 0;     //!< fraction of plants that emerged late
    //! Fraction of plants with leaves within 45 deg of across the row; none:
    //! plants have only the random azimuth of the field.
    std::optional<double> across_row{};
    double position = 0;         //!< position along the row [m], normal
    double position_across = 0;  //!< position across the row [m], normal

    //! Returns whether plants differ in more than their azimuth.
    bool is_any() const;
};

//! Normal deviates are truncated at this many standard deviations.
inline constexpr double most_deviations = 3;

//! Limits a deviation, in standard deviations, on both sides.
double cut_deviation(double deviation);

//! Samples one plant of a line. The number of random numbers used does not
//! depend on the variation, so changing one standard deviation leaves the other
//! deviations unchanged (common random numbers). A leaf that would lean to the
//! opposite side of the stalk leans by the same angle to its original side.
//! @param side 1, or -1 for the antithetic plant: with equal random numbers all
//! deviations are reversed, so the mean of the two plants is closer to the line
Plant deviating(Plant plant, const PlantVariation& variation,
                RandomStream& random, double side = 1);

//! Returns the greatest height that a leaf could reach if it stood upright on
//! the largest plant of its line [m].
double furthest(const Plant& plant, const Leaf& leaf,
                const PlantVariation& variation = {});

//! Returns a plant with all lengths multiplied by `size`.
Plant scaled(Plant plant, double size);

}  // namespace ideotype
