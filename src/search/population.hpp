// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "outcome.hpp"

namespace ideotype {

//! A plant as numbers, one for each gene of a GeneSpace, in the gene's unit.
using Genome = std::vector<double>;

//! A number of a plant that may be bred, and the values that it may have.
struct Gene {
    std::string name;  //!< name, for example "leaf03_length"
    std::string unit;  //!< unit, "m" or "deg"
    double lower = 0;
    double upper = 0;
    bool is_circular = false;  //!< tells whether lower and upper are one point
    bool is_free = true;       //!< otherwise the gene keeps the baseline value
    std::string trait{};       //!< trait, for example "length"
    int leaf = 0;  //!< rank from the lowest, 1; 0 for the whole plant
};

using GeneSpace = std::vector<Gene>;

//! Returns the number of free genes.
std::size_t count_free(const GeneSpace& genes);

//! Returns a circular gene's value at the same point within [lower, upper).
double wrapped(const Gene& gene, double value);

//! Returns the nearest value that a gene may have or, for a circular gene, the
//! value at the same point.
double within(const Gene& gene, double value);

//! Returns the signed distance from a to b, along the shorter arc for a
//! circular gene.
double difference(const Gene& gene, double a, double b);

//! The distance from a bound, over the range of a gene, within which a value is
//! at the bound. Searches by CMA-ES approach a bound smoothly within this
//! distance, so that a gene that wants to leave its range ends there.
inline constexpr double beside_bound = 0.05;

enum class Bound { lower, upper };

//! Returns the name of a bound, for example "lower".
const char* name_of(Bound bound);

//! Returns the bound at which a value is. A circular gene has no bounds, nor
//! has a gene that is not free or has no range.
std::optional<Bound> bound_at(const Gene& gene, double value);

//! The number that stands for no parent, in the first generation.
inline constexpr std::int64_t no_parent = -1;

//! The way in which a genome was made. The numbers are part of the file format.
enum class Origin : std::uint8_t {
    none = 0,
    baseline = 1,
    random = 2,
    elite = 3,  //!< parent that is evaluated again under new random numbers
    child = 4,
    sample = 5,  //!< draw from a distribution that the search adapts
};

//! Returns the name of an origin, for example "baseline".
const char* name_of(Origin origin);

//! A genome and its descent.
struct Candidate {
    Genome genome;
    Origin origin = Origin::none;
    //! The rows of the parents, counted through all generations, or no_parent.
    std::array<std::int64_t, 2> parents{no_parent, no_parent};

    bool operator==(const Candidate&) const = default;
};

//! An evaluated candidate.
struct Individual {
    Candidate candidate;
    Status status = Status::failed;
    std::vector<Estimate> objectives;  //!< objectives, which may be negative
    double violation = 0;  //!< violation of constraints; 0 if all are met
    //! Each objective by randomisation [objective, randomisation], if known.
    std::vector<double> randomisations{};
    std::vector<double> features{};  //!< features by axis of an atlas
};

//! The individuals of one generation, by slot.
using Population = std::vector<Individual>;

}  // namespace ideotype
