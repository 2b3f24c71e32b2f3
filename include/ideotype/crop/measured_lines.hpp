// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/crop/plant.hpp"

namespace ideotype {

//! The statistics of one measure over several lines of a crop.
struct LineTrait {
    std::string measure;  //!< measure, as "leaf.insertion_angle"
    //! The leaf to which the measure refers: "ear", "top", or a leaf relative
    //! to these in ranks, such as "ear+1" or "top-1". If a plant lacks this
    //! rank, its lowest or highest leaf is used.
    std::string leaf;
    double mean = 0;       //!< mean of the lines, in the unit of the measure
    double deviation = 1;  //!< standard deviation of the lines
};

//! One line, described by the means of its plants.
struct MeasuredLine {
    std::string name;
    std::vector<double> values;  //!< values of the traits
};

//! Measured lines of a crop: means and covariances of their traits. The
//! plausibility of other plants of the crop is judged from these.
struct MeasuredLines {
    std::vector<LineTrait> traits;
    //! Correlation of each pair of traits: the first trait with all later ones,
    //! then the second trait with all later ones, and so on.
    std::vector<double> correlations;
    //! Individual lines; empty if only statistics are known.
    std::vector<MeasuredLine> lines{};
};

//! The distance of a plant from measured lines in trait space.
struct LineDistance {
    //! Mahalanobis distance from the mean of the lines [standard deviations].
    //! The mean of its square over the lines equals the number of traits.
    double from_mean = 0;
    //! Mahalanobis distance from the nearest line; 0 if no line is known.
    double from_line = 0;
    std::size_t line = 0;  //!< nearest line, from 1; 0: no line is known
};

//! Returns whether a text is a leaf in the form of LineTrait::leaf.
bool names_leaf(const std::string& leaf);

//! Returns whether the matrix of correlations is positive definite.
bool are_correlations(const MeasuredLines& known);

//! Computes the distance of a plant from measured lines (Mahalanobis 1936,
//! reprinted as doi:10.1007/s13171-019-00164-5).
//! @throws Error if the plant lacks a measure of the traits
LineDistance distance(const MeasuredLines& known, const Plant& plant);

}  // namespace ideotype
