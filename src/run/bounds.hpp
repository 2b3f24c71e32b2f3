// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "search/population.hpp"

namespace ideotype {

//! A gene with a value at one of its bounds.
struct GeneAtBound {
    std::string gene;
    Bound bound;
    double value = 0;
    double limit = 0;  //!< value of the bound
};

//! Returns the genes of a plant that are at a bound.
std::vector<GeneAtBound> genes_at_bounds(const GeneSpace& genes,
                                         const Genome& plant);

//! Counts how often the traits of the best plants of searches are at a bound.
struct BoundCount {
    struct Trait {
        std::string name;
        int values = 0;  //!< free genes of the trait in all searches
        int at_lower = 0, at_upper = 0;
    };
    int searches = 0;
    std::vector<Trait> traits;  //!< traits with bounds, in the order of genes

    //! Adds the best plant of one search.
    void add(const GeneSpace& genes, const Genome& best);
    void add(const BoundCount& others);

    //! Returns a clause about the traits that are at a bound in at least a
    //! fifth of their values, over all searches; "" if there are none.
    std::string in_words() const;
};

std::string to_text(const BoundCount& count);
BoundCount bound_count_of(const std::string& text);

}  // namespace ideotype
