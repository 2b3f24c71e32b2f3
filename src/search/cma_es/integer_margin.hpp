// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

namespace ideotype {

//! The probability with which a discrete coordinate leaves its most probable
//! value at least, so that one of all coordinates does in 27 % of the points
//! (Hamano et al. 2025, arXiv:2504.07884).
//! @param coordinates number of discrete coordinates, integers and choices
double discrete_margin(std::size_t coordinates);

//! The integer coordinate of CMA-ES that CatCMA with margin handles (Hamano et
//! al. 2025, arXiv:2504.07884). Its values are 0 to count - 1; a real position
//! has the nearest of them. Without a margin, a normal distribution that is
//! narrower than the distance of two values would always give the same one, and
//! the coordinate could not change any more.
class IntegerMargin {
  public:
    //! The mean and the standard deviation of the coordinate.
    struct Marginal {
        double mean = 0, deviation = 0;
    };

    //! @param count number of values, >= 2
    //! @param margin smallest probability to leave the most probable value, in
    //! (0, 0.5)
    IntegerMargin(std::size_t count, double margin);

    //! Returns the value at a position.
    double value(double position) const;

    //! Moves the positions of selected points to their values if these differ
    //! from the value of the mean. Other positions are moved towards theirs, so
    //! far that the mean of all is unchanged. Notes whether any value differs.
    //! @param positions positions of the better half of a generation
    //! @param mean mean of the distribution from which they were drawn
    void centre(std::span<double> positions, double mean);

    //! Corrects an updated distribution, so that it leaves its most probable
    //! value with at least the probability of the margin and, unless a selected
    //! value differed from that of the mean, no more often than before.
    Marginal correct(Marginal updated);

  private:
    Marginal correct_at_end(Marginal updated, double threshold);
    Marginal correct_between(Marginal updated, double lower, double upper);

    double largest_;
    double margin_;
    double mutation_ = 0.5;  //!< probability to leave the most probable value
    bool has_succeeded_ = false;  //!< whether a selected value differed
};

}  // namespace ideotype
