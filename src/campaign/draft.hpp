#pragma once

#include <string>
#include <vector>

#include "ideotype/campaign/campaign.hpp"

namespace ideotype {

//! One leaf as a plant file gives it.
struct LeafEntry {
    LeafTraits traits;
    LeafForm form;
};

//! The bounds as written: a rule by name or, if that is empty, one table for
//! all leaves.
struct BoundsEntry {
    std::string rule = "paper";
    LeafBounds table;
};

//! A campaign while it is read: defaults first, then what the file says.
struct Draft {
    //! Fills in the defaults that the structures themselves don't have.
    Draft();

    // Problems are located by the addresses of these members.
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;

    Campaign campaign;
    std::vector<LeafEntry> leaves;  //!< lowest first
    BoundsEntry bounds;
};

//! The bounds of a leaf with these baseline traits.
LeafBounds leaf_bounds(const BoundsEntry& bounds, const LeafTraits& traits);

}  // namespace ideotype
