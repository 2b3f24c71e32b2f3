// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "campaign/problems.hpp"
#include "ideotype/crop/measures.hpp"
#include "ideotype/crop/plant.hpp"

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
    //! Names of all plants of the table; none without a column that has them.
    std::vector<std::string> plants;
    std::string plant;  //!< name of the plant of the rows, if it has one
};

//! Reads the leaves of one plant of a table and reports all problems of these.
//! @param plant name of the plant; empty: the only one of the table
LeafTable read_leaf_table(const std::string& text, const std::string& file,
                          const std::string& plant, const Problems& problems);

//! A text and its place in a file.
struct Written {
    std::string text;
    Location where;
};

//! Returns the value of a line "# NAME: VALUE" of a table, if there is one.
std::optional<Written> note_of(const std::string& text, const std::string& file,
                               const std::string& name);

//! A column of a table of leaves; its measure is (zero + sign x) / per_unit.
struct LeafColumn {
    const char* name;
    double Leaf::*value;
    double per_unit = 1;
    double sign = 1;
    double zero = 0;
    bool is_from_north = false;
    //! The height from which the measure follows, if the number is a height.
    LeafHeight height = LeafHeight::none;
};

// Angles as in exported plants come first among columns of their measure.
inline constexpr LeafColumn leaf_columns[]{
    {"length_cm", &Leaf::length, 100},
    {"length_m", &Leaf::length},
    {"length_mm", &Leaf::length, 1000},
    {"width_cm", &Leaf::width, 100},
    {"width_m", &Leaf::width},
    {"width_mm", &Leaf::width, 1000},
    {"insertion_angle_deg", &Leaf::insertion_angle},
    {"insertion_angle_from_vertical_deg", &Leaf::insertion_angle},
    {"insertion_angle_from_horizontal_deg", &Leaf::insertion_angle, 1, -1, 90},
    {"curvature_deg", &Leaf::curvature},
    {"tip_height_cm", &Leaf::curvature, 100, 1, 0, false, LeafHeight::tip},
    {"tip_height_m", &Leaf::curvature, 1, 1, 0, false, LeafHeight::tip},
    {"tip_height_mm", &Leaf::curvature, 1000, 1, 0, false, LeafHeight::tip},
    {"top_height_cm", &Leaf::curvature, 100, 1, 0, false, LeafHeight::top},
    {"top_height_m", &Leaf::curvature, 1, 1, 0, false, LeafHeight::top},
    {"top_height_mm", &Leaf::curvature, 1000, 1, 0, false, LeafHeight::top},
    {"azimuth_deg", &Leaf::azimuth},
    {"azimuth_from_row_clockwise_deg", &Leaf::azimuth},
    {"azimuth_from_row_counterclockwise_deg", &Leaf::azimuth, 1, -1},
    {"azimuth_from_north_deg", &Leaf::azimuth, 1, 1, 0, true},
    {"insertion_height_cm", &Leaf::insertion_height, 100},
    {"insertion_height_m", &Leaf::insertion_height},
    {"insertion_height_mm", &Leaf::insertion_height, 1000},
    {"roll_deg", &Leaf::roll},
    {"twist_deg", &Leaf::twist},
    {"petiole_length_cm", &Leaf::petiole_length, 100},
    {"petiole_length_m", &Leaf::petiole_length},
    {"petiole_length_mm", &Leaf::petiole_length, 1000},
    {"petiole_angle_deg", &Leaf::petiole_angle},
    {"internode_cm", &Leaf::internode, 100},
    {"internode_m", &Leaf::internode},
    {"internode_mm", &Leaf::internode, 1000},
};
inline constexpr auto rank_column = "leaf";
//! Names of the column that names the plant of each leaf.
inline constexpr const char* plant_columns[]{"plant", "line"};

//! Returns the place of a measure in leaf_measures.
inline std::size_t index_of(double Leaf::*value) {
    return static_cast<std::size_t>(
        std::ranges::find(leaf_measures, value, &Measure<Leaf>::value) -
        leaf_measures.begin());
}

//! Returns whether a file is a table of measured leaves by its name.
bool is_measured(const std::string& path);

//! Reads a table of measured leaves, one leaf per line, into a plant. Measures
//! without a column stay if the numbers of leaves are equal; all other parts of
//! the plant stay. The stalk grows by as much as the highest insertion rises,
//! and organs at a leaf keep their rank counted from the highest leaf.
//! @param chosen name of one of several plants of the table, or empty
//! @param is_crop_known false: the plant could not be read
void read_measured_plant(const std::string& text, const std::string& file,
                         const std::string& chosen, bool is_crop_known,
                         Plant& plant, const Problems& problems);

}  // namespace ideotype
