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

//! The numbers that define a plant: one for each gene of a GeneSpace, in the
//! gene's unit.
using Genome = std::vector<double>;

//! A trait value that the search may vary, and its range.
struct Gene {
    std::string name;  //!< name, for example "leaf03_length"
    std::string unit;  //!< unit, "m" or "deg"
    double lower = 0;
    double upper = 0;
    bool is_circular = false;  //!< whether upper means the same as lower
    bool is_free = true;       //!< otherwise the gene keeps the baseline value
    std::string trait{};       //!< trait, for example "length"
    int leaf = 0;  //!< rank from the lowest, 1; 0 for the whole plant
};

using GeneSpace = std::vector<Gene>;

//! Returns the number of free genes.
std::size_t count_free(const GeneSpace& genes);

//! Maps a value of a circular gene to [lower, upper).
double wrapped(const Gene& gene, double value);

//! Clamps a value to the range of a gene or, for a circular gene, maps it to
//! [lower, upper).
double within(const Gene& gene, double value);

//! Returns the signed distance from a to b, along the shorter arc for a
//! circular gene.
double difference(const Gene& gene, double a, double b);

//! Distance from a bound, relative to the range of a gene, within which a value
//! counts as at the bound. Searches by CMA-ES approach a bound smoothly within
//! this distance; here they end if a gene is pushed beyond its range.
inline constexpr double bound_margin = 0.05;

enum class Bound { lower, upper };

//! Returns the name of a bound, for example "lower".
const char* name_of(Bound bound);

//! Returns the bound that a value has reached, if any. Genes that are circular,
//! not free or without range have no bounds.
std::optional<Bound> find_bound(const Gene& gene, double value);

//! The row number that means "no parent", as in the first generation.
inline constexpr std::int64_t no_parent = -1;

//! The way in which a genome was made. The values are stored in files.
enum class Origin : std::uint8_t {
    none = 0,
    baseline = 1,
    random = 2,
    elite = 3,  //!< parent re-evaluated with new random numbers
    child = 4,
    sample = 5,  //!< draw from a distribution that the search adapts
};

//! Returns the name of an origin, for example "baseline".
const char* name_of(Origin origin);

//! A genome and its parents.
struct Candidate {
    Genome genome;
    Origin origin = Origin::none;
    //! Rows of the parents, numbered through all generations, or no_parent.
    std::array<std::int64_t, 2> parents{no_parent, no_parent};

    bool operator==(const Candidate&) const = default;
};

//! An evaluated candidate.
struct Individual {
    Candidate candidate;
    Status status = Status::failed;
    std::vector<Estimate> objectives;  //!< objectives, which may be negative
    double violation = 0;  //!< violation of constraints; 0 if all are met
    //! Values of each objective by randomisation [objective, randomisation], if
    //! known.
    std::vector<double> randomisations{};
    std::vector<double> features{};  //!< features by axis of an atlas
};

//! The individuals of one generation, by slot.
using Population = std::vector<Individual>;

}  // namespace ideotype
