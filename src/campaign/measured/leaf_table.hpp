// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "campaign/problems.hpp"
#include "ideotype/crop/measures.hpp"

namespace ideotype {

//! A height above the soil that tells how much a leaf bends: of its tip, or of
//! its highest point.
enum class LeafHeight { none, tip, top };

//! The leaf of one line.
struct LeafRow {
    Location where;
    int rank = 0;
    Leaf leaf;
    //! The places of the measures in their order; line 0: not told.
    std::array<Location, leaf_measures.size()> places;
    LeafHeight of_height = LeafHeight::none;
    double height = 0;  //!< that is told in the place of the curvature [m]
};

//! A table of measured leaves.
struct LeafTable {
    Location header;
    std::vector<LeafRow> rows;  //!< the lowest leaf first
    //! Whether there is a column of each measure, or one that may be it.
    std::array<bool, leaf_measures.size()> has{};
};

//! Reads a table and reports all that is wrong with it.
LeafTable read_leaf_table(const std::string& text, const std::string& file,
                          const Problems& problems);

//! A text and where it is written.
struct Written {
    std::string text;
    Location where;
};

//! Returns the value of a line "# NAME: VALUE" of a table, if there is one.
std::optional<Written> note_of(const std::string& text, const std::string& file,
                               const std::string& name);

}  // namespace ideotype
