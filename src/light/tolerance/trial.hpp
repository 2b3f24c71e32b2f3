// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "allocation.hpp"
#include "ideotype/light/transport.hpp"

namespace ideotype {

//! The findings of a trial.
struct Findings {
    ByOrigin<Law> laws{};      //!< laws by which variances fall
    double rays_per_unit = 0;  //!< rays per unit of scattered light's amount
    double mean = 0;           //!< light of leaves from all suns
    double first_hits = 0;     //!< first hits of leaves
    bool is_open = false;      //!< whether the leaves' light depends on paths
    bool is_whole = true;      //!< whether the trial had all suns
};

//! Learns from a simulation of one band.
//! @param is_drawn whether beams are drawn
Findings try_out(const Subject& subject, const Workload& work,
                 int randomisations, const Randomness& randomness,
                 bool is_drawn);

//! The powers with which variances fall with points of nets and lattices that
//! look at a beam. The power of skies and scattered light, which have more
//! dimensions, is 1.
inline constexpr double power_of_nets = 1.1, power_of_lattices = 1.4;

//! The costs of work in one band, and the cheapest work that meets a tolerance,
//! by the findings of the last trial.
struct WorkCosts {
    //! Returns the cheapest amounts that meet the tolerance.
    Amounts cheapest(const ByOrigin<Law>& laws, bool is_drawn,
                     const Amounts& least) const;

    //! Returns the time of the result [us].
    double cost(const Amounts& amounts, bool is_drawn) const;

    //! Returns the estimated laws for drawn beams.
    ByOrigin<Law> guess() const;

    bool pays_to_draw(const Amounts& by_rays, const Amounts& least) const;

    //! Returns the time of one more unit of each amount, in every randomisation
    //! of the result [us].
    ByOrigin<double> costs(bool is_drawn) const;

    //! Returns the factor by which diffuse first hits must increase to meet
    //! enough pieces, limited where diffuse light is very weak or pieces are
    //! very many.
    double for_pieces(const Amounts& amounts) const;

    const Subject& subject;
    bool has_pieces;  //!< whether light of pieces is needed
    const Accuracy& accuracy;
    int trials;  //!< randomisations of a trial
    const Findings& found;
};

//! Returns the number of first hits of amounts.
inline double first_hits_of(const Amounts& amounts) {
    return amounts[LightOrigin::beams] + amounts[LightOrigin::skies];
}

}  // namespace ideotype
