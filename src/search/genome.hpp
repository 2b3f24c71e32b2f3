// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ideotype {

//! One plant as numbers: for each leaf from the lowest up its length [m],
//! width [m], insertion angle [deg] and azimuth [deg].
using Genome = std::vector<double>;

//! What values one gene may take.
struct Gene {
    std::string name;  //!< for example "leaf03_length"
    std::string unit;  //!< "m" or "deg"
    double lower = 0;
    double upper = 0;
    bool is_circular = false;  //!< lower and upper are the same point
    bool is_free = true;       //!< if not, the gene keeps the baseline value
    std::string trait{};       //!< for example "length"
    int leaf = 0;              //!< rank from the lowest, 1; 0: whole plant
};

using GeneSpace = std::vector<Gene>;

//! How many of them are free.
std::size_t count_free(const GeneSpace& genes);

//! The value on the circle that a circular gene stands for, in
//! [lower, upper).
double wrapped(const Gene& gene, double value);

//! The signed way from a to b: along the shorter arc for a circular gene.
double difference(const Gene& gene, double a, double b);

}  // namespace ideotype
