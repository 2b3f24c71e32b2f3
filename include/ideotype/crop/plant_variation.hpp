// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "ideotype/core/random.hpp"
#include "ideotype/crop/plant.hpp"

namespace ideotype {

//! Standard deviations of a leaf angle [deg], one for each of equal parts of
//! the leaves, lowest first: three values are for the lower, middle and upper
//! third. A single value applies to all leaves.
using LeafSpread = std::vector<double>;

//! Size of plants that emerged late relative to the others (evidence E, from
//! 0.5 to 0.9).
inline constexpr double late_size = 0.7;

//! Variation between plants of one line in a field, as standard deviations of
//! distributions truncated at three standard deviations.
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
    //! Fraction of plants with leaves across the row, within 45 deg; none:
    //! plants have only the random azimuth of the field.
    std::optional<double> across_row{};
    double position = 0;         //!< position along the row [m], normal
    double position_across = 0;  //!< position across the row [m], normal

    //! Returns whether plants differ in more than their azimuth.
    bool is_any() const;
};

//! Normal deviates are truncated at this many standard deviations.
inline constexpr double most_deviations = 3;

//! Returns a deviation, in standard deviations, truncated on both sides.
double cut_deviation(double deviation);

//! Draws one plant of a line. The number of random numbers used does not depend
//! on the variation, so a change of one deviation leaves the others unchanged
//! (common random numbers). A leaf that would lean to the opposite side of the
//! stalk leans by the same angle to its own side.
//! @param side 1, or -1 for the antithetic plant: with equal random numbers all
//! deviations are opposite, so the mean of the two plants is nearer to the line
Plant deviating(Plant plant, const PlantVariation& variation,
                RandomStream& random, double side = 1);

//! Returns the largest height that a leaf could reach, upright on the largest
//! plant of its line [m].
double furthest(const Plant& plant, const Leaf& leaf,
                const PlantVariation& variation = {});

//! Returns a plant with all lengths multiplied by `size`.
Plant scaled(Plant plant, double size);

}  // namespace ideotype
