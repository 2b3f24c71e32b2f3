// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "genome.hpp"

namespace ideotype {

//! Recombines one gene of two parents by simulated binary crossover (Deb and
//! Agrawal 1995), along the shorter arc for a circular gene.
//! @param u uniform in [0, 1)
std::pair<double, double> cross(const Gene& gene, double a, double b, double u,
                                double index);

//! Varies one gene by a step whose density falls off as a polynomial (Deb and
//! Goyal 1996; steps bounded as in NSGA-II).
//! @param u uniform in [0, 1)
double mutate(const Gene& gene, double value, double u, double index);

}  // namespace ideotype
