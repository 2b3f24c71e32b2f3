// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ideotype/core/range.hpp"
#include "ideotype/crop/crop.hpp"
#include "ideotype/crop/measured_lines.hpp"

namespace ideotype {

//! The traits that may be bred; all others keep the baseline's values.
using TraitSet = std::vector<std::string>;

//! A limit of the first measure that a trait acts on, in the unit of this
//! measure. A plant must keep to the limit however it is bred.
struct TraitConstraint {
    std::string trait;
    double step = 0;          //!< largest step from leaf to leaf; 0: any
    Range total{0, 1e9};      //!< total of all leaves
    bool is_falling = false;  //!< no leaf may exceed the leaf below
    //! Largest angle between a leaf and a plane to whose two sides leaves
    //! alternate [deg]; 0: any.
    double distichous = 0;
    Range range{-1e9, 1e9};  //!< range of each leaf
    int highest = 0;         //!< limited leaves, from the top down; 0: all
};

//! Returns whether a limit restricts anything.
bool constrains(const TraitConstraint& limit);

//! All limits that a plant must keep to. A plant that breaks limits is worse
//! than any plant that keeps to all, by its violation().
struct Constraints {
    Range lai{0, 1000};  //!< one-sided leaf area index [m2 m-2]
    std::vector<TraitConstraint> traits;
};

//! Returns how far a plant fails its constraints: the sum of the excesses over
//! all limits, each relative to its limit; 0 if all are met.
//! @param traits traits of the plant's crop
//! @param lai leaf area index of the plant in its stand
double violation(const Constraints& constraints,
                 const std::vector<Trait>& traits, const Plant& plant,
                 double lai);

//! The measured lines near which plants of the crop must stay.
struct Feasibility {
    std::optional<MeasuredLines> lines;
    //! Largest distance from the mean of the lines, see LineDistance; the
    //! excess over it, relative to it, is a violation. 0: no limit.
    double limit = 0;
};

}  // namespace ideotype
