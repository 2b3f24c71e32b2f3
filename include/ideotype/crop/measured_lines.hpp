// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ideotype/crop/plant.hpp"

namespace ideotype {

//! A number that was measured of several lines of a crop.
struct LineTrait {
    std::string measure;  //!< of a plant, such as "leaf.insertion_angle"
    //! The leaf whose measure it is, if leaves have it: "ear", "top", or one
    //! that is so many ranks away, such as "ear+1" or "top-1". A rank beyond
    //! the leaves of a plant stands for its lowest or highest leaf.
    std::string leaf;
    double mean = 0;       //!< mean of the lines, in the unit of the measure
    double deviation = 1;  //!< standard deviation of the lines
};

//! One line, by the means of its plants.
struct MeasuredLine {
    std::string name;
    std::vector<double> values;  //!< values of the traits
};

//! Lines of a crop that exist, as means and covariances of what was measured of
//! them: what plants of this crop can be.
struct MeasuredLines {
    std::vector<LineTrait> traits;
    //! Correlation of each pair of traits: of the first with all later ones,
    //! then of the second with all later ones, and so on.
    std::vector<double> correlations;
    std::vector<MeasuredLine> lines{};  //!< none if only means are known
};

//! The distance of a plant from measured lines.
struct LineDistance {
    //! Mahalanobis distance from the mean of the lines [standard deviations].
    //! The mean of its square over the lines is the number of traits.
    double from_mean = 0;
    //! Mahalanobis distance from the nearest line; 0 where no line is known.
    double from_line = 0;
    std::size_t line = 0;  //!< the nearest one, from 1; 0: no line is known
};

//! Returns whether a text names a leaf as LineTrait does.
bool names_leaf(const std::string& leaf);

//! Returns whether correlations can be those of numbers: their matrix is
//! positive definite.
bool are_correlations(const MeasuredLines& known);

//! Returns the distance of a plant from measured lines (Mahalanobis 1936,
//! reprinted as doi:10.1007/s13171-019-00164-5).
//! @throws Error if a trait is a measure that the plant does not have
LineDistance distance(const MeasuredLines& known, const Plant& plant);

}  // namespace ideotype
