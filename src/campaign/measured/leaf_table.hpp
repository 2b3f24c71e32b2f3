// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "campaign/problems.hpp"
#include "ideotype/crop/measures.hpp"

namespace ideotype {

//! A height above the soil from which the bending of a leaf follows: the height
//! of its tip, or of its highest point.
enum class LeafHeight { none, tip, top };

//! One leaf, from one line of a table.
struct LeafRow {
    Location where;
    int rank = 0;
    Leaf leaf;
    //! Places of the measures in the file, in their order; line 0: not given.
    std::array<Location, leaf_measures.size()> places;
    LeafHeight of_height = LeafHeight::none;
    double height = 0;  //!< height instead of the curvature [m]
};

//! A table of measured leaves.
struct LeafTable {
    Location header;
    std::vector<LeafRow> rows;  //!< rows of the table, lowest leaf first
    //! Whether some column has each measure, or may have it.
    std::array<bool, leaf_measures.size()> has{};
};

//! Reads a table of measured leaves and reports all its problems.
LeafTable read_leaf_table(const std::string& text, const std::string& file,
                          const Problems& problems);

//! A text and its place in a file.
struct Written {
    std::string text;
    Location where;
};

//! Returns the value of a line "# NAME: VALUE" of a table, if there is one.
std::optional<Written> note_of(const std::string& text, const std::string& file,
                               const std::string& name);

}  // namespace ideotype
