// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gene.hpp"
#include "outcome.hpp"

namespace ideotype {

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
