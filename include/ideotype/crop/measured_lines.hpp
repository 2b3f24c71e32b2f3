// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/crop/plant.hpp"

namespace ideotype {

//! A measure that was taken on several lines of a crop.
struct LineTrait {
    std::string measure;  //!< measure, as "leaf.insertion_angle"
    //! The leaf to which a measure of leaves belongs: "ear", "top", or a leaf
    //! so many ranks away, such as "ear+1" or "top-1". A rank beyond the leaves
    //! of a plant stands for its lowest or highest leaf.
    std::string leaf;
    double mean = 0;       //!< mean of the lines, in the unit of the measure
    double deviation = 1;  //!< standard deviation of the lines
};

//! One line, described by the means of its plants.
struct MeasuredLine {
    std::string name;
    std::vector<double> values;  //!< values of the traits
};

//! Measured lines of a crop: means and covariances of their traits, from which
//! the plausibility of a plant of the crop is judged.
struct MeasuredLines {
    std::vector<LineTrait> traits;
    //! Correlation of each pair of traits: the first trait with all later ones,
    //! then the second trait with all later ones, and so on.
    std::vector<double> correlations;
    std::vector<MeasuredLine> lines{};  //!< lines; none: only means known
};

//! The distance of a plant from measured lines in trait space.
struct LineDistance {
    //! Mahalanobis distance from the mean of the lines [standard deviations];
    //! its mean square over the lines is the number of traits.
    double from_mean = 0;
    //! Mahalanobis distance from the nearest line; 0 if no line is known.
    double from_line = 0;
    std::size_t line = 0;  //!< nearest line, from 1; 0: no line is known
};

//! Returns whether a text is a leaf in the form of LineTrait::leaf.
bool names_leaf(const std::string& leaf);

//! Returns whether the matrix of correlations is positive definite.
bool are_correlations(const MeasuredLines& known);

//! Returns the distance of a plant from measured lines (Mahalanobis 1936,
//! reprinted as doi:10.1007/s13171-019-00164-5).
//! @throws Error if a trait is a measure that the plant does not have
LineDistance distance(const MeasuredLines& known, const Plant& plant);

}  // namespace ideotype
