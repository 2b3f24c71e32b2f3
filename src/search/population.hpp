// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "outcome.hpp"

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

//! No parent: the individual is of the first generation.
inline constexpr std::int64_t no_parent = -1;

//! Where a genome came from. The numbers are part of the file format.
enum class Origin : std::uint8_t {
    none = 0,
    baseline = 1,
    random = 2,
    elite = 3,  //!< a parent evaluated again under new random numbers
    child = 4,
    sample = 5,  //!< drawn from a distribution that the search adapts
};

//! For example "baseline".
const char* name_of(Origin origin);

//! A genome and its descent.
struct Candidate {
    Genome genome;
    Origin origin = Origin::none;
    //! Rows of its parents, counted through all generations, or no_parent.
    std::array<std::int64_t, 2> parents{no_parent, no_parent};

    bool operator==(const Candidate&) const = default;
};

//! An evaluated candidate.
struct Individual {
    Candidate candidate;
    Status status = Status::failed;
    std::vector<Estimate> objectives;  //!< may be negative
    //! How far the constraints are failed; 0 if all are met.
    double violation = 0;
    //! Each objective by randomisation [objective, randomisation], if known.
    std::vector<double> randomisations{};
};

//! One generation, by slot.
using Population = std::vector<Individual>;

}  // namespace ideotype
