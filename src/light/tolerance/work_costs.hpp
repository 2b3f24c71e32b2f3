// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "trial.hpp"

namespace ideotype {

//! Tells what work in one band costs, and the cheapest that meets a tolerance,
//! by the findings of the last trial.
struct WorkCosts {
    //! Returns the cheapest amounts that meet the tolerance.
    Amounts cheapest(const ByOrigin<Law>& laws, bool is_drawn,
                     const Amounts& least) const;

    //! Returns the time of the result [us].
    double cost(const Amounts& amounts, bool is_drawn) const;

    //! Returns the laws that drawing the beams would have.
    ByOrigin<Law> guess() const;

    bool pays_to_draw(const Amounts& by_rays, const Amounts& least) const;

    //! Returns the time of one more unit of each amount, in every randomisation
    //! of the result [us].
    ByOrigin<double> costs(bool is_drawn) const;

    //! Returns the factor by which light that is no beam has to be increased to
    //! meet enough pieces, within reason: there may be next to none, or very
    //! many pieces.
    double for_pieces(const Amounts& amounts) const;

    const Subject& subject;
    bool has_pieces;  //!< tells whether leaves are to be known piece by piece
    const Accuracy& accuracy;
    int trials;  //!< randomisations of a trial
    const Findings& found;
};

//! Returns the first hits of amounts.
inline double first_hits_of(const Amounts& amounts) {
    return amounts[LightOrigin::beams] + amounts[LightOrigin::skies];
}

}  // namespace ideotype
