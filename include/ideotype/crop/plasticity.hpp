// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/core/range.hpp"

namespace ideotype {

struct Plant;

//! The response of measures of a plant to the density of its stand. With d the
//! density relative to Plasticity::reference, a scaled measure is multiplied by
//! d^s, and s ln(d) is added to a shifted measure. Both are linear in the
//! logarithm of density. Sizes of most phytomers of maize at 4.5 to 15 plants
//! m-2 follow a logarithmic and a linear term (He and others 2020,
//! doi:10.3389/fpls.2020.533514, abstract), of which only the first is used.
struct DensityResponse {
    //! Measures such as "leaf.length" that are scaled, and those that are
    //! shifted.
    std::vector<std::string> scales{}, shifts{};
    //! The slope s over leaf position, at equal distances from the lowest leaf
    //! to the highest, see profile(). A single value applies to all leaves.
    std::vector<double> slopes{0};
    //! Densities for which the response is known [m-2]. Outside them measures
    //! have their values at the nearest of them. Equal limits: any density.
    Range densities{};
};

//! The cue to which growing plants respond: the density of their rows, or the
//! light on their young leaves.
enum class Cue { density, light };

//! The phenotypic plasticity of a plant.
struct Plasticity {
    //! Density at which plants have the measures of their file [m-2]; 0:
    //! unknown, so that nothing responds.
    double reference = 0;
    Cue cue = Cue::density;
    //! Distance of rows in the stand at the reference density [m], in which the
    //! light on young leaves is the reference for Cue::light.
    double rows = 0.76;
    std::vector<DensityResponse> responses{};
    //! Densities at which leaves begin to turn towards the widest gap between
    //! plants, and at which they have turned by `turn` [m-2]. In between, the
    //! turn is linear in the logarithm of density. Equal: leaves do not turn.
    Range turning{};
    //! The angle by which the plane of a plant's leaves turns, relative to its
    //! angle from the direction of the gap.
    double turn = 0;
};

//! Returns the angle by which leaves turn at a density [m-2], relative to their
//! angle from the direction of the widest gap: 0 to Plasticity::turn.
double turn_at(const Plasticity& plasticity, double density);

//! Returns a plant whose leaves have responded to different densities.
//! @param densities density for each leaf [m-2]; other organs respond to their
//! geometric mean
//! @throws Error like respond() at one density
Plant respond(Plant plant, const std::vector<double>& densities);

//! Returns a plant as it grows at a density [m-2]. The measures have responded,
//! within the limits of each measure, and the result responds no further. The
//! density does not affect plants without responses.
//! @throws Error if a response names a measure that the plant lacks.
Plant respond(Plant plant, double density);

}  // namespace ideotype
