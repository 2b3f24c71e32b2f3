// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "allocation.hpp"
#include "ideotype/light/transport.hpp"

namespace ideotype {

//! The results of a trial.
struct Findings {
    ByOrigin<Law> laws{};  //!< laws by which variances decrease
    //! Rays per unit of the amount of scattered light.
    double rays_per_unit = 0;
    double mean = 0;        //!< light on leaves from all suns
    double first_hits = 0;  //!< number of first hits on leaves
    bool is_open = false;   //!< whether light on leaves depends on paths
    bool is_whole = true;   //!< whether the trial included all suns
};

//! Estimates the laws from a simulation of one band.
//! @param is_drawn whether beams are rasterised
Findings try_out(const Subject& subject, const Workload& work,
                 int randomisations, const Randomness& randomness,
                 bool is_drawn);

//! The powers with which variances decrease with the number of points of a
//! beam: for nets and for lattices. For skies and scattered light, which have
//! more dimensions, the power is 1.
inline constexpr double power_of_nets = 1.1, power_of_lattices = 1.4;

//! Computes the cost of work in one band, and the cheapest work that meets a
//! tolerance, from the results of the last trial.
struct WorkCosts {
    //! Returns the cheapest amounts that meet the tolerance.
    Amounts cheapest(const ByOrigin<Law>& laws, bool is_drawn,
                     const Amounts& least) const;

    //! Returns the time to compute the result [us].
    double cost(const Amounts& amounts, bool is_drawn) const;

    //! Returns the estimated laws for rasterised beams.
    ByOrigin<Law> guess() const;

    bool pays_to_draw(const Amounts& by_rays, const Amounts& least) const;

    //! Returns the time per unit of each amount, for all randomisations of the
    //! result [us].
    ByOrigin<double> costs(bool is_drawn) const;

    //! Returns the factor by which diffuse first hits must increase to hit
    //! enough pieces. The factor is limited if diffuse light is very weak or
    //! there are very many pieces.
    double for_pieces(const Amounts& amounts) const;

    const Subject& subject;
    bool has_pieces;  //!< whether light by piece is needed
    const Accuracy& accuracy;
    int trials;  //!< number of randomisations of a trial
    const Findings& found;
};

//! Returns the total number of first hits.
inline double first_hits_of(const Amounts& amounts) {
    return amounts[LightOrigin::beams] + amounts[LightOrigin::skies];
}

}  // namespace ideotype
