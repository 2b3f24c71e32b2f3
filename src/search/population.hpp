// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "genome.hpp"
#include "outcome.hpp"

namespace ideotype {

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
